// Exposure, OCIO display transform (its text, ocioDisplay, is put in front of this file), dither of one code value.
#include "shared/bindings.h"
in vec2 uv;
layout(location = 0) out vec4 color;
layout(binding = UNIT_PICTURE) uniform sampler2D picture;
uniform float gain;
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
float dither(vec2 p) { return (fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0; }

void main() {
  vec4 c = resampled();
#ifdef HAS_OCIO
  vec3 shown = ocioDisplay(vec4(c.rgb * gain, 1.0)).rgb;
#else
  vec3 shown = c.rgb * gain;
#endif
  color = vec4(clamp(shown + dither(gl_FragCoord.xy), 0.0, 1.0), 1.0);
}
