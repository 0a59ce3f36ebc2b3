#include "renderer/image/environment_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfEnvmapAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "renderer/base/file.h"
#include "renderer/image/exr_header.h"
#include "renderer/image/reason.h"

namespace fs = std::filesystem;

namespace pileus::image {
namespace {

constexpr Chromaticities kRec709{{0.64f, 0.33f}, {0.30f, 0.60f}, {0.15f, 0.06f}, {0.3127f, 0.3290f}};

std::string listed(const Imf::ChannelList& channels) {
  std::string out;
  for (auto it = channels.begin(); it != channels.end() && out.size() < 200; ++it)
    out += (out.empty() ? "" : ", ") + clampReason(it.name());
  return out.empty() ? "none" : out;
}

Result<std::array<std::string, 3>> colorChannels(const Imf::ChannelList& channels) {
  using Names = std::array<std::string, 3>;
  for (const Names& names : {Names{"R", "G", "B"}, Names{"r", "g", "b"}, Names{"red", "green", "blue"}}) {
    if (!std::all_of(names.begin(), names.end(), [&](const auto& n) { return channels.findChannel(n); }))
      continue;
    for (const std::string& n : names)
      if (const Imf::Channel* c = channels.findChannel(n); c->xSampling != 1 || c->ySampling != 1)
        return fail(Code::Input, "channel '{}' is sub-sampled, which is not supported", n);
    return names;
  }
  if (channels.findChannel("RY") || channels.findChannel("BY"))
    return fail(Code::Input, "luminance/chroma pictures are not supported; save it with R, G, B");
  return fail(Code::Input, "it has no channels R, G, B (it has {})", listed(channels));
}

Result<EnvironmentFile> readPart(const fs::path& path, std::int64_t fileBytes) {
  Imf::MultiPartInputFile file(path.c_str(), 0, false);
  const Imf::Header& header = file.header(0);
  if (header.hasType() && Imf::isDeepData(header.type()))
    return fail(Code::Input, "it is a deep picture; only flat ones can be read");
  if (Imf::hasEnvmap(header) && Imf::envmap(header) != Imf::ENVMAP_LATLONG)
    return fail(Code::Input,
                "it is a cube map; only latitude-longitude maps can be read (exrenvmap converts)");
  PILEUS_CHECK(checkExrSizes(header, fileBytes));
  const Imath::Box2i& data = header.dataWindow();
  EnvironmentFile out;
  out.map.size = {data.max.x - data.min.x + 1, data.max.y - data.min.y + 1};
  const std::int64_t pixels = std::int64_t(out.map.size.x) * out.map.size.y;
  if (out.map.size.x > kLargestEnvironmentFile.x || out.map.size.y > kLargestEnvironmentFile.y ||
      pixels > kMostEnvironmentPixels)
    return fail(Code::Input, "{} x {} pixels are more than can be read ({} million)", out.map.size.x,
                out.map.size.y, kMostEnvironmentPixels >> 20);
  PILEUS_TRY(const auto names, colorChannels(header.channels()));
  if (Imf::hasChromaticities(header)) out.primaries = readChromaticities(header);
  out.map.radiance.resize(std::size_t(pixels), vec3(0));
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < 3; ++c)
    frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, &out.map.radiance[0][int(c)], data, sizeof(vec3),
                                            sizeof(vec3) * std::size_t(out.map.size.x)));
  Imf::InputPart part(file, 0);
  part.setFrameBuffer(frame);
  part.readPixels(data.min.y, data.max.y);
  return out;
}

Result<EnvironmentFile> readHdr(const fs::path& path) {
  PILEUS_TRY(const std::string content, readFile(path, kMostHdrBytes));
  auto out = decodeHdr(content);
  if (!out) return fail(out.error().code, "{}: {}", path.string(), out.error().message);
  return out;
}

bool beginsAsExr(const fs::path& path) {
  char magic[4] = {};
  std::ifstream in(path, std::ios::binary);
  return in.read(magic, 4) && std::string_view(magic, 4) == std::string_view("\x76\x2f\x31\x01", 4);
}

bool nearly(const Chromaticities& a, const Chromaticities& b) {
  const auto apart = [](const vec2& x, const vec2& y) { return glm::length(x - y) > 2e-3f; };
  return !apart(a.red, b.red) && !apart(a.green, b.green) && !apart(a.blue, b.blue) &&
         !apart(a.white, b.white);
}

void tell(const scene::EnvironmentFaults& faults, std::vector<std::string>& warnings) {
  if (faults.notNumbers)
    warnings.push_back(fmt::format("{} pixels that are not numbers are black", faults.notNumbers));
  if (faults.tooBright)
    warnings.push_back(fmt::format("{} pixels are infinite or too bright and were cut (infinity to {})",
                                   faults.tooBright, scene::kInfiniteRadiance));
  if (faults.negative)
    warnings.push_back(fmt::format("{} pixels have negative values, which count as 0", faults.negative));
}

}  // namespace

Result<EnvironmentFile> decodeEnvironment(const fs::path& path) {
  const auto readable = openableExr(path);
  if (!readable) return readable.error();
  auto out = beginsAsExr(path) ? readingExr<EnvironmentFile>(
                                     path, [&](std::int64_t bytes) { return readPart(path, bytes); })
                               : readHdr(path);
  if (!out) return out.error();
  tell(scene::repair(out->map, scene::Negative::Keep), out->warnings);
  const ivec2 size = out->map.size;
  if (size.x > 4 && (size.x * 2 < size.y * 3 || size.x * 2 > size.y * 5))
    out->warnings.push_back(fmt::format(
        "{} x {} pixels are taken as a latitude-longitude map, which is usually twice as wide as high",
        size.x, size.y));
  out->map = scene::reduced(out->map, kLargestEnvironment);
  return out;
}

Result<scene::EnvironmentMap> environmentFrom(EnvironmentFile file, const std::string& colorspace,
                                              const ColorConfig& config, std::vector<std::string>& warnings) {
  warnings.insert(warnings.end(), file.warnings.begin(), file.warnings.end());
  if (colorspace.empty() && file.primaries && !nearly(*file.primaries, kRec709))
    warnings.push_back(fmt::format(
        "colorspace: the file names other primaries than Rec. 709{}; its values are taken as linear Rec. 709",
        nearly(*file.primaries, Chromaticities()) ? " (those of ACEScg)" : ""));
  PILEUS_CHECK(toWorkingSpace(file.map, colorspace, config));
  tell(scene::repair(file.map), warnings);
  return std::move(file.map);
}

Result<void> toWorkingSpace(scene::EnvironmentMap& map, const std::string& colorspace,
                            const ColorConfig& config) {
  return config.toWorkingSpace(colorspace, map.radiance.empty() ? nullptr : &map.radiance[0].x,
                               map.radiance.size());
}

}  // namespace pileus::image
