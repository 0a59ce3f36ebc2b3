#include "renderer/image/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pileus::image {
namespace {

const char* componentName(int channels, int component) {
  static constexpr const char* kColor[] = {"R", "G", "B", "A"};
  return channels == 1 ? "Y" : kColor[component];
}

const Layer& beauty(const Image& image) {
  const Layer* layer = image.layer("");
  return layer ? *layer : image.layers.front();
}

/// |a - b|; values that are not finite are equal to their like and infinitely far from everything else.
double distance(float a, float b) {
  if (std::isfinite(a) && std::isfinite(b)) return std::abs(double(a) - double(b));
  const bool same = (std::isnan(a) && std::isnan(b)) || a == b;
  return same ? 0.0 : std::numeric_limits<double>::infinity();
}

Result<void> checkSameSize(const Image& a, const Image& b) {
  if (a.size != b.size)
    return fail(Code::Input, "the pictures differ in size: {} x {} and {} x {}", a.size.x, a.size.y, b.size.x,
                b.size.y);
  if (a.dataOrigin != b.dataOrigin)
    return fail(Code::Input, "the pictures' data windows begin at ({}, {}) and ({}, {})", a.dataOrigin.x,
                a.dataOrigin.y, b.dataOrigin.x, b.dataOrigin.y);
  if (a.layers.empty() || b.layers.empty())
    return fail(Code::Input, "a picture without layers cannot be compared");
  return {};
}

Result<void> checkComparable(const Image& a, const Image& b) {
  PILEUS_CHECK(checkSameSize(a, b));
  const auto missing = [](const Image& one, const Image& other, const char* which) -> Result<void> {
    for (const Layer& layer : one.layers) {
      const Layer* twin = other.layer(layer.name);
      const std::string name =
          layer.name.empty() ? "the beauty layer" : fmt::format("layer '{}'", layer.name);
      if (!twin) return fail(Code::Input, "the {} picture has {}, the other does not", which, name);
      if (twin->channels != layer.channels)
        return fail(Code::Input, "{} has {} channels in the {} picture and {} in the other", name,
                    layer.channels, which, twin->channels);
    }
    return {};
  };
  PILEUS_CHECK(missing(a, b, "first"));
  return missing(b, a, "second");
}

ChannelDifference channelDifference(const Layer& a, const Layer& b, int component) {
  ChannelDifference out;
  out.channel =
      fmt::format("{}{}{}", a.name, a.name.empty() ? "" : ".", componentName(a.channels, component));
  const auto stride = static_cast<std::size_t>(a.channels);
  double sum = 0, squares = 0;
  for (std::size_t i = static_cast<std::size_t>(component); i < a.pixels.size(); i += stride) {
    const double d = distance(a.pixels[i], b.pixels[i]);
    sum += d;
    squares += d * d;
    out.maximum = std::max(out.maximum, d);
  }
  const double pixels = static_cast<double>(a.pixels.size() / stride);
  out.mean = sum / pixels;
  out.rmse = std::sqrt(squares / pixels);
  return out;
}

/// Pixels with a value that is not finite in some layer of either picture.
std::size_t countNotFinite(const Image& a, const Image& b) {
  std::vector<bool> bad(static_cast<std::size_t>(a.size.x) * static_cast<std::size_t>(a.size.y));
  for (const Image* image : {&a, &b})
    for (const Layer& layer : image->layers)
      for (std::size_t i = 0; i < layer.pixels.size(); ++i)
        if (!std::isfinite(layer.pixels[i])) bad[i / static_cast<std::size_t>(layer.channels)] = true;
  return static_cast<std::size_t>(std::count(bad.begin(), bad.end(), true));
}

/// `covered`: only pixels with reference alpha > 0.01. Nothing if there are none.
std::optional<double> relativeMse(const Layer& a, const Layer& b, bool covered) {
  const auto stride = static_cast<std::size_t>(a.channels), colors = std::min<std::size_t>(stride, 3);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t first = 0; first < a.pixels.size(); first += stride) {
    if (covered && stride == 4 && !(b.pixels[first + 3] > 0.01f)) continue;
    for (std::size_t c = 0; c < colors; ++c) {
      const double d = distance(a.pixels[first + c], b.pixels[first + c]),
                   reference = double(b.pixels[first + c]);
      if (d > 0.0) sum += std::isfinite(d) ? d * d / (reference * reference + 0.01) : d;
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

/// Of the mean of values that come in groups: sums and numbers of each (Cochran 1977, 6.3: a ratio of sums
/// over clusters). Infinite for a single group.
double standardErrorOf(const std::vector<double>& sums, const std::vector<double>& counts) {
  double sum = 0, count = 0, groups = 0, squares = 0;
  for (std::size_t i = 0; i < sums.size(); ++i)
    sum += sums[i], count += counts[i], groups += counts[i] > 0 ? 1 : 0;
  if (groups < 2) return std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double off = sums[i] - counts[i] * (sum / count);
    squares += off * off;
  }
  return std::sqrt(groups / (groups - 1) * squares) / count;
}

}  // namespace

Result<Difference> compare(const Image& a, const Image& b) {
  PILEUS_CHECK(checkComparable(a, b));
  Difference out;
  out.notFinite = countNotFinite(a, b);
  const Layer& reference = beauty(b);
  double squares = 0;
  int colors = 0;
  for (const Layer& layer : b.layers)
    for (int c = 0; c < layer.channels; ++c) {
      out.channels.push_back(channelDifference(*a.layer(layer.name), layer, c));
      const ChannelDifference& channel = out.channels.back();
      out.maximum = std::max(out.maximum, channel.maximum);
      if (&layer != &reference || c >= 3) continue;
      squares += channel.rmse * channel.rmse;
      ++colors;
    }
  out.rmse = std::sqrt(squares / colors);
  const Layer& picture = *a.layer(reference.name);
  const auto covered = relativeMse(picture, reference, true);
  // A wholly transparent reference must not make everything equal to it.
  out.relMse = covered ? *covered : relativeMse(picture, reference, false).value_or(0.0);
  return out;
}

Result<ScaledRelMse> scaledRelMse(const Image& a, const Image& b1, const Image& b2) {
  PILEUS_CHECK(checkSameSize(a, b1));
  PILEUS_CHECK(checkSameSize(a, b2));
  const Layer &p = beauty(a), &q1 = beauty(b1), &q2 = beauty(b2);
  const int colors = std::min(p.channels, 3);
  for (const Layer* q : {&q1, &q2})
    if (std::min(q->channels, 3) != colors)
      return fail(Code::Input, "the pictures have {} and {} colours", colors, std::min(q->channels, 3));
  const std::size_t pixels = p.pixels.size() / static_cast<std::size_t>(p.channels);
  const auto value = [](const Layer& layer, std::size_t pixel, int c) {
    return double(
        layer.pixels[pixel * static_cast<std::size_t>(layer.channels) + static_cast<std::size_t>(c)]);
  };
  ScaledRelMse out;
  std::vector<std::size_t> counting;  // an alpha that is no number counts, and is found below
  for (std::size_t i = 0; i < pixels; ++i)
    if (p.channels != 4 || !(p.pixels[4 * i + 3] <= 0.01f)) counting.push_back(i);
  out.pixels = counting.size();
  if (counting.empty()) return fail(Code::Input, "no pixel of the picture has an alpha above 0.01");
  bool finite = true;
  for (const std::size_t i : counting) {
    finite &= p.channels != 4 || std::isfinite(p.pixels[4 * i + 3]);
    for (int c = 0; c < colors; ++c) {
      out.meanA += value(p, i, c) / colors / double(out.pixels);
      out.meanB += (value(q1, i, c) + value(q2, i, c)) / 2 / colors / double(out.pixels);
    }
  }
  const double m = out.meanB;
  if (out.meanA != m) out.ratio = out.meanA / m;

  constexpr int kBlock = 4;
  const int across = (a.size.x + kBlock - 1) / kBlock, down = (a.size.y + kBlock - 1) / kBlock;
  const auto blocks = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
  std::vector<double> terms, sums(blocks), counts(blocks);
  for (const std::size_t i : counting) {
    double term = 0;
    for (int c = 0; c < colors; ++c) {
      const double x = value(p, i, c), y1 = value(q1, i, c), y2 = value(q2, i, c), y = (y1 + y2) / 2;
      const double product = (x - y1) * (x - y2);
      if (product != 0) term += product / (y * y + 0.01 * m * m) / colors;
    }
    const int column = static_cast<int>(i) % a.size.x, row = static_cast<int>(i) / a.size.x;
    const auto block = static_cast<std::size_t>(row / kBlock * across + column / kBlock);
    sums[block] += term, counts[block] += 1;
    terms.push_back(term);
    out.value += term / double(out.pixels);
  }
  out.standardError = standardErrorOf(sums, counts);
  if (!std::isfinite(out.standardError))
    out.standardError = standardErrorOf(terms, std::vector<double>(terms.size(), 1.0));
  if (!finite || !std::isfinite(out.value))
    out.value = out.standardError = std::numeric_limits<double>::infinity();
  return out;
}

Image blocksOf(const Image& picture, int edge) {
  Image out = picture;
  out.size = picture.size / edge;
  out.dataOrigin = out.displaySize = ivec2(0);
  out.layers.resize(1);
  const int channels = picture.layers[0].channels;
  std::vector<float>& to = out.layers[0].pixels;
  to.assign(std::size_t(out.size.x) * std::size_t(out.size.y) * std::size_t(channels), 0.0f);
  for (int y = 0; y < out.size.y * edge; ++y)
    for (int x = 0; x < out.size.x * edge; ++x)
      for (int c = 0; c < channels; ++c)
        to[std::size_t((y / edge * out.size.x + x / edge) * channels + c)] +=
            picture.layers[0].pixels[std::size_t((y * picture.size.x + x) * channels + c)] /
            float(edge * edge);
  return out;
}

}  // namespace pileus::image
