// readExr: the first flat part of any EXR, its channels grouped into layers.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>

#include "renderer/image/exr.h"
#include "renderer/image/exr_header.h"
#include "renderer/image/reason.h"

namespace fs = std::filesystem;

namespace pileus::image {
namespace {

constexpr int kMostChannels = 1024;

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

Result<Image> readPart(const fs::path& path, std::int64_t fileBytes) {
  // The table of chunks is not rebuilt for files cut off while written: they are refused, at once.
  Imf::MultiPartInputFile file(path.c_str(), 0, false);
  const Imf::Header& header = file.header(0);
  if (header.hasType() && Imf::isDeepData(header.type()))
    return fail(Code::Input, "it is a deep picture; only flat ones can be read");
  PILEUS_CHECK(checkExrSizes(header, fileBytes));
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
  return readingExr<Image>(path, [&](std::int64_t bytes) { return readPart(path, bytes); });
}

}  // namespace pileus::image
