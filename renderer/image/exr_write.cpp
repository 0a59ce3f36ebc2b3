// writeExr: one scanline part, beauty as plain R,G,B,A, every other layer as `layer.C`.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "renderer/base/file.h"
#include "renderer/base/hash.h"
#include "renderer/image/exr.h"
#include "renderer/image/reason.h"

namespace pileus::image {
namespace {

constexpr float kLargestHalf = 65504.0f;
constexpr std::size_t kLongestAttributeName = 31;  // of EXR files without the long-names flag

/// The file grows in memory, so that a full disk shows as an error of our own write and not in a destructor
/// of the library's.
class MemoryStream : public Imf::OStream {
 public:
  MemoryStream() : OStream("picture") {}
  void write(const char bytes[], int count) override {
    const auto n = static_cast<std::size_t>(count);
    if (position_ + n > content_.size()) content_.resize(position_ + n);
    std::copy_n(bytes, n, content_.begin() + static_cast<std::ptrdiff_t>(position_));
    position_ += n;
  }
  uint64_t tellp() override { return position_; }
  void seekp(uint64_t position) override { position_ = position; }
  const std::string& content() const { return content_; }

 private:
  std::string content_;
  std::size_t position_ = 0;
};

Imf::Compression exrCompression(Compression c) {
  switch (c) {
    case Compression::None:
      return Imf::NO_COMPRESSION;
    case Compression::Zips:
      return Imf::ZIPS_COMPRESSION;
    case Compression::Zip:
      return Imf::ZIP_COMPRESSION;
    case Compression::Piz:
      return Imf::PIZ_COMPRESSION;
    case Compression::Dwaa:
      return Imf::DWAA_COMPRESSION;
  }
  return Imf::ZIP_COMPRESSION;
}

const char* componentName(const Layer& layer, int component) {
  static constexpr const char* kColor[] = {"R", "G", "B", "A"};
  return layer.channels == 1 ? (layer.data ? "Z" : "Y") : kColor[component];
}

std::string channelName(const Layer& layer, int component) {
  return layer.name.empty() ? componentName(layer, component)
                            : layer.name + "." + componentName(layer, component);
}

std::string shownName(const Layer& layer) {
  return layer.name.empty() ? "the beauty" : fmt::format("'{}'", layer.name);
}

/// Long names keep their beginning and end in eight digits of their hash: distinct, and the same in every
/// file.
std::string attributeName(const std::string& name) {
  if (name.size() <= kLongestAttributeName) return name;
  return name.substr(0, kLongestAttributeName - 9) + "_" + Hasher().add(name).key().hex().substr(0, 8);
}

Result<void> checkShape(const Image& image) {
  if (image.size.x < 1 || image.size.y < 1)
    return fail(Code::Arguments, "a picture of {} x {} pixels cannot be written", image.size.x, image.size.y);
  if (image.layers.empty()) return fail(Code::Internal, "a picture without layers cannot be written");
  const auto pixels = static_cast<std::size_t>(image.size.x) * static_cast<std::size_t>(image.size.y);
  std::set<std::string> names;
  for (const Layer& layer : image.layers) {
    if (layer.channels != 1 && layer.channels != 3 && layer.channels != 4)
      return fail(Code::Internal, "layer {} has {} channels; 1, 3 or 4 can be written", shownName(layer),
                  layer.channels);
    if (layer.pixels.size() != pixels * static_cast<std::size_t>(layer.channels))
      return fail(Code::Internal, "layer {} holds {} values where {} x {} x {} are needed", shownName(layer),
                  layer.pixels.size(), image.size.x, image.size.y, layer.channels);
    for (int c = 0; c < layer.channels; ++c)
      if (!names.insert(channelName(layer, c)).second)
        return fail(Code::Internal, "two layers of the picture are called {}", shownName(layer));
  }
  return {};
}

Result<void> checkFinite(const Image& image) {
  for (const Layer& layer : image.layers) {
    const auto bad =
        std::find_if_not(layer.pixels.begin(), layer.pixels.end(), [](float v) { return std::isfinite(v); });
    if (bad == layer.pixels.end()) continue;
    const auto index = static_cast<std::size_t>(bad - layer.pixels.begin());
    const auto channels = static_cast<std::size_t>(layer.channels),
               width = static_cast<std::size_t>(image.size.x);
    const std::size_t pixel = index / channels;
    return fail(Code::Internal,
                "layer {}, channel {}, pixel ({}, {}) is {}: refused, so that it reaches no file",
                shownName(layer), componentName(layer, static_cast<int>(index % channels)), pixel % width,
                pixel / width, std::isnan(*bad) ? "not a number" : "infinite");
  }
  return {};
}

Result<Imf::Header> makeHeader(const Image& image, const ExrOptions& options) {
  const ivec2 display = image.displaySize.x > 0 && image.displaySize.y > 0 ? image.displaySize : image.size;
  const ivec2 lo = image.dataOrigin, hi = lo + image.size - 1;
  Imf::Header header(Imath::Box2i({0, 0}, {display.x - 1, display.y - 1}),
                     Imath::Box2i({lo.x, lo.y}, {hi.x, hi.y}));
  header.compression() = exrCompression(options.compression);
  for (const auto& [name, text] : image.metadata) {
    const std::string key = attributeName(name);
    static const std::set<std::string, std::less<>> kReserved{
        "",        "type",       "name",  "view",           "multiView",
        "version", "chunkCount", "tiles", "chromaticities", "preview"};
    if (kReserved.contains(key) || (header.find(key) != header.end()))
      return fail(Code::Internal, "metadata '{}': this name is reserved in EXR files", name);
    header.insert(key, Imf::StringAttribute(text));
  }
  const auto& c = image.chromaticities;
  Imf::addChromaticities(header, Imf::Chromaticities({c.red.x, c.red.y}, {c.green.x, c.green.y},
                                                     {c.blue.x, c.blue.y}, {c.white.x, c.white.y}));
  const Imf::PixelType type = options.type == PixelType::Half ? Imf::HALF : Imf::FLOAT;
  for (const Layer& layer : image.layers)
    for (int channel = 0; channel < layer.channels; ++channel)
      header.channels().insert(channelName(layer, channel), Imf::Channel(layer.data ? Imf::FLOAT : type));
  return header;
}

std::vector<Imath::half> toHalf(const std::vector<float>& values) {
  std::vector<Imath::half> out(values.size());
  std::transform(values.begin(), values.end(), out.begin(),
                 [](float v) { return Imath::half(std::clamp(v, -kLargestHalf, kLargestHalf)); });
  return out;
}

}  // namespace

Result<void> writeExr(const std::filesystem::path& path, const Image& image, const ExrOptions& options) {
  const auto inPath = [&](const Error& e) { return fail(e.code, "{}: {}", path.string(), e.message); };
  if (auto ok = checkShape(image); !ok) return inPath(ok.error());
  if (auto ok = checkFinite(image); !ok) return inPath(ok.error());
  try {
    auto header = makeHeader(image, options);
    if (!header) return inPath(header.error());
    const Imath::Box2i window = header->dataWindow();
    std::vector<std::vector<Imath::half>> halves;
    Imf::FrameBuffer frame;
    for (const Layer& layer : image.layers) {
      const bool half = options.type == PixelType::Half && !layer.data;
      const std::size_t component = half ? sizeof(Imath::half) : sizeof(float);
      const void* first = layer.pixels.data();
      if (half) first = halves.emplace_back(toHalf(layer.pixels)).data();
      const std::size_t stride = component * static_cast<std::size_t>(layer.channels);
      for (int c = 0; c < layer.channels; ++c)
        frame.insert(
            channelName(layer, c),
            Imf::Slice::Make(half ? Imf::HALF : Imf::FLOAT,
                             static_cast<const char*>(first) + component * static_cast<std::size_t>(c),
                             window, stride, stride * static_cast<std::size_t>(image.size.x)));
    }
    MemoryStream stream;
    {
      Imf::OutputFile file(stream, *header);
      file.setFrameBuffer(frame);
      file.writePixels(image.size.y);
    }
    return writeFileAtomic(path, stream.content());
  } catch (const std::exception& e) {
    return fail(Code::Internal, "{}: cannot be written ({})", path.string(), clampReason(e.what()));
  }
}

}  // namespace pileus::image
