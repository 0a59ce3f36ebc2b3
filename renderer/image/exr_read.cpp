// readExr: the first flat part of any EXR, its channels grouped into layers. Sizes are checked in 64 bits and
// against the file's length before anything is allocated for them: a header costs a hostile file nothing.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTileDescription.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "renderer/image/exr.h"
#include "renderer/image/exr_limits.h"
#include "renderer/image/reason.h"

namespace fs = std::filesystem;

namespace pileus::image {
namespace {

constexpr std::int64_t kMostPixels = std::int64_t(1) << 28;
constexpr std::int64_t kMostSamples = std::int64_t(1) << 30;
constexpr std::int64_t kLargestTile = std::int64_t(1)
                                      << 28;  // bytes; whole tiles are held, however small the picture
constexpr int kMostChannels = 1024;
constexpr std::int64_t kSmallPicture = std::int64_t(1) << 22;  // bytes; not worth a closer look

/// Where one channel of the file goes.
struct Route {
  std::string channel;
  std::size_t layer;
  int component;
};

struct Plan {
  std::vector<Layer> layers;
  std::vector<Route> routes;
};

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

/// The components of one layer (the last parts of its channels' names) become one layer of 1, 3 or 4 channels
/// where they are a colour or a vector; every other component becomes a layer of its own, under the channel's
/// full name.
void planLayer(const std::string& prefix, std::vector<std::string> components, Plan& plan) {
  const auto add = [&](std::string name, const std::vector<std::string> taken) {
    const auto used = [&] {
      return std::any_of(plan.layers.begin(), plan.layers.end(),
                         [&](const Layer& l) { return l.name == name; });
    };
    while (used()) name += '_';  // a channel "Z" beside a layer "Z"
    const std::size_t index = plan.layers.size();
    plan.layers.push_back({name, static_cast<int>(taken.size()), {}});
    for (std::size_t c = 0; c < taken.size(); ++c) {
      plan.routes.push_back(
          {prefix.empty() ? taken[c] : prefix + "." + taken[c], index, static_cast<int>(c)});
      std::erase(components, taken[c]);
    }
  };
  const auto has = [&](const std::vector<std::string>& wanted) {
    return std::all_of(wanted.begin(), wanted.end(), [&](const std::string& w) {
      return std::find(components.begin(), components.end(), w) != components.end();
    });
  };
  using Names = std::vector<std::string>;
  bool colored = false;
  for (const Names& color : {Names{"R", "G", "B"}, Names{"r", "g", "b"}, Names{"red", "green", "blue"}}) {
    if (!has(color)) continue;
    Names taken = color;
    for (const char* alpha : {"A", "a", "alpha"})
      if (taken.size() == 3 && has({alpha})) taken.emplace_back(alpha);
    add(prefix, taken);
    colored = true;
    break;
  }
  if (!colored) {
    if (components == Names{"X", "Y", "Z"} || components == Names{"x", "y", "z"})
      add(prefix, components);
    else if (has({"Y"}))
      add(prefix, {"Y"});
  }
  for (const std::string& component : Names(components))
    add(prefix.empty() ? component : prefix + "." + component, {component});
}

Result<Plan> planChannels(const Imf::ChannelList& channels) {
  std::vector<std::pair<std::string, std::vector<std::string>>> groups{{"", {}}};  // the beauty first
  int count = 0;
  for (auto it = channels.begin(); it != channels.end(); ++it) {
    const std::string name = it.name();
    if (++count > kMostChannels) return fail(Code::Input, "more than {} channels", kMostChannels);
    if (it.channel().xSampling != 1 || it.channel().ySampling != 1)
      return fail(
          Code::Input,
          "channel '{}' is sub-sampled{}, which is not supported; save it with full-resolution R, G, B",
          clampReason(name), name == "RY" || name == "BY" ? " (luminance/chroma)" : "");
    const std::size_t dot = name.rfind('.');
    const std::string prefix = dot == std::string::npos ? "" : name.substr(0, dot);
    const std::string component = dot == std::string::npos ? name : name.substr(dot + 1);
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == prefix; });
    if (group == groups.end()) group = groups.insert(groups.end(), {prefix, {}});
    group->second.push_back(component);
  }
  if (count == 0) return fail(Code::Input, "it has no channels");
  if (channels.findChannel("RY") || channels.findChannel("BY"))
    return fail(Code::Input, "luminance/chroma pictures are not supported; save it with R, G, B");
  Plan plan;
  for (const auto& [prefix, components] : groups) planLayer(prefix, components, plan);
  return plan;
}

