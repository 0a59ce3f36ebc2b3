#pragma once
// OpenEXR stills. Any thread.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "renderer/base/enum_info.h"
#include "renderer/image/image.h"

#include <array>

namespace pileus::image {

enum class PixelType { Half, Float };
constexpr auto enumInfo(PixelType*) {
  return std::array{
      EnumItem<PixelType>{PixelType::Half, "half", "Half",
                          "16-bit float: enough for pictures, half the size."},
      EnumItem<PixelType>{PixelType::Float, "float", "Float", "32-bit float: for data and measurements."}};
}

enum class Compression { None, Zips, Zip, Piz, Dwaa };
constexpr auto enumInfo(Compression*) {
  return std::array{EnumItem<Compression>{Compression::None, "none", "None", "No compression."},
                    EnumItem<Compression>{Compression::Zips, "zips", "ZIPS",
                                          "Lossless, one row a block: fast to scrub in compositors."},
                    EnumItem<Compression>{Compression::Zip, "zip", "ZIP", "Lossless, 16 rows a block."},
                    EnumItem<Compression>{Compression::Piz, "piz", "PIZ", "Lossless wavelet: best on grain."},
                    EnumItem<Compression>{Compression::Dwaa, "dwaa", "DWAA", "Lossy: for previews only."}};
}

struct ExrOptions {
  PixelType type = PixelType::Half;
  Compression compression = Compression::Zip;
};

/// The bytes of a file. Half: values are clamped to the largest finite half. A NaN or infinity in the input
/// makes the call fail (Internal) naming layer and pixel: none ever reaches a file, nor is one read back from
/// it: where DWAA would make infinities of large values, ZIP is used. `warnings` gets a sentence on each of
/// these. Metadata names beyond the 31 characters of EXR are shortened, ending in digits of their hash.
Result<std::string> encodeExr(const Image& image, const ExrOptions& options,
                              std::vector<std::string>& warnings);
/// The same as a file, as writeFileAtomic. Without `warnings` they go to the log. Error (Input) names an
/// unwritable path.
Result<void> writeExr(const std::filesystem::path& path, const Image& image, const ExrOptions& options = {},
                      std::vector<std::string>* warnings = nullptr);
/// Any flat EXR (scanline or tiled, half/float/uint), first part. Channels R,G,B(,A), X,Y,Z and Y become
/// layers by their prefix; any other channel is a layer of its own, of its full name; the beauty comes first.
/// Without chromaticities in the file they are Rec. 709's, as the format has it. Values are as stored, NaNs
/// included. Error (Input) on damaged, deep, sub-sampled or absurdly large files, never a crash.
Result<Image> readExr(const std::filesystem::path& path);
/// The text attributes of a file's header; its pixels are not read. Errors as readExr.
Result<std::map<std::string, std::string>> readExrMetadata(const std::filesystem::path& path);

/// Attribute of a still that holds the graph it was rendered from, as a graph file.
inline constexpr char kGraphAttribute[] = "pileus:graphText";

}  // namespace pileus::image
