#include "renderer/residency/scene_table.h"

#include <algorithm>
#include <cstring>

#include "renderer/shaders/shared/bindings.h"

namespace pileus::residency {

void SceneTable::set(Section section, const void* data, std::size_t bytes) {
  Part& part = parts_[std::size_t(section)];
  // Mostly it is what is there: passes set all sections before each dispatch.
  const std::size_t count = (bytes + sizeof(uvec4) - 1) / sizeof(uvec4);
  if (part.bytes == bytes && (bytes == 0 || std::memcmp(part.texels.data(), data, bytes) == 0)) return;
  part.texels.assign(count, uvec4(0));
  if (bytes > 0) std::memcpy(part.texels.data(), data, bytes);
  part.bytes = bytes;
  part.changed = true;
}

Result<void> SceneTable::layOut() {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
  std::size_t all = 0, end = 0;
  for (const Part& part : parts_) all += part.texels.size();
  if (all > std::size_t(limit)) {
    const auto rows = [&](Section section) { return parts_[std::size_t(section)].texels.size(); };
    return fail(Code::Gpu,
                "volumes and lists of a pass take {} texels ({} for volumes, {} for lists of what {} tiles "
                "hold, {} for solids); this OpenGL driver has buffer textures of {}: lower the size of the "
                "picture or map, or the number of volumes",
                all, rows(Section::Volumes) + rows(Section::ShadowItems),
                rows(Section::TileItems) + rows(Section::TileOffsets), 4 * rows(Section::TileOffsets),
                rows(Section::Solids), limit);
  }
  const std::size_t spare = std::size_t(limit) - all;  // lists of the next frame may be longer
  for (Part& part : parts_) {
    part.first = end;
    part.room = part.texels.size() + std::min(part.texels.size() / 4 + 1, spare / kSections);
    part.changed = true;
    end += part.room;
  }
  return buffer_.reserve(end * sizeof(uvec4));
}

Result<void> SceneTable::bind(gl::Program& program) {
  if (std::any_of(parts_.begin(), parts_.end(), [](const Part& p) { return p.texels.size() > p.room; }) ||
      buffer_.capacity() == 0)
    PILEUS_CHECK(layOut());
  for (Part& part : parts_) {
    if (part.changed && !part.texels.empty())
      glNamedBufferSubData(buffer_.id(), GLintptr(part.first * sizeof(uvec4)),
                           GLsizeiptr(part.texels.size() * sizeof(uvec4)), part.texels.data());
    part.changed = false;
  }
  buffer_.bindTexels(UNIT_SCENE, GL_RGBA32UI);
  const auto first = [&](Section section) { return int(parts_[std::size_t(section)].first); };
  program.set("sceneSections", ivec4(first(Section::TileOffsets), first(Section::TileItems),
                                     first(Section::ShadowItems), first(Section::Solids)));
  program.set("sceneAir", first(Section::Air));
  return {};
}

}  // namespace pileus::residency
