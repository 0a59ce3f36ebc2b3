#include "renderer/image/png.h"

#include <stb/stb_image_write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "renderer/base/file.h"

namespace pileus::image {
namespace {

/// Thresholds in (0, 1) of the 8 x 8 Bayer matrix: bit pairs of (x ^ y, y), least significant first.
constexpr std::array<float, 64> makeBayer() {
  std::array<float, 64> out{};
  for (unsigned y = 0; y < 8; ++y)
    for (unsigned x = 0; x < 8; ++x) {
      unsigned rank = 0;
      for (unsigned bit = 0; bit < 3; ++bit) rank = rank * 4 + (((x ^ y) >> bit & 1u) * 2 + (y >> bit & 1u));
      out[y * 8 + x] = (static_cast<float>(rank) + 0.5f) / 64.0f;
    }
  return out;
}
constexpr auto kBayer = makeBayer();

void append(void* context, void* data, int size) {
  static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

}  // namespace

Result<std::string> encodePng(ivec2 size, const float* rgba) {
  // 8-bit rows are addressed with int by stb.
  if (size.x < 1 || size.y < 1 || std::int64_t(size.x) * size.y > (std::int64_t(1) << 28))
    return fail(Code::Arguments, "a picture of {} x {} pixels cannot be written", size.x, size.y);
  const std::size_t width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y);
  std::vector<unsigned char> bytes(width * height * 3);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t pixel = y * width + x;
      const float threshold = kBayer[(y & 7) * 8 + (x & 7)];
      for (std::size_t c = 0; c < 3; ++c) {
        const float value = rgba[pixel * 4 + c];
        const float shown = value > 0.0f ? std::min(value, 1.0f) : 0.0f;  // a NaN is black
        bytes[pixel * 3 + c] =
            static_cast<unsigned char>(std::min(std::floor(shown * 255.0f + threshold), 255.0f));
      }
    }
  std::string file;
  if (!stbi_write_png_to_func(append, &file, size.x, size.y, 3, bytes.data(), size.x * 3))
    return fail(Code::Internal, "the picture could not be encoded as PNG");
  return file;
}

Result<void> writePng(const std::filesystem::path& path, ivec2 size, const float* rgba) {
  const Result<std::string> file = encodePng(size, rgba);
  if (!file) return fail(file.error().code, "{}: {}", path.string(), file.error().message);
  return writeFileAtomic(path, *file);
}

}  // namespace pileus::image
