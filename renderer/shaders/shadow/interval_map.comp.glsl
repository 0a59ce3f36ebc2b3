// Interval pseudometric: per light texel the union of what the volumes cover on its ray, reduced to INTERVALS
// by closing the smallest gaps. A grid covers its runs of occupied bricks (BRICKS 1) or its whole box. Layers
// hold (a0, b0, a1, b1), ...; unused intervals are a = b = 1. PROBES > 0: that many coarse samples of
// extinction over what is covered tell the intervals' weights (WEIGHTS 1: root of the mean extinction,
// relative to the largest, in 8 bits) and where the optical depth passes `horizon`: there the last interval
// ends.
#include "lib/volume.glsl"
#include "lib/tiles.glsl"
#include "lib/map_texel.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

#if STORE == STORE_FLOAT
layout(rgba32f, binding = IMAGE_TARGET) writeonly uniform image2DArray target;
#elif STORE == STORE_BYTE
layout(rgba8, binding = IMAGE_TARGET) writeonly uniform image2DArray target;
#else
layout(rgba16, binding = IMAGE_TARGET) writeonly uniform image2DArray target;
#endif
#if WEIGHTS
layout(rgba8, binding = IMAGE_TARGET + 1) writeonly uniform image2DArray weightTarget;
#endif
uniform float horizon;  // optical depth; 0: none

vec3 rayOrigin = vec3(0.0), rayDirection = vec3(0.0);
float rayLength = 1.0;

// The first part of volume v's coverage that ends behind x, from no earlier than x; (2, 2) if there is none.
vec2 coverageFrom(int v, float x) {
  VolumeRay r;
  vec2 hit = enterVolume(v, rayOrigin, rayDirection, 0, r);
  if (hit.x >= hit.y) return vec2(2.0);
  hit = clamp((r.anchor + hit) / rayLength, 0.0, 1.0);
  r = startingAt(r, -r.anchor);
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

#if PROBES
// Extinction at PROBES places spread over the intervals, at least two in each; `of`: the interval of a probe,
// `width` [x] what it stands for.
void probe(ivec2 range, float a[INTERVALS + 1], float b[INTERVALS + 1], int count, out float at[PROBES],
           out float width[PROBES], out int of[PROBES], out float sigma[PROBES]) {
  float covered = 0.0;
  for (int j = 0; j < INTERVALS; ++j) covered += j < count ? b[j] - a[j] : 0.0;
  int k = 0;
  for (int i = 0; i < PROBES; ++i) at[i] = 2.0, width[i] = 0.0, of[i] = 0, sigma[i] = 0.0;
  for (int j = 0; j < INTERVALS; ++j) {
    int n = j < count ? 2 + int(float(PROBES - 2 * INTERVALS) * (b[j] - a[j]) / max(covered, 1e-12)) : 0;
    for (int i = 0; i < n && k < PROBES; ++i) {
      width[k] = (b[j] - a[j]) / float(n);
      at[k] = a[j] + (float(i) + 0.5) * width[k];
      of[k] = j;
      ++k;
    }
  }
  for (int item = range.x; item < range.y; ++item) {
    int v = tileItem(item);
    VolumeRay r;
    vec2 hit =
        enterVolume(v, rayOrigin, rayDirection,
                    levelFor(v, max(footprintAt(a[0] * rayLength), covered * rayLength / float(PROBES))), r);
    for (int i = 0; i < PROBES; ++i) {
      if (i >= k) break;
      float t = at[i] * rayLength - r.anchor;
      sigma[i] += t >= hit.x && t <= hit.y ? sigmaAt(r, t) : 0.0;
    }
  }
}
#endif

void main() {
  MapTexel mt = mapTexelOf(gl_GlobalInvocationID.xy);
  if (!mt.valid) return;
  BlockRecord block = lights[0].metric;
  MapRay ray = mapRay(0, mt.face, texelUv(mt), float(mapEdge));
  rayOrigin = ray.o;
  rayDirection = ray.d;
  rayLength = ray.tMax;
  ivec2 range = tileRange(mt.tall);

  // Sorted disjoint union, swept without storing more than INTERVALS + 1: dropping the smallest gap whenever
  // one interval is too many leaves exactly the largest gaps, whatever the order of the volumes.
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
#if PROBES
  if (count > 0) {
    float at[PROBES], width[PROBES], sigma[PROBES];
    int of[PROBES];
    probe(range, a, b, count, at, width, of, sigma);
    if (horizon > 0.0) {
      float tau = 0.0;
      for (int i = 0; i < PROBES; ++i) {
        tau += sigma[i] * width[i] * rayLength;
        if (tau <= horizon) continue;
        b[of[i]] = at[i] + 0.5 * width[i];
        count = of[i] + 1;
        break;
      }
    }
#if WEIGHTS
    float w[INTERVALS], most = 0.0;
    for (int j = 0; j < INTERVALS; ++j) {
      float sum = 0.0, n = 0.0;
      for (int i = 0; i < PROBES; ++i) {
        bool mine = at[i] < 1.5 && of[i] == j && at[i] < b[j];
        sum += mine ? sigma[i] : 0.0;
        n += mine ? 1.0 : 0.0;
      }
      w[j] = j < count ? sqrt(sum / max(n, 1.0)) : 0.0;
      most = max(most, w[j]);
    }
    for (int layer = 0; layer < (INTERVALS + 3) / 4; ++layer) {
      vec4 v = vec4(1.0);
      for (int k = 0; k < 4 && 4 * layer + k < INTERVALS; ++k)
        v[k] = most > 0.0 ? max(round(255.0 * w[4 * layer + k] / most), 1.0) / 255.0 : 1.0;
      imageStore(weightTarget,
                 ivec3(lights[0].weights.xy + mt.texel,
                       lights[0].weights.w + mt.face * ((INTERVALS + 3) / 4) + layer),
                 v);
    }
#endif
  }
#endif
  for (int j = 0; j <= INTERVALS; ++j)
    if (j >= count) a[j] = b[j] = 1.0;
  for (int layer = 0; layer < (INTERVALS + 1) / 2; ++layer) {
    vec4 v = vec4(a[2 * layer], b[2 * layer], 1.0, 1.0);
    if (2 * layer + 1 < INTERVALS) v.zw = vec2(a[2 * layer + 1], b[2 * layer + 1]);
#if STORE != STORE_FLOAT
    const float steps = STORE == STORE_BYTE ? 255.0 : 65535.0;
    v.xz = floor(v.xz * steps) / steps;  // outwards, so that the stored interval still holds the medium
    v.yw = ceil(v.yw * steps) / steps;
#endif
    imageStore(target, ivec3(block.place.xy + mt.texel, block.place.w + mt.face * block.kind.y + layer), v);
  }
}