/// Window sizes against fixed limits and against the file's length. Every chunk has an 8-byte table entry and
/// a header.
Result<void> checkSizes(const Imf::Header& header, std::int64_t fileBytes) {
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
  std::int64_t chunks = 0, chunkHeader = 8;
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

/// The library begins its messages with the path, which ours name already.
std::string reasonWithoutPath(std::string_view reason, const fs::path& path) {
  const std::string named = fmt::format("\"{}\". ", path.string());
  if (const std::size_t at = reason.find(named); at != std::string_view::npos)
    reason.remove_prefix(at + named.size());
  if (!reason.empty() && reason.back() == '.') reason.remove_suffix(1);
  return clampReason(reason);
}

Result<Image> readPart(const fs::path& path, std::int64_t fileBytes) {
  // The table of chunks is not rebuilt for files cut off while written: they are refused, at once.
  Imf::MultiPartInputFile file(path.c_str(), 0, false);
  const Imf::Header& header = file.header(0);
  if (header.hasType() && Imf::isDeepData(header.type()))
    return fail(Code::Input, "it is a deep picture; only flat ones can be read");
  PILEUS_CHECK(checkSizes(header, fileBytes));
  PILEUS_TRY(Plan plan, planChannels(header.channels()));

  const Imath::Box2i &data = header.dataWindow(), &display = header.displayWindow();
  Image image;
  image.size = {data.max.x - data.min.x + 1, data.max.y - data.min.y + 1};
  image.dataOrigin = {data.min.x - display.min.x, data.min.y - display.min.y};
  image.displaySize = {display.max.x - display.min.x + 1, display.max.y - display.min.y + 1};
  image.chromaticities = readChromaticities(header);
  for (auto it = header.begin(); it != header.end(); ++it) {
    const std::string name = it.name();
    if (name == "name" || name == "type" || name == "view") continue;
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute()))
      image.metadata[name] = text->value();
  }

  const std::size_t width = static_cast<std::size_t>(image.size.x),
                    pixels = width * static_cast<std::size_t>(image.size.y);
  for (Layer& layer : plan.layers) layer.pixels.resize(pixels * static_cast<std::size_t>(layer.channels));
  Imf::FrameBuffer frame;
  for (const Route& route : plan.routes) {
    Layer& layer = plan.layers[route.layer];
    const std::size_t stride = sizeof(float) * static_cast<std::size_t>(layer.channels);
    frame.insert(route.channel, Imf::Slice::Make(Imf::FLOAT, layer.pixels.data() + route.component, data,
                                                 stride, stride * width));
  }
  Imf::InputPart part(file, 0);
  part.setFrameBuffer(frame);
  part.readPixels(data.min.y, data.max.y);
  image.layers = std::move(plan.layers);
  return image;
}

}  // namespace

Result<Image> readExr(const fs::path& path) {
  std::error_code ec;
  const auto status = fs::status(path, ec);
  if (!fs::exists(status)) return fail(Code::Input, "{}: there is no such file", path.string());
  if (!fs::is_regular_file(status)) return fail(Code::Input, "{}: is not a file", path.string());
  const auto bytes = static_cast<std::int64_t>(fs::file_size(path, ec));
  if (ec) return fail(Code::Input, "{}: cannot be read ({})", path.string(), ec.message());
  limitHeaders();
  try {
    auto image = readPart(path, bytes);
    if (!image) return fail(image.error().code, "{}: {}", path.string(), image.error().message);
    return image;
  } catch (const std::bad_alloc&) {
    return fail(Code::Input, "{}: does not fit into memory", path.string());
  } catch (const std::exception& e) {
    return fail(Code::Input, "{}: not a readable EXR picture ({})", path.string(),
                reasonWithoutPath(e.what(), path));
  }
}

}  // namespace pileus::image
