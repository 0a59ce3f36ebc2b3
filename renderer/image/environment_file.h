#pragma once
// Maps of light from everywhere, as files hold them: lat-long pictures as OpenEXR (.exr) or Radiance (.hdr).
// Any thread.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/image/color.h"
#include "renderer/image/image.h"
#include "renderer/scene/environment.h"

namespace pileus::image {

/// Larger files are refused.
inline constexpr ivec2 kLargestEnvironmentFile{32768, 16384};
inline constexpr std::int64_t kMostEnvironmentPixels = std::int64_t(16384) * 8192;
/// Larger maps are reduced to this while they are read: a texel is a sixth of the sun's diameter.
inline constexpr ivec2 kLargestEnvironment{4096, 2048};
/// Bytes of a Radiance file that are read at most.
inline constexpr std::size_t kMostHdrBytes = std::size_t(1) << 30;

/// What a file holds, before colours are known: negative values may be a colour outside of its primaries.
struct EnvironmentFile {
  scene::EnvironmentMap map;                  ///< in the file's own numbers, finite
  std::optional<Chromaticities> primaries{};  ///< where the file says them
  std::vector<std::string> warnings{};        ///< one for each kind of fault, with its number of pixels
};

/// The data window of a file's first part is the map, at its finest level; what it is drawn on plays no part.
/// Channels R, G, B (or r, g, b; red, green, blue) are radiance; no others are read. NaNs become 0,
/// infinities the largest half. The content decides which format it is. Errors (Input) begin with the path:
/// missing, cut off, damaged, too large, deep, a cube map, without R, G, B, sub-sampled, XYZE, turned.
/// A hostile file may make a library crash or take long: importEnvironment() runs this in a child process.
Result<EnvironmentFile> decodeEnvironment(const std::filesystem::path& path);

/// The same of a Radiance file's content, without a path in its errors.
Result<EnvironmentFile> decodeHdr(std::string_view file);

/// From a space of the colour config to linear ACEScg, in place; "" is linear Rec. 709 and needs no config.
/// Error (Arguments) lists the spaces where there is none of that name.
Result<void> toWorkingSpace(scene::EnvironmentMap& map, const std::string& colorspace,
                            const ColorConfig& config);

/// The two together, values made radiance: none is negative. `warnings` gets a sentence on what was changed,
/// and on primaries that are not what `colorspace` "" takes them for.
Result<scene::EnvironmentMap> environmentFrom(EnvironmentFile file, const std::string& colorspace,
                                              const ColorConfig& config, std::vector<std::string>& warnings);

}  // namespace pileus::image
