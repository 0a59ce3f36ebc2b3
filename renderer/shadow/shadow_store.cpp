#include "renderer/shadow/shadow_store.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "renderer/gl/texture.h"
#include "renderer/shaders/shared/bindings.h"

namespace pileus::shadow {
namespace {

/// A run of layers cut into equal power-of-two cells.
struct Sheet {
  int firstLayer = 0, layers = 0, cellEdge = 0, across = 0;
  std::vector<bool> used;
  bool empty() const { return std::none_of(used.begin(), used.end(), [](bool u) { return u; }); }
};

struct Array {
  gl::Texture texture;
  std::vector<Sheet> sheets;  ///< index is stable; layers == 0: unused entry
};

constexpr GLenum kFormats[] = {GL_RGBA32F, GL_RGBA16F, GL_RGBA16};
constexpr const char* kLabels[] = {"shadow store float", "shadow store half", "shadow store unorm"};

}  // namespace

struct ShadowStoreState {
  gl::DeviceInfo device;
  std::size_t budget = 0;
  Array arrays[3];

  /// First layer of a free run, or the layer after the last used one.
  static int freeRun(const Array& a, int layers, int depth) {
    std::vector<bool> taken(std::size_t(std::max(depth, 0)), false);
    int end = 0;
    for (const Sheet& s : a.sheets)
      for (int l = 0; l < s.layers; ++l) {
        taken[std::size_t(s.firstLayer + l)] = true;
        end = std::max(end, s.firstLayer + l + 1);
      }
    for (int first = 0, run = 0, l = 0; l < depth; ++l) {
      run = taken[std::size_t(l)] ? 0 : run + 1;
      if (run == 0) first = l + 1;
      if (run == layers) return first;
    }
    return end;
  }

  Result<void> grow(int kind, int edge, int depth) {
    Array& a = arrays[kind];
    const ivec3 old = a.texture ? a.texture.size() : ivec3(0);
    const ivec3 size(std::max(edge, old.x), std::max(edge, old.y), std::max(depth, old.z));
    if (size == old) return {};
    const std::size_t bytes = gl::texelBytes(kFormats[kind]) * std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    std::size_t others = 0;
    for (int k = 0; k < 3; ++k)
      if (k != kind) others += arrays[k].texture.bytes();
    if (size.x > device.maxTextureSize || size.z > device.maxArrayLayers || bytes + others > budget)
      return fail(Code::Gpu, "shadow maps would need {} MiB ({} x {} texels, {} layers); {} MiB are set aside for them", (bytes + others) >> 20, size.x, size.y, size.z,
                  budget >> 20);
    while (glGetError() != GL_NO_ERROR) {
    }
    gl::Texture grown(GL_TEXTURE_2D_ARRAY, kFormats[kind], size, kLabels[kind]);
    grown.filter(GL_LINEAR);
    if (glGetError() == GL_OUT_OF_MEMORY) return fail(Code::Gpu, "out of GPU memory: {} MiB for shadow maps", bytes >> 20);
    if (a.texture) glCopyImageSubData(a.texture.id(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, grown.id(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, old.x, old.y, old.z);
    a.texture = std::move(grown);
    return {};
  }
};

ShadowBlock::ShadowBlock(std::shared_ptr<ShadowStoreState> store, Texels texels, int resolution, int layers, int sheet, int cell)
    : store_(std::move(store)), texels_(texels), resolution_(resolution), layers_(layers), sheet_(sheet), cell_(cell) {}

ShadowBlock::~ShadowBlock() {
  Sheet& s = store_->arrays[int(texels_)].sheets[std::size_t(sheet_)];
  s.used[std::size_t(cell_)] = false;
  if (s.empty()) s = Sheet{};
}

std::size_t ShadowBlock::bytes() const { return gl::texelBytes(format()) * std::size_t(resolution_) * std::size_t(resolution_) * std::size_t(layers_); }

gpu::BlockRecord ShadowBlock::record() const {
  const Sheet& s = store_->arrays[int(texels_)].sheets[std::size_t(sheet_)];
  return {ivec4((cell_ % s.across) * s.cellEdge, (cell_ / s.across) * s.cellEdge, resolution_, s.firstLayer), ivec4(int(texels_), layers_, 0, 0)};
}

GLuint ShadowBlock::texture() const { return store_->arrays[int(texels_)].texture.id(); }
GLenum ShadowBlock::format() const { return kFormats[int(texels_)]; }

ShadowStore::ShadowStore(const gl::DeviceInfo& device, std::size_t budgetBytes) : state_(std::make_shared<ShadowStoreState>()) {
  state_->device = device;
  state_->budget = budgetBytes;
}

Result<std::shared_ptr<const ShadowBlock>> ShadowStore::allocate(Texels texels, int resolution, int layers) {
  Array& a = state_->arrays[int(texels)];
  const int edge = int(std::bit_ceil(unsigned(std::max(resolution, 16))));
  const auto take = [&](std::size_t sheet, std::size_t cell) {
    a.sheets[sheet].used[cell] = true;
    return std::make_shared<const ShadowBlock>(state_, texels, resolution, layers, int(sheet), int(cell));
  };
  for (std::size_t i = 0; i < a.sheets.size(); ++i) {
    const Sheet& s = a.sheets[i];
    if (s.layers != layers || s.cellEdge != edge) continue;
    for (std::size_t c = 0; c < s.used.size(); ++c)
      if (!s.used[c]) return take(i, c);
  }
  const int depth = a.texture ? a.texture.size().z : 0;
  const int first = ShadowStoreState::freeRun(a, layers, depth);
  PILEUS_CHECK(state_->grow(int(texels), edge, first + layers));
  const int across = a.texture.size().x / edge;
  std::size_t index = 0;
  while (index < a.sheets.size() && a.sheets[index].layers != 0) ++index;
  if (index == a.sheets.size()) a.sheets.emplace_back();
  a.sheets[index] = {first, layers, edge, across, std::vector<bool>(std::size_t(across) * std::size_t(across), false)};
  return take(index, 0);
}

void ShadowStore::bind() const {
  glBindTextureUnit(UNIT_SHADOW_FLOAT, state_->arrays[0].texture.id());
  glBindTextureUnit(UNIT_SHADOW_HALF, state_->arrays[1].texture.id());
  glBindTextureUnit(UNIT_SHADOW_UNORM, state_->arrays[2].texture.id());
}

std::size_t ShadowStore::bytes() const {
  std::size_t sum = 0;
  for (const Array& a : state_->arrays) sum += a.texture.bytes();
  return sum;
}

}  // namespace pileus::shadow
