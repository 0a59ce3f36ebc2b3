// Deep shadow map (Lokovic and Veach 2000): per texel a piecewise-linear transmittance over x, compressed in
// one pass so that it never errs by more than a bound: a window of slopes through the last vertex is narrowed
// until the next point would empty it. FILL 0 counts vertices (of the raw function too); FILL 1 writes them
// where the header says. FILTER: light rays along a texel's edge whose transmittance is averaged (the paper's
// prefiltering).
#include "lib/ordered_march.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
#if FILL
layout(rg32ui, binding = IMAGE_TARGET) writeonly uniform uimageBuffer vertices;
uniform int blockFirst;  // of the map in the buffer
#endif
// Kept, raw, doublings of the bound, first vertex; a layer for each face.
layout(rgba32ui, binding = IMAGE_TARGET + 1) uniform uimage2DArray counts;
uniform float errorBound;
uniform int nodeBudget, doublings;
const int kRays = FILTER * FILTER;

// The compressor: last vertex, window of slopes, last point seen.
float lastX = 0.0, lastT = 1.0, slopeLow = -1e30, slopeHigh = 1e30, seenX = 0.0, bound = 0.0;
int kept = 0, raw = 0, firstVertex = 0;

// The bound after so many doublings; one that is next to nothing starts from where floats can tell.
float boundAfter(int doublings) {
  return doublings == 0 ? errorBound : max(errorBound, 5e-5) * exp2(float(doublings));
}

void emit(float x, float T) {
#if FILL
  imageStore(vertices, blockFirst + firstVertex + kept,
             uvec4(floatBitsToUint(x), floatBitsToUint(T), 0u, 0u));
#endif
  ++kept;
  lastX = x, lastT = T;
  slopeLow = -1e30, slopeHigh = 1e30;
}

void addPoint(float x, float T) {
  if (x <= seenX) return;  // a jump of two rays at one place: the later one counts from here on
  ++raw;
  float d = x - lastX;
  float lo = max(slopeLow, (T - bound - lastT) / d), hi = min(slopeHigh, (T + bound - lastT) / d);
  if (lo > hi) {
    // Of all slopes that keep the bound the one nearest to where the function goes: the next line gets
    // further than from the middle.
    bool above = (T - bound - lastT) / d > slopeHigh;
    emit(seenX, lastT + (above ? slopeHigh : slopeLow) * (seenX - lastX));
    d = x - lastX;
    lo = (T - bound - lastT) / d, hi = (T + bound - lastT) / d;
  }
  slopeLow = lo, slopeHigh = hi;
  seenX = x;
}

void compress(MapTexel mt) {
  Stretch march[kRays];
  float T[kRays], a[kRays], b[kRays], depth[kRays];
  float length_ = 1.0;
  ivec2 range = tileRange(mt.tall);
  for (int r = 0; r < kRays; ++r) {
    vec2 uv = (vec2(mt.texel) + (vec2(float(r % FILTER), float(r / FILTER)) + 0.5) / float(FILTER)) /
              float(mapEdge);
    MapRay ray = mapRay(0, mt.face, uv, float(mapEdge));
    march[r] = beginMarch(ray, range);
    length_ = ray.tMax;
    T[r] = 1.0;
#if WINDOWED
    if (!firstWindow()) T[r] = windowStates[stateSlot(kRays + 8) + 8 + r];
#endif
    if (!nextStep(march[r], T[r], a[r], b[r], depth[r])) a[r] = 1e30;
  }
  kept = 0, raw = 0;
  bool begun = false;
#if WINDOWED
  int slot = stateSlot(kRays + 8);
  if (!firstWindow()) {
    lastX = windowStates[slot], lastT = windowStates[slot + 1];
    slopeLow = windowStates[slot + 2], slopeHigh = windowStates[slot + 3], seenX = windowStates[slot + 4];
    kept = int(windowStates[slot + 5]), raw = int(windowStates[slot + 6]);
    begun = windowStates[slot + 7] > 0.0;
  }
#endif
  int guard = 0;
  for (; guard < 262144; ++guard) {
    int r = 0;
    for (int k = 1; k < kRays; ++k) r = a[k] < a[r] ? k : r;
    if (a[r] >= 1e30) break;
    float mean = 0.0;
    for (int k = 0; k < kRays; ++k) mean += T[k] / float(kRays);
    float x0 = a[r] / length_, x1 = b[r] / length_;
    if (!begun) {
      begun = true;
      seenX = x0, raw = 1;
      emit(x0, mean);
    } else if (x0 > seenX + 1e-6) {
      addPoint(x0, mean);  // transmittance was constant up to here
    }
    float before = T[r];
    T[r] *= exp(-depth[r]);
    addPoint(x1, mean + (T[r] - before) / float(kRays));
    if (!nextStep(march[r], T[r], a[r], b[r], depth[r])) a[r] = 1e30;
  }
#if WINDOWED
  windowStates[slot] = lastX, windowStates[slot + 1] = lastT;
  windowStates[slot + 2] = slopeLow, windowStates[slot + 3] = slopeHigh, windowStates[slot + 4] = seenX;
  windowStates[slot + 5] = float(kept), windowStates[slot + 6] = float(raw);
  windowStates[slot + 7] = begun ? 1.0 : 0.0;
  for (int r = 0; r < kRays; ++r) windowStates[slot + 8 + r] = T[r];
#endif
  if (begun && seenX > lastX && lastWindow())
    emit(seenX, lastT + 0.5 * (slopeLow + slopeHigh) * (seenX - lastX));
}

void main() {
  MapTexel mt = mapTexelOf(gl_GlobalInvocationID.xy);
  if (!mt.valid) return;
  uvec4 count = uvec4(0u);
#if FILL
  count = imageLoad(counts, ivec3(mt.texel, mt.face));
  bound = boundAfter(int(count.z));
  firstVertex = int(count.w);
  if (count.x > 0u) compress(mt);
#else
  // One compression a dispatch: a texel over its budget is counted again by the next one, with twice the
  // bound.
  if (doublings > 0) {
    count = imageLoad(counts, ivec3(mt.texel, mt.face));
    if (int(count.x) <= nodeBudget) return;
  }
  bound = boundAfter(doublings);
  compress(mt);
  if (lastWindow())
    imageStore(counts, ivec3(mt.texel, mt.face), uvec4(uint(kept), uint(raw), uint(doublings), 0u));
#endif
}
