// Gain, OCIO display transform (its text, ocioDisplay, is put in front of this file), gamma, dither of one
// code value, channel, clip marks.
#include "shared/bindings.h"
in vec2 uv;
layout(location = 0) out vec4 color;
layout(binding = UNIT_PICTURE) uniform sampler2D picture;
uniform float gain, inverseGamma;
uniform int raw, channel, falseColor, zebra;  // channel: view::Channel
uniform vec2 range;                           // of data; y <= x: light
const int kBands = 15;
uniform vec3 bands[kBands];
const int kRed = 1, kBlue = 3, kAlpha = 4, kLuminance = 5, kTransmittance = 6;
uniform ivec2 pictureSize, outputSize;

// Bilinear when magnified, the mean of the covered texels when reduced.
vec4 resampled() {
  vec2 scale = vec2(pictureSize) / vec2(outputSize);
  vec2 lo = (uv - 0.5 / vec2(outputSize)) * vec2(pictureSize), hi = lo + scale;
  if (all(lessThanEqual(scale, vec2(1.0001)))) {
    if (pictureSize == outputSize) return texelFetch(picture, ivec2(uv * vec2(pictureSize)), 0);
    return textureLod(picture, uv, 0.0);
  }
  vec4 sum = vec4(0.0);
  float weight = 0.0;
  ivec2 a = max(ivec2(floor(lo)), ivec2(0)), b = min(ivec2(ceil(hi)), pictureSize);
  for (int y = a.y; y < b.y; ++y)
    for (int x = a.x; x < b.x; ++x) {
      vec2 overlap = min(vec2(x + 1, y + 1), hi) - max(vec2(x, y), lo);
      float w = max(overlap.x, 0.0) * max(overlap.y, 0.0);
      sum += w * texelFetch(picture, ivec2(x, y), 0);
      weight += w;
    }
  return sum / max(weight, 1e-9);
}

// Interleaved gradient noise (Jimenez 2014), zero mean, one code value of 8 bits wide.
float dither(vec2 p) {
  return (fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}

float luminance(vec3 c) { return dot(c, vec3(0.2722287, 0.6740818, 0.0536895)); }  // of ACEScg

vec3 viewed(vec3 light) {
  if (falseColor != 0) {
    float stops = log2(max(luminance(light), 1e-20) / 0.18);
    return bands[clamp(int(floor(stops + 0.5)) + kBands / 2, 0, kBands - 1)];
  }
  if (channel == kLuminance) light = vec3(luminance(light));
  if (raw != 0) return light;
#ifdef HAS_OCIO
  return ocioDisplay(vec4(light, 1.0)).rgb;
#else
  return light;
#endif
}

// Data of what covers `alpha` of the pixel: near is white, far dark, nothing black.
vec3 asData(float value, float alpha) {
  float t = clamp((value - range.x) / (range.y - range.x), 0.0, 1.0);
  return vec3(mix(1.0, 0.08, t) * clamp(alpha, 0.0, 1.0));
}

void main() {
  vec4 c = resampled();
  bool light = range.y <= range.x;
  vec3 shown;
  if (channel == kAlpha || channel == kTransmittance) {
    shown = vec3(channel == kAlpha ? c.a : 1.0 - c.a);
    light = false;
  } else {
    shown = light ? viewed(c.rgb * gain) : asData(c.r, c.a);
  }
  if (light && falseColor == 0 && inverseGamma != 1.0) shown = pow(max(shown, vec3(0.0)), vec3(inverseGamma));
  bool over = light && falseColor == 0 && any(greaterThanEqual(shown, vec3(0.9999))),
       under = light && falseColor == 0 && any(lessThan(shown, vec3(-0.0005)));
  shown += dither(gl_FragCoord.xy);
  if (channel >= kRed && channel <= kBlue) shown = vec3(shown[channel - kRed]);
  if (zebra != 0 && (over || under)) {
    bool stripe = mod(gl_FragCoord.x + (over ? gl_FragCoord.y : -gl_FragCoord.y), 8.0) < 4.0;
    shown = stripe ? (over ? vec3(0.90, 0.25, 0.20) : vec3(0.20, 0.45, 0.95)) : shown;
  }
  color = vec4(clamp(shown, 0.0, 1.0), 1.0);
}
