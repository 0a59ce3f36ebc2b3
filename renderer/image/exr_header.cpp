#include "renderer/image/exr_header.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTileDescription.h>

#include <algorithm>
#include <cmath>

#include "renderer/image/exr_limits.h"
#include "renderer/image/reason.h"

namespace fs = std::filesystem;

namespace pileus::image {
namespace {

constexpr std::int64_t kMostPixels = std::int64_t(1) << 28;
constexpr std::int64_t kMostSamples = std::int64_t(1) << 30;
constexpr std::int64_t kLargestTile = std::int64_t(1)
                                      << 28;  // bytes; whole tiles are held, however small the picture
constexpr std::int64_t kSmallPicture = std::int64_t(1) << 22;  // bytes; not worth a closer look

int linesPerChunk(Imf::Compression compression) {
  switch (compression) {
    case Imf::ZIP_COMPRESSION:
    case Imf::PXR24_COMPRESSION:
      return 16;
    case Imf::PIZ_COMPRESSION:
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
    case Imf::DWAA_COMPRESSION:
      return 32;
    case Imf::DWAB_COMPRESSION:
      return 256;
    default:
      return 1;
  }
}

}  // namespace

Result<void> checkExrSizes(const Imf::Header& header, std::int64_t fileBytes) {
  const Imath::Box2i &data = header.dataWindow(), &display = header.displayWindow();
  const auto extent = [](int lo, int hi) { return std::int64_t(hi) - std::int64_t(lo) + 1; };
  const std::int64_t width = extent(data.min.x, data.max.x), height = extent(data.min.y, data.max.y);
  if (width < 1 || height < 1) return fail(Code::Input, "its data window is empty");
  if (width > kLongestSide || height > kLongestSide || width * height > kMostPixels)
    return fail(Code::Input, "{} x {} pixels are more than can be read ({} million)", width, height,
                kMostPixels >> 20);
  for (const auto& [lo, hi] :
       {std::pair(display.min.x, display.max.x), std::pair(display.min.y, display.max.y)})
    if (extent(lo, hi) < 1 || extent(lo, hi) > kLongestSide)
      return fail(Code::Input, "its display window is damaged");
  for (int axis = 0; axis < 2; ++axis)
    if (std::abs(std::int64_t(data.min[axis]) - display.min[axis]) > kLongestSide)
      return fail(Code::Input, "its data window lies absurdly far from its display window");

  std::int64_t samples = 0, bytesPerPixel = 0;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
    samples += width * height;
    bytesPerPixel += it.channel().type == Imf::HALF ? 2 : 4;
    if (samples > kMostSamples)
      return fail(Code::Input, "its {} x {} pixels have too many channels to be read", width, height);
  }
  std::int64_t chunks = 0, chunkHeader = 8;  // beside 8 bytes in the table
  if (header.hasTileDescription()) {
    const std::int64_t tileX = header.tileDescription().xSize, tileY = header.tileDescription().ySize;
    if (tileX < 1 || tileY < 1 || tileX > kLongestTileSide || tileY > kLongestTileSide ||
        tileX * tileY * bytesPerPixel > kLargestTile)
      return fail(Code::Input, "tiles of {} x {} pixels are more than can be read", tileX, tileY);
    chunks = ((width + tileX - 1) / tileX) * ((height + tileY - 1) / tileY);
    chunkHeader = 20;
  } else {
    const int lines = linesPerChunk(header.compression());
    chunks = (height + lines - 1) / lines;
  }
  if (chunks * (8 + chunkHeader) > fileBytes ||
      width * height * bytesPerPixel >
          std::max(kSmallPicture, fileBytes * largestRatio(header.compression())))
    return fail(Code::Input,
                "the file is too short ({} bytes) for its {} x {} pixels; it is cut off or damaged",
                fileBytes, width, height);
  return {};
}

Chromaticities readChromaticities(const Imf::Header& header) {
  const Imf::Chromaticities c =
      Imf::hasChromaticities(header) ? Imf::chromaticities(header) : Imf::Chromaticities();
  const Chromaticities out{
      {c.red.x, c.red.y}, {c.green.x, c.green.y}, {c.blue.x, c.blue.y}, {c.white.x, c.white.y}};
  for (const vec2& v : {out.red, out.green, out.blue, out.white})
    if (!std::isfinite(v.x) || !std::isfinite(v.y))
      return {{0.64f, 0.33f}, {0.30f, 0.60f}, {0.15f, 0.06f}, {0.3127f, 0.3290f}};
  return out;
}

std::string reasonWithoutPath(std::string_view reason, const fs::path& path) {
  const std::string named = fmt::format("\"{}\". ", path.string());
  if (const std::size_t at = reason.find(named); at != std::string_view::npos)
    reason.remove_prefix(at + named.size());
  if (!reason.empty() && reason.back() == '.') reason.remove_suffix(1);
  return clampReason(reason);
}

Result<std::int64_t> openableExr(const fs::path& path) {
  std::error_code ec;
  const auto status = fs::status(path, ec);
  if (!fs::exists(status)) return fail(Code::Input, "{}: there is no such file", path.string());
  if (!fs::is_regular_file(status)) return fail(Code::Input, "{}: is not a file", path.string());
  const auto bytes = static_cast<std::int64_t>(fs::file_size(path, ec));
  if (ec) return fail(Code::Input, "{}: cannot be read ({})", path.string(), ec.message());
  limitHeaders();
  return bytes;
}

}  // namespace pileus::image
