#include "editor/document/graph_pictures.h"

#include <algorithm>

#include "embedded_thumbnails.h"
#include "renderer/base/file.h"
#include "renderer/image/png.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

constexpr int kLongest = 512;
constexpr std::size_t kMostOwn = 96;  // pictures of presets on the GPU; more than a window can show

}  // namespace

fs::path thumbnailPath(const fs::path& graph) {
  std::error_code ec;
  const std::string name = fs::absolute(graph, ec).lexically_normal().string();
  return cacheFolder() / "thumbnails" / (Hasher().add(name).key().hex() + ".png");
}

SmallPicture reducedPicture(ivec2 size, const std::vector<unsigned char>& rgba, int longest) {
  SmallPicture out;
  if (size.x < 1 || size.y < 1 || rgba.size() < std::size_t(size.x) * std::size_t(size.y) * 4) return out;
  const double scale = std::min(1.0, double(longest) / std::max(size.x, size.y));
  out.size = glm::max(ivec2(glm::round(dvec2(size) * scale)), ivec2(1));
  out.rgba.reserve(std::size_t(out.size.x) * std::size_t(out.size.y) * 4);
  for (int y = 0; y < out.size.y; ++y)
    for (int x = 0; x < out.size.x; ++x) {
      const ivec2 lo(x * size.x / out.size.x, y * size.y / out.size.y);
      const ivec2 hi = glm::max(lo + 1, ivec2((x + 1) * size.x / out.size.x, (y + 1) * size.y / out.size.y));
      int sum[3] = {0, 0, 0};
      for (int v = lo.y; v < hi.y; ++v)
        for (int u = lo.x; u < hi.x; ++u)
          for (std::size_t c = 0; c < 3; ++c)
            sum[c] += rgba[(std::size_t(v) * std::size_t(size.x) + std::size_t(u)) * 4 + c];
      const auto count = static_cast<float>((hi.x - lo.x) * (hi.y - lo.y)) * 255.0f;
      for (const int s : sum) out.rgba.push_back(static_cast<float>(s) / count);
      out.rgba.push_back(1.0f);
    }
  return out;
}

GraphPictures::Shown GraphPictures::load(std::map<std::string, Entry>& in, const std::string& key,
                                         std::string_view bytes) {
  Entry& entry = in[key];  // also where it cannot be read: once is enough
  loaded_ = true;
  const Result<image::Bitmap> bitmap = image::decodePng(bytes);
  if (!bitmap) return {};
  auto texture = gl::Texture::create(GL_TEXTURE_2D, GL_RGBA8, {bitmap->size, 1}, "thumbnail");
  if (!texture) return {};
  entry.texture = std::move(*texture);
  glTextureSubImage2D(entry.texture.id(), 0, 0, 0, bitmap->size.x, bitmap->size.y, GL_RGBA, GL_UNSIGNED_BYTE,
                      bitmap->rgba.data());
  entry.texture.filter(GL_LINEAR);
  entry.texture.wrap(GL_CLAMP_TO_EDGE);
  entry.size = bitmap->size;
  return {entry.texture.id(), entry.size};
}

GraphPictures::Shown GraphPictures::preset(std::string_view name) {
  const std::string key(name);
  if (const auto it = presets_.find(key); it != presets_.end())
    return {it->second.texture.id(), it->second.size};
  if (loaded_) return {};
  const std::string png = fs::path(key).stem().string() + ".png";
  for (const EmbeddedFile& file : embedded_thumbnails())
    if (file.path == png) return load(presets_, key, file.bytes);
  presets_[key];
  return {};
}

GraphPictures::Shown GraphPictures::file(const fs::path& graph) {
  const std::string key = graph.string();
  if (const auto it = files_.find(key); it != files_.end()) return {it->second.texture.id(), it->second.size};
  if (loaded_ || (writing_ && !writing_->done())) return {};
  const Result<std::string> bytes = readFile(thumbnailPath(graph), std::size_t(8) << 20);
  return load(files_, key, bytes ? std::string_view(*bytes) : std::string_view());
}

GraphPictures::Shown GraphPictures::beside(const fs::path& preset, Key stamp) {
  const std::string key = preset.string() + stamp.hex();
  if (const auto it = own_.find(key); it != own_.end()) return {it->second.texture.id(), it->second.size};
  if (loaded_) return {};
  if (own_.size() >= kMostOwn) own_.clear();
  const Result<std::string> bytes =
      readFile(fs::path(preset).replace_extension(".png"), std::size_t(8) << 20);
  return load(own_, key, bytes ? std::string_view(*bytes) : std::string_view());
}

TexturePixels readTexture(unsigned texture) {
  TexturePixels out;
  if (texture == 0) return out;
  glGetTextureLevelParameteriv(texture, 0, GL_TEXTURE_WIDTH, &out.size.x);
  glGetTextureLevelParameteriv(texture, 0, GL_TEXTURE_HEIGHT, &out.size.y);
  if (out.size.x < 1 || out.size.y < 1) return {};
  out.rgba.resize(std::size_t(out.size.x) * std::size_t(out.size.y) * 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(out.rgba.size()),
                    out.rgba.data());
  return out;
}

void GraphPictures::keep(unsigned texture, const fs::path& graph) {
  TexturePixels pixels = readTexture(texture);
  if (pixels.rgba.empty()) return;
  forget(graph);
  writing_ = std::make_unique<Job<bool>>([pixels = std::move(pixels), graph](JobControl&) -> Result<bool> {
    const SmallPicture small = reducedPicture(pixels.size, pixels.rgba, kLongest);
    const fs::path path = thumbnailPath(graph);
    std::error_code ec;
    fs::create_directories(path.parent_path(), ec);
    PILEUS_CHECK(image::writePng(path, small.size, small.rgba.data()));
    return true;
  });
}

}  // namespace pileus::editor
