// Interval pseudometric: per light texel the union of the volumes' extents on its ray, reduced to INTERVALS by closing the smallest
// gaps. Layers hold (a0, b0, a1, b1), ...; unused intervals are a = b = 1.
#include "lib/volume.glsl"
#include "lib/tiles.glsl"
#include "shared/records.h"
layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, binding = BIND_LIGHTS) readonly buffer LightBuffer { LightRecord lights[]; };
#if STORE == STORE_FLOAT
layout(rgba32f, binding = IMAGE_TARGET) writeonly uniform image2DArray target;
#else
layout(rgba16, binding = IMAGE_TARGET) writeonly uniform image2DArray target;
#endif
uniform ivec2 regionOrigin, regionEnd;

vec3 rayOrigin = vec3(0.0), rayDirection = vec3(0.0);
float rayLength = 1.0;

vec2 extentOf(int v) {
  vec2 hit = extentOfVolume(v, rayOrigin, rayDirection);
  return hit.x < hit.y ? clamp(hit / rayLength, 0.0, 1.0) : vec2(1.0);
}

void main() {
  ivec2 texel = regionOrigin + ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, regionEnd))) return;
  BlockRecord block = lights[0].metric;
  vec2 uv = (vec2(texel) + 0.5) / float(block.place.z);
  rayOrigin = (lights[0].worldFromLight * vec4(uv, 0.0, 1.0)).xyz;
  vec3 end = (lights[0].worldFromLight * vec4(uv, 1.0, 1.0)).xyz;
  rayLength = length(end - rayOrigin);
  rayDirection = (end - rayOrigin) / rayLength;
  ivec2 range = tileRange(texel);

  // Sorted disjoint union, swept without storing more than INTERVALS + 1: dropping the smallest gap whenever one interval is too many
  // leaves exactly the largest gaps, whatever the order of the volumes.
  float a[INTERVALS + 1], b[INTERVALS + 1];
  int count = 0;
  float behind = -1.0;
  for (int guard = 0; guard < 65536; ++guard) {
    float lo = 2.0;
    for (int i = range.x; i < range.y; ++i) {
      vec2 e = extentOf(tileItems[i]);
      if (e.y > e.x && e.x > behind && e.x < lo) lo = e.x;
    }
    if (lo > 1.0) break;
    float hi = lo;
    for (bool grown = true; grown;) {
      grown = false;
      for (int i = range.x; i < range.y; ++i) {
        vec2 e = extentOf(tileItems[i]);
        if (e.y > e.x && e.x <= hi && e.y > hi) {
          hi = e.y;
          grown = true;
        }
      }
    }
    a[count] = lo, b[count] = hi;
    ++count;
    behind = hi;
    if (count > INTERVALS) {
      int smallest = 0;
      for (int j = 1; j < INTERVALS; ++j)
        if (a[j + 1] - b[j] < a[smallest + 1] - b[smallest]) smallest = j;
      b[smallest] = b[smallest + 1];
      for (int j = 1; j < INTERVALS; ++j)
        if (j > smallest) a[j] = a[j + 1], b[j] = b[j + 1];
      --count;
    }
  }
  for (int j = 0; j <= INTERVALS; ++j)
    if (j >= count) a[j] = b[j] = 1.0;
  for (int layer = 0; layer < (INTERVALS + 1) / 2; ++layer) {
    vec4 v = vec4(a[2 * layer], b[2 * layer], 1.0, 1.0);
    if (2 * layer + 1 < INTERVALS) v.zw = vec2(a[2 * layer + 1], b[2 * layer + 1]);
#if STORE == STORE_UNORM
    v.xz = floor(v.xz * 65535.0) / 65535.0;  // outwards, so that the stored interval still holds the medium
    v.yw = ceil(v.yw * 65535.0) / 65535.0;
#endif
    imageStore(target, ivec3(block.place.xy + texel, block.place.w + layer), v);
  }
}
