// Interval pseudometric: per light texel the union of what the volumes cover on its ray, reduced to INTERVALS by closing the smallest
// gaps. A grid covers its runs of occupied bricks (BRICKS 1) or its whole box. Layers hold (a0, b0, a1, b1), ...; unused intervals are
// a = b = 1.
#include "lib/volume.glsl"
#include "lib/tiles.glsl"
#include "shared/records.h"
layout(local_size_x = 8, local_size_y = 8) in;

layout(std140, binding = BIND_LIGHTS) uniform LightBlock { LightRecord lights[MAX_LIGHTS]; };
#if STORE == STORE_FLOAT
layout(rgba32f, binding = IMAGE_TARGET) writeonly uniform image2DArray target;
#else
layout(rgba16, binding = IMAGE_TARGET) writeonly uniform image2DArray target;
#endif
uniform ivec2 regionOrigin, regionEnd;

vec3 rayOrigin = vec3(0.0), rayDirection = vec3(0.0);
float rayLength = 1.0;

// The first part of volume v's coverage that ends behind x, from no earlier than x; (2, 2) if there is none.
vec2 coverageFrom(int v, float x) {
  VolumeRay r;
  vec2 hit = enterVolume(v, rayOrigin, rayDirection, 0, r);
  if (hit.x >= hit.y) return vec2(2.0);
  hit = clamp(hit / rayLength, 0.0, 1.0);
  float lo = max(hit.x, x), hi = hit.y;
#if BRICKS
  float t = lo * rayLength, end = hi * rayLength, begin = t, nudge = 1e-3 * detailOf(v);
  bool found = r.analytic, open = !r.analytic && t < end;
  int guard = 0;
  while (open && guard < 8192) {
    float out_ = leaveBrick(r, t);
    bool empty = emptyBrick(r, t);
    begin = found ? begin : empty ? out_ : t;
    open = !(found && empty) && out_ < end;
    hi = found && empty ? t / rayLength : hi;
    found = found || !empty;
    t = max(out_, t) + nudge;
    ++guard;
  }
  if (!found) return vec2(2.0);
  lo = r.analytic ? lo : min(begin / rayLength, 1.0);
#endif
  return hi > lo && hi > x ? vec2(lo, hi) : vec2(2.0);
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
  for (int guard = 0; guard < 4096; ++guard) {
    float lo = 2.0;
    for (int i = range.x; i < range.y; ++i) {
      vec2 e = coverageFrom(tileItem(i), behind);
      lo = min(lo, e.x);
    }
    if (lo >= 1.0) break;
    float hi = lo;
    for (bool grown = true; grown;) {
      grown = false;
      for (int i = range.x; i < range.y; ++i) {
        vec2 e = coverageFrom(tileItem(i), hi);
        if (e.x <= hi + 1e-6 && e.y > hi) {
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
