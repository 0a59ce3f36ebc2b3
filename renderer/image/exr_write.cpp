// writeExr: one scanline part, beauty as plain R,G,B,A, every other layer as `layer.C`.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "renderer/base/file.h"
#include "renderer/base/hash.h"
#include "renderer/base/log.h"
#include "renderer/image/exr.h"
#include "renderer/image/reason.h"

namespace pileus::image {
namespace {

constexpr float kLargestHalf = 65504.0f;
constexpr float kBeyondHalf = 65520.0f;            // the first that would round to an infinity
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
  std::string take() { return std::move(content_); }

 private:
  std::string content_;
  std::size_t position_ = 0;
};

class MemoryInput : public Imf::IStream {
 public:
  explicit MemoryInput(const std::string& bytes) : IStream("picture"), bytes_(&bytes) {}
  bool read(char out[], int count) override {
    const auto n = static_cast<std::size_t>(count);
    if (n > bytes_->size() - position_) throw std::runtime_error("it ends too early");
    bytes_->copy(out, n, position_);
    position_ += n;
    return position_ < bytes_->size();
  }
  uint64_t tellg() override { return position_; }
  void seekg(uint64_t position) override { position_ = std::min<std::size_t>(position, bytes_->size()); }

 private:
  const std::string* bytes_;
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

bool isHalf(const Layer& layer, const ExrOptions& options) {
  return options.type == PixelType::Half && !layer.data;
}

/// Pixels that half floats cannot hold in some layer, not even rounded.
std::size_t countClamped(const Image& image, const ExrOptions& options) {
  std::vector<bool> clamped;
  for (const Layer& layer : image.layers) {
    if (!isHalf(layer, options)) continue;
    const auto channels = static_cast<std::size_t>(layer.channels);
    for (std::size_t i = 0; i < layer.pixels.size(); ++i) {
      if (std::abs(layer.pixels[i]) < kBeyondHalf) continue;
      clamped.resize(layer.pixels.size() / channels);
      clamped[i / channels] = true;
    }
  }
  return static_cast<std::size_t>(std::count(clamped.begin(), clamped.end(), true));
}

/// Where each channel lies in memory: `base` of a layer's first value, by layer.
Imf::FrameBuffer frameOf(const Image& image, const ExrOptions& options, const Imath::Box2i& window,
                         const std::vector<const void*>& bases) {
  Imf::FrameBuffer frame;
  for (std::size_t i = 0; i < image.layers.size(); ++i) {
    const Layer& layer = image.layers[i];
    const bool half = isHalf(layer, options);
    const std::size_t component = half ? sizeof(Imath::half) : sizeof(float);
    const std::size_t stride = component * static_cast<std::size_t>(layer.channels);
    for (int c = 0; c < layer.channels; ++c)
      frame.insert(
          channelName(layer, c),
          Imf::Slice::Make(half ? Imf::HALF : Imf::FLOAT,
                           static_cast<const char*>(bases[i]) + component * static_cast<std::size_t>(c),
                           window, stride, stride * static_cast<std::size_t>(image.size.x)));
  }
  return frame;
}

Result<std::string> encode(const Image& image, const ExrOptions& options) {
  PILEUS_TRY(const Imf::Header header, makeHeader(image, options));
  std::vector<std::vector<Imath::half>> halves;
  std::vector<const void*> bases;
  for (const Layer& layer : image.layers)
    bases.push_back(isHalf(layer, options)
                        ? static_cast<const void*>(halves.emplace_back(toHalf(layer.pixels)).data())
                        : layer.pixels.data());
  MemoryStream stream;
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frameOf(image, options, header.dataWindow(), bases));
    file.writePixels(image.size.y);
  }
  return stream.take();
}

/// What a reader makes of the bytes: pixels of which some value is not finite. Lossy compression of colours
/// works in halves, whatever their type, and rounds beyond the largest.
std::size_t countLost(const std::string& bytes, const Image& image, const ExrOptions& options) {
  constexpr float kHarmless = 1000;  // far below what rounds to an infinity
  if (options.compression != Compression::Dwaa) return 0;
  const bool large = std::any_of(image.layers.begin(), image.layers.end(), [&](const Layer& layer) {
    return std::any_of(layer.pixels.begin(), layer.pixels.end(),
                       [&](float v) { return std::abs(v) > kHarmless; });
  });
  if (!large) return 0;
  MemoryInput stream(bytes);
  Imf::InputFile file(stream);
  std::vector<std::vector<float>> values;
  std::vector<const void*> bases;
  for (const Layer& layer : image.layers) bases.push_back(values.emplace_back(layer.pixels.size()).data());
  const Imath::Box2i window = file.header().dataWindow();
  ExrOptions floats = options;
  floats.type = PixelType::Float;
  file.setFrameBuffer(frameOf(image, floats, window, bases));
  file.readPixels(window.min.y, window.max.y);
  std::vector<bool> lost(static_cast<std::size_t>(image.size.x) * static_cast<std::size_t>(image.size.y));
  for (std::size_t i = 0; i < image.layers.size(); ++i)
    for (std::size_t k = 0; k < values[i].size(); ++k)
      if (!std::isfinite(values[i][k])) lost[k / static_cast<std::size_t>(image.layers[i].channels)] = true;
  return static_cast<std::size_t>(std::count(lost.begin(), lost.end(), true));
}

std::string pixels(std::size_t n) { return n == 1 ? "1 pixel" : fmt::format("{} pixels", n); }

}  // namespace

Result<std::string> encodeExr(const Image& image, const ExrOptions& options,
                              std::vector<std::string>& warnings) {
  PILEUS_CHECK(checkShape(image));
  PILEUS_CHECK(checkFinite(image));
  try {
    PILEUS_TRY(std::string bytes, encode(image, options));
    if (const std::size_t n = countClamped(image, options); n > 0)
      warnings.push_back(
          fmt::format("{} brighter than half floats can hold: clamped to 65504 (float as type keeps them)",
                      n == 1 ? "1 pixel is" : fmt::format("{} pixels are", n)));
    if (const std::size_t n = countLost(bytes, image, options); n > 0) {
      warnings.push_back(fmt::format(
          "DWAA would make infinities of {} near or above 65504: compressed as ZIP instead", pixels(n)));
      ExrOptions lossless = options;
      lossless.compression = Compression::Zip;
      PILEUS_TRY(bytes, encode(image, lossless));
    }
    return bytes;
  } catch (const std::exception& e) {
    return fail(Code::Internal, "cannot be written ({})", clampReason(e.what()));
  }
}

Result<void> writeExr(const std::filesystem::path& path, const Image& image, const ExrOptions& options,
                      std::vector<std::string>* warnings) {
  std::vector<std::string> found;
  const auto bytes = encodeExr(image, options, found);
  if (!bytes) return fail(bytes.error().code, "{}: {}", path.string(), bytes.error().message);
  PILEUS_CHECK(writeFileAtomic(path, *bytes));
  for (std::string& warning : found) {
    warning = path.string() + ": " + warning;
    if (!warnings) log::write(log::Level::Warning, warning);
  }
  if (warnings) warnings->insert(warnings->end(), found.begin(), found.end());
  return {};
}

}  // namespace pileus::image
