#include "renderer/volume/file_kind.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>

namespace fs = std::filesystem;

namespace pileus::volume {
namespace {

using namespace std::string_view_literals;

struct Kind {
  std::string_view magic, description;
};
constexpr Kind kKinds[] = {
    {"NanoVDB"sv,
     "a NanoVDB file (.nvdb), which is not supported yet; convert it to .vdb, for instance with "
     "nanovdb_convert"},
    {"version https://git-lfs"sv,
     "a Git LFS pointer, not the file itself; run `git lfs pull` where it comes from"},
    {"\x76\x2f\x31\x01"sv, "an OpenEXR image"},
    {"\x89PNG"sv, "a PNG image"},
    {"\xff\xd8\xff"sv, "a JPEG image"},
    {"PK\x03\x04"sv, "a zip archive; unpack it first"},
    {"\x1f\x8b"sv, "a gzip archive; unpack it first"},
    {"\x28\xb5\x2f\xfd"sv, "a zstd archive; unpack it first"},
    {"\x89HDF"sv, "an HDF5 file (perhaps Field3D)"},
    {"PXR-USDC"sv, "a USD file; read the .vdb files that it refers to"},
    {"#usda"sv, "a USD file; read the .vdb files that it refers to"},
};

bool isText(std::string_view head) {
  return std::all_of(head.begin(), head.end(), [](char c) {
    const auto u = static_cast<unsigned char>(c);
    return u >= 32 || c == '\n' || c == '\r' || c == '\t';
  });
}

}  // namespace

std::optional<std::string> whyNotVdb(const fs::path& path) {
  std::error_code ec;
  const auto status = fs::status(path, ec);
  if (path.empty()) return "no file is given";
  if (!fs::exists(status)) return "no such file";
  if (fs::is_directory(status)) return "is a folder, not a .vdb file";
  if (!fs::is_regular_file(status)) return "is not a regular file";
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  char buffer[64];
  if (!in) return fmt::format("cannot be opened ({})", std::strerror(errno));
  in.read(buffer, sizeof buffer);
  const std::string_view head(buffer, static_cast<std::size_t>(in.gcount()));
  if (head.empty()) return "is empty (0 bytes)";
  for (const Kind& k : kKinds)
    if (head.starts_with(k.magic)) return fmt::format("is not a VDB file: it is {}", k.description);
  if (head.starts_with(" BDV\0\0\0\0"sv)) {
    if (head.size() < 21) return "is truncated: its header is cut off";
    std::uint32_t version;
    std::memcpy(&version, head.data() + 8, sizeof version);
    if (version < 200 || version > 999)
      return fmt::format("is damaged: its header claims file format {}", version);
    return std::nullopt;
  }
  if (path.extension() == ".nvdb")
    return std::string("is not a VDB file: ") + std::string(kKinds[0].description);
  if (isText(head)) {
    const std::string_view line = head.substr(0, std::min<std::size_t>(head.find('\n'), 40));
    return fmt::format("is not a VDB file: it is text, beginning with \"{}\"", line);
  }
  std::string hex;
  for (char c : head.substr(0, 8))
    hex += fmt::format("{}{:02x}", hex.empty() ? "" : " ", static_cast<unsigned char>(c));
  return fmt::format("is not a VDB file: it begins with the bytes {}", hex);
}

int vdbFormatOf(const fs::path& path) {
  char head[12] = {};
  std::ifstream(path, std::ios::binary).read(head, sizeof head);
  if (!std::string_view(head, sizeof head).starts_with(" BDV\0\0\0\0"sv)) return 0;
  std::int32_t version;
  std::memcpy(&version, head + 8, sizeof version);
  return version;
}

}  // namespace pileus::volume
