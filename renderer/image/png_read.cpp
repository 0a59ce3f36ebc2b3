// decodePng: through stb_image, of small pictures only.
#include <stb/stb_image.h>

#include <memory>

#include "renderer/image/png.h"

namespace pileus::image {

Result<Bitmap> decodePng(std::string_view file) {
  constexpr int kLongestSide = 4096;
  if (file.size() > (std::size_t(1) << 27)) return fail(Code::Input, "the picture is too large");
  const auto* bytes = reinterpret_cast<const stbi_uc*>(file.data());
  const int length = static_cast<int>(file.size());
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(bytes, length, &width, &height, &channels))
    return fail(Code::Input, "not a readable PNG");
  if (width < 1 || height < 1 || width > kLongestSide || height > kLongestSide)
    return fail(Code::Input, "a picture of {} x {} pixels is too large", width, height);
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(bytes, length, &width, &height, &channels, 4), stbi_image_free);
  if (!pixels) return fail(Code::Input, "the PNG is damaged");
  Bitmap out{{width, height}, {}};
  out.rgba.assign(pixels.get(), pixels.get() + std::size_t(width) * std::size_t(height) * 4);
  return out;
}

}  // namespace pileus::image
