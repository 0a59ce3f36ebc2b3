// decodeHdr: Radiance's pictures, RGBE in runs (G. Ward: Real pixels. Graphics Gems II, 1991; the file format
// is that of ray/doc/filefmts). stb_image reads them too, but has no end of file: it fills what is cut off,
// and never returns from some files.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "renderer/image/environment_file.h"
#include "renderer/image/reason.h"

namespace pileus::image {
namespace {

using Bytes = std::basic_string_view<unsigned char>;

/// The next line, without its end; nothing at the end of the file or beyond 4 KiB.
std::optional<std::string_view> takeLine(std::string_view& file) {
  const std::size_t end = file.substr(0, 4096).find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  std::string_view line = file.substr(0, end);
  file.remove_prefix(end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

struct Header {
  ivec2 size{0};
  double exposure = 1;  ///< what radiance was multiplied by
};

Result<Header> takeHeader(std::string_view& file) {
  constexpr int kMostLines = 1000;
  Header out;
  const auto first = takeLine(file);
  if (!first || (!first->starts_with("#?")))
    return fail(Code::Input, "it is neither an OpenEXR nor a Radiance picture");
  for (int i = 0;; ++i) {
    const auto line = takeLine(file);
    if (!line || i > kMostLines) return fail(Code::Input, "its header has no end; it is cut off or damaged");
    if (line->empty()) break;
    if (line->starts_with("FORMAT=")) {
      if (line->substr(7) == "32-bit_rle_xyze")
        return fail(Code::Input, "it holds XYZ, not RGB (32-bit_rle_xyze); save it as 32-bit_rle_rgbe");
      if (line->substr(7) != "32-bit_rle_rgbe")
        return fail(Code::Input, "its format '{}' is not 32-bit_rle_rgbe", clampReason(line->substr(7)));
    } else if (line->starts_with("EXPOSURE=")) {
      const double e = std::strtod(std::string(line->substr(9)).c_str(), nullptr);
      if (std::isfinite(e) && e > 0) out.exposure *= e;
    }
  }
  const auto line = takeLine(file);
  if (!line) return fail(Code::Input, "it is cut off before its pixels");
  const std::string text(*line);
  char a = 0, b = 0, signA = 0, signB = 0;
  if (std::sscanf(text.c_str(), "%c%c %9d %c%c %9d", &signA, &a, &out.size.y, &signB, &b, &out.size.x) != 6)
    return fail(Code::Input, "its line of sizes ('{}') is damaged", clampReason(text));
  if (signA != '-' || a != 'Y' || signB != '+' || b != 'X')
    return fail(Code::Input, "its pixels are turned or mirrored ('{}'); save it as -Y +X", clampReason(text));
  if (out.size.x < 1 || out.size.y < 1) return fail(Code::Input, "it has no pixels ({})", clampReason(text));
  if (out.size.x > kLargestEnvironmentFile.x || out.size.y > kLargestEnvironmentFile.y ||
      std::int64_t(out.size.x) * out.size.y > kMostEnvironmentPixels)
    return fail(Code::Input, "{} x {} pixels are more than can be read ({} million)", out.size.x, out.size.y,
                kMostEnvironmentPixels >> 20);
  return out;
}

/// One row of four bytes a pixel. False: the file ends or a run is longer than the row.
bool takeRow(Bytes& file, std::vector<unsigned char>& row) {
  const std::size_t width = row.size() / 4;
  if (width >= 8 && width < 32768 && file.size() >= 4 && file[0] == 2 && file[1] == 2 && file[2] < 128) {
    if (std::size_t(file[2]) * 256 + file[3] != width) return false;
    file.remove_prefix(4);
    for (std::size_t c = 0; c < 4; ++c)  // the four planes one after the other
      for (std::size_t x = 0; x < width;) {
        if (file.size() < 2) return false;
        const bool run = file[0] > 128;
        const std::size_t count = run ? file[0] - 128u : file[0];
        if (count == 0 || count > width - x || (!run && file.size() < 1 + count)) return false;
        for (std::size_t i = 0; i < count; ++i) row[4 * (x + i) + c] = file[run ? 1 : 1 + i];
        file.remove_prefix(run ? 2 : 1 + count);
        x += count;
      }
    return true;
  }
  // Pixels as they are; 1 1 1 n repeats the one before n times, a second one in a row 256 n times, ..
  int shift = 0;
  for (std::size_t x = 0; x < width;) {
    if (file.size() < 4) return false;
    if (file[0] == 1 && file[1] == 1 && file[2] == 1) {
      if (x == 0 || shift > 16) return false;
      const std::size_t count = std::size_t(file[3]) << shift;
      if (count > width - x) return false;
      for (std::size_t i = 0; i < 4 * count; ++i) row[4 * x + i] = row[4 * x + i - 4];
      x += count;
      shift += 8;
    } else {
      std::copy_n(file.begin(), 4, row.begin() + std::ptrdiff_t(4 * x));
      ++x;
      shift = 0;
    }
    file.remove_prefix(4);
  }
  return true;
}

}  // namespace

Result<EnvironmentFile> decodeHdr(std::string_view file) {
  PILEUS_TRY(const Header header, takeHeader(file));
  // The shortest rows: runs of 127 in two bytes for each of four planes, or one pixel and long repeats.
  const std::int64_t shortest = header.size.x < 8 ? 4 : std::min<std::int64_t>(8, 4 * header.size.x);
  if (std::int64_t(file.size()) < shortest * header.size.y)
    return fail(Code::Input, "the file is too short for its {} x {} pixels; it is cut off or damaged",
                header.size.x, header.size.y);
  EnvironmentFile out;
  out.map.size = header.size;
  out.map.radiance.reserve(std::size_t(header.size.x) * std::size_t(header.size.y));
  Bytes bytes(reinterpret_cast<const unsigned char*>(file.data()), file.size());
  std::vector<unsigned char> row(std::size_t(header.size.x) * 4);
  for (int y = 0; y < header.size.y; ++y) {
    if (!takeRow(bytes, row))
      return fail(Code::Input, "row {} of {} is cut off or damaged", y + 1, header.size.y);
    for (std::size_t i = 0; i < row.size(); i += 4) {
      const double scale = row[i + 3] ? std::ldexp(1.0 / header.exposure, row[i + 3] - 136) : 0;
      out.map.radiance.emplace_back(scale * row[i], scale * row[i + 1], scale * row[i + 2]);
    }
  }
  return out;
}

}  // namespace pileus::image
