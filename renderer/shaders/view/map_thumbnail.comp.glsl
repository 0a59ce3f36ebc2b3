// Tiles of a shadow map, one for each value of a texel: a work group looks at the whole map for the largest
// value, then colours it.
#include "shared/bindings.h"

#define SIGNED 0
#define ENDS 1
#define DEEP 2

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = UNIT_PICTURE) uniform sampler2DArray map;
layout(binding = UNIT_SHADOW_DEEP) uniform usamplerBuffer deep;
layout(rgba8, binding = IMAGE_TARGET) writeonly uniform image2D target;
uniform ivec4 place;      // x, y: first texel; z: edge; w: first layer, or the first deep element
uniform int mode, tileEdge;
uniform vec3 low, middle, high, nothing;

shared float largest[256];

float end(ivec2 texel, int i) { return texelFetch(map, ivec3(place.xy + texel, place.w + i / 4), 0)[i % 4]; }

// Value i of a texel; y: is there any?
vec2 valueAt(ivec2 texel, int i) {
  if (mode == DEEP) {
    uvec2 header = texelFetch(deep, place.w + texel.y * place.z + texel.x).xy;
    if (i == 0) return vec2(float(header.y), 1.0);
    return vec2(header.y > 0u ? uintBitsToFloat(texelFetch(deep, int(header.x + header.y) - 1).y) : 1.0, 1.0);
  }
  float v = end(texel, i);
  if (mode == ENDS) return vec2(v, end(texel, i / 2 * 2 + 1) > end(texel, i / 2 * 2) ? 1.0 : 0.0);
  return vec2(v, 1.0);
}

vec3 shade(float v) {
  if (mode == SIGNED) return v < 0.0 ? mix(middle, low, min(-v, 1.0)) : mix(middle, high, min(v, 1.0));
  return v < 0.5 ? mix(low, middle, 2.0 * clamp(v, 0.0, 1.0))
                 : mix(middle, high, 2.0 * clamp(v, 0.0, 1.0) - 1.0);
}

void main() {
  int i = int(gl_WorkGroupID.x);
  uint lane = gl_LocalInvocationIndex;
  int stride = max(place.z / 64, 1);  // 64 samples a side tell the largest well enough
  float most = 0.0;
  for (int y = int(gl_LocalInvocationID.y) * stride; y < place.z; y += 16 * stride)
    for (int x = int(gl_LocalInvocationID.x) * stride; x < place.z; x += 16 * stride)
      most = max(most, abs(valueAt(ivec2(x, y), i).x));
  largest[lane] = most;
  barrier();
  for (uint s = 128u; s > 0u; s >>= 1) {
    if (lane < s) largest[lane] = max(largest[lane], largest[lane + s]);
    barrier();
  }
  bool unit = mode == ENDS || (mode == DEEP && i == 1);
  float scale = unit ? 1.0 : 1.0 / max(largest[0], 1e-12);
  for (int y = int(gl_LocalInvocationID.y); y < tileEdge; y += 16)
    for (int x = int(gl_LocalInvocationID.x); x < tileEdge; x += 16) {
      ivec2 texel = min(ivec2((vec2(x, y) + 0.5) * float(place.z) / float(tileEdge)), ivec2(place.z - 1));
      vec2 v = valueAt(texel, i);
      imageStore(target, ivec2(i * tileEdge + x, y), vec4(v.y > 0.0 ? shade(v.x * scale) : nothing, 1.0));
    }
}
