// Interval pseudometric: per light texel the union of what the volumes cover on its ray, reduced to INTERVALS
// by closing the smallest gaps. A grid covers its runs of occupied bricks (BRICKS 1) or its whole box. Layers
// hold (a0, b0, a1, b1), ...; unused intervals are a = b = 1. PROBES > 0: that many coarse samples of
// extinction over what is covered tell the intervals' weights (WEIGHTS 1: relative to the largest, their
// fourth roots in 8 bits) and where the optical depth passes `horizon`: there the last interval ends. Where a
// single sample stands for too much to tell, the part in front of it is sampled again.
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
// Bricks are counted and walls follow from their numbers: no error adds up, and every step gets on. Where a
// run ends is the same number whenever it is asked for, so that x may be the end of one.
vec2 coverageFrom(int v, float x) {
  VolumeRay r;
  vec2 hit = enterVolume(v, rayOrigin, rayDirection, 0, r);
  hit = clamp(hit, vec2(-r.anchor), vec2(rayLength - r.anchor));
  float from = r.anchor + hit.x, lo = max(from / rayLength, x), hi = (r.anchor + hit.y) / rayLength;
  bool covers = hit.x < hit.y && hi > lo;
#if BRICKS
  // s metres along the chord, whose first point is q in voxels.
  vec3 q = r.o + hit.x * r.d;
  float s = max(x * rayLength - from, 0.0), end = hit.y - hit.x, begin = 0.0, until = 0.0;
  ivec3 ahead = ivec3(greaterThan(r.d, vec3(0.0))), most = max(r.bricks - 1, ivec3(0)),
        b = clamp(brickAt(q + s * r.d), ivec3(0), most);
  bvec3 level = lessThan(abs(r.d), vec3(1e-30));
  bool found = false, open = !r.analytic && covers;
  int guard = r.bricks.x + r.bricks.y + r.bricks.z + 3;
  while (open && guard > 0) {
    ivec3 wall = b + ahead;
    // In front of the lattice the first brick answers (brickAt).
    vec3 at = mix(vec3(wall) * kBrick, vec3(-1.0), equal(wall, ivec3(0)));
    vec3 cross_ = mix((at - q) / r.d, vec3(1e30), level);
    float leave = min(min(cross_.x, cross_.y), cross_.z);
    bool empty = emptyPage(r, pageOf(r, b)), over = found && empty && (from + until) / rayLength > x;
    begin = found ? begin : s;
    found = over || !empty;
    until = empty ? until : min(leave, end);
    s = leave;
    b += ivec3(equal(cross_, vec3(leave))) * (2 * ahead - 1);
    open = !over && leave < end && all(greaterThanEqual(b, ivec3(0))) && all(lessThanEqual(b, most));
    --guard;
  }
  if (!r.analytic) {
    lo = max((from + begin) / rayLength, x);
    hi = until < end ? (from + until) / rayLength : hi;
    covers = found && hi > lo;
  }
#endif
  return covers ? vec2(lo, hi) : vec2(2.0);
}

#if PROBES
const float kDepthOfProbe = 2.0;  // at the horizon, at most
const int kProbings = 12;

// Extinction at PROBES places spread over the intervals, at least two in each, half of them in the last one
// where it was cut `finely`; `of`: the interval of a probe, `width` [x] what it stands for.
void probe(ivec2 range, float a[INTERVALS + 1], float b[INTERVALS + 1], int count, bool finely,
           out float at[PROBES], out float width[PROBES], out int of[PROBES], out float sigma[PROBES]) {
  float covered = 0.0, last = 0.0;
  for (int j = 0; j < INTERVALS; ++j) {
    covered += j < count ? b[j] - a[j] : 0.0;
    last = j + 1 == count ? b[j] - a[j] : last;
  }
  bool halves = finely && count > 1;
  float others = max(halves ? 2.0 * (covered - last) : covered, 1e-30);
  int k = 0;
  for (int i = 0; i < PROBES; ++i) at[i] = 2.0, width[i] = 0.0, of[i] = 0, sigma[i] = 0.0;
  for (int j = 0; j < INTERVALS; ++j) {
    float share = halves && j + 1 == count ? 0.5 : (b[j] - a[j]) / others;
    int n = j < count ? 2 + int(float(PROBES - 2 * INTERVALS) * share) : 0;
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
  float at[PROBES], width[PROBES], sigma[PROBES];
  int of[PROBES], probings = 0;
  bool finely = false, again = count > 0;
  while (again) {
    probe(range, a, b, count, finely, at, width, of, sigma);
    // The probe in which the optical depth passes the horizon, and the first of its interval with a medium.
    float tau = 0.0, before = 0.0, holds = 0.0, place = 2.0, wide = 0.0, first = 2.0;
    int cut = 0;
    for (int i = 0; i < PROBES; ++i) {
      float depth = sigma[i] * width[i] * rayLength;
      bool searching = place > 1.5, here = searching && horizon > 0.0 && tau + depth > horizon;
      first = searching && of[i] != cut ? 2.0 : first;
      first = searching && first > 1.5 && sigma[i] > 0.0 ? at[i] - 1.5 * width[i] : first;
      cut = searching ? of[i] : cut;
      before = here ? tau : before;
      holds = here ? depth : holds;
      wide = here ? width[i] : wide;
      place = here ? at[i] : place;
      tau += depth;
    }
    ++probings;
    again = place < 1.5 && holds > kDepthOfProbe && wide > 2e-6 * place && probings < kProbings;
    for (int j = 0; j < INTERVALS; ++j) {
      if (place > 1.5 || j != cut) continue;
      // A probe more, as long as one says little of the place; in the end as if constant within one.
      b[j] = min(b[j], again ? place + 1.5 * wide : place + wide * ((horizon - before) / holds - 0.5));
      a[j] = again || finely ? clamp(first, a[j], b[j]) : a[j];
      count = j + 1;
    }
    finely = finely || again;
  }
#if WEIGHTS
  // The root of the mean extinction. Where a dense medium was cut short it would hardly get a share of u:
  // shares go by optical depth then.
  float w[INTERVALS], most = 0.0;
  for (int j = 0; j < INTERVALS; ++j) {
    float sum = 0.0, n = 0.0;
    for (int i = 0; i < PROBES; ++i) {
      bool mine = j < count && at[i] < 1.5 && of[i] == j && at[i] < b[j];
      sum += mine ? sigma[i] : 0.0;
      n += mine ? 1.0 : 0.0;
    }
    float mean = sum / max(n, 1.0);
    w[j] = j < count ? finely ? mean : sqrt(mean) : 0.0;
    most = max(most, w[j]);
  }
  for (int layer = 0; layer < (INTERVALS + 3) / 4; ++layer) {
    vec4 v = vec4(1.0);
    for (int k = 0; k < 4 && 4 * layer + k < INTERVALS; ++k)
      v[k] = most > 0.0 ? max(round(255.0 * sqrt(sqrt(w[4 * layer + k] / most))), 1.0) / 255.0 : 1.0;
    imageStore(weightTarget,
               ivec3(lights[0].weights.xy + mt.texel,
                     lights[0].weights.w + mt.face * ((INTERVALS + 3) / 4) + layer),
               v);
  }
#endif
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
