// Projects one volume's optical depth along a map's light ray on the basis: what gathering and splatting
// share. Variant constants: METRIC, METRIC_COUNT, BASIS, those of lib/metric.glsl and lib/basis.glsl,
// HORIZON.
#pragma once
#include "lib/volume.glsl"
#include "lib/map_texel.glsl"
#include "lib/metric.glsl"

// What one texel adds up. Behind the end of the last interval (a horizon) only the total is kept, and where
// it ends.
struct Projection {
  float c[BASIS_FLOATS];
  float behind;  // optical depth behind the horizon
  float last;    // x at which the media end
};

Projection emptyProjection() {
  Projection p;
  for (int i = 0; i < BASIS_FLOATS; ++i) p.c[i] = 0.0;
  p.behind = 0.0, p.last = 0.0;
  return p;
}

// Optical depth that is spread evenly from x0 to x1, within one interval of the metric.
void projectPart(float depth, float x0, float x1, float m[METRIC_FLOATS], float w[kIntervals],
                 inout Projection p) {
#if BASIS == BASIS_PIECEWISE
  // A step belongs to the interval of its middle; what sticks out of it is laid on its end.
  int count, j;
  float v, a, b;
  pieceOf(m, 0.5 * (x0 + x1), count, j, v);
  a = pieceBegin(m, j), b = pieceEnd(m, j);
  projectPiece(p.c, depth, count, j, clamp((x0 - a) / max(b - a, 1e-9), 0.0, 1.0),
               clamp((x1 - a) / max(b - a, 1e-9), 0.0, 1.0));
#else
  projectStep(BASIS, p.c, depth, metricU(METRIC, METRIC_COUNT, m, w, x0),
              metricU(METRIC, METRIC_COUNT, m, w, x1));
#endif
}

// The next interval that ends behind t, both in metres from `anchor`; behind the last one (a horizon) it has
// no end.
#if METRIC == METRIC_INTERVAL
vec2 intervalAt(float m[METRIC_FLOATS], float t, float anchor, float tMax) {
  vec2 next = vec2(1e30);
  for (int j = kIntervals - 1; j >= 0; --j) {
    vec2 interval = vec2(m[2 * j], m[2 * j + 1]) * tMax - anchor;
    next = m[2 * j + 1] > m[2 * j] && interval.y > t ? interval : next;
  }
  return next;
}
#endif

// Steps finer than a volume asks for where it is dense: in the part that a horizon cuts short.
const float kFrontSteps = 32.0;
// Of an analytic shape, over a part: extinction is constant, and so is all of u's slope but for a series'.
const int kAnalyticSteps = METRIC == METRIC_INTERVAL || METRIC == METRIC_NONE ? 1 : 64;

void projectVolume(int v, MapRay ray, float m[METRIC_FLOATS], float w[kIntervals], inout Projection p) {
  VolumeRay r;
  float size = footprintAt(0.0);
#if PERSPECTIVE
  size =
      footprintAt(0.5 * dot(vec2(1.0), clamp(extentOfVolume(v, ray.o, ray.d), vec2(0.0), vec2(ray.tMax))));
#endif
  vec2 hit = enterVolume(v, ray.o, ray.d, levelFor(v, size), r);
  // Metres count from the line's anchor.
  float t = max(hit.x, -r.anchor), t1 = min(hit.y, ray.tMax - r.anchor);
  float end = intervalsEnd(m) * ray.tMax - r.anchor, toX = 1.0 / ray.tMax, step_ = stepFor(v, size);
  if (t >= t1) return;
#if METRIC == METRIC_INTERVAL
  // Part by part over which u is linear. Nothing lies outside the intervals (those of a half map are widened
  // outwards) but behind a horizon, and between them what a coarse mip or rounding leaves there.
  t = r.analytic ? t : max(t, m[0] * ray.tMax - r.anchor);
#if !HORIZON
  t1 = min(t1, end);
#endif
  int part = 0;
  while (t < t1 && part < kIntervals + 3) {
    vec2 interval = intervalAt(m, t, r.anchor, ray.tMax);
    bool behind = interval.y > 1e29, dense = HORIZON != 0 && !behind && interval.y >= end && t1 > end;
    bool gap = dense && interval.x > t;
    float from = t, to = min(gap ? interval.x : interval.y, t1), least = dense && !gap ? kFrontSteps : 1.0;
#else
  {
    float from = t, to = t1, least = 1.0;
    const bool behind = false;
#endif
    int n = r.analytic ? kAnalyticSteps : int(clamp(ceil((to - from) / step_), least, 8192.0));
    float ds = (to - from) / float(n);
    // Neighbouring steps are projected together while they span little of a basis period; behind a horizon
    // only their sum counts.
    float share = 1.0;  // of u
#if METRIC == METRIC_INTERVAL && BASIS != BASIS_PIECEWISE
    share = metricU(METRIC, METRIC_COUNT, m, w, (r.anchor + to) * toX) -
            metricU(METRIC, METRIC_COUNT, m, w, (r.anchor + from) * toX);
#endif
    float fitting = float(n) / (float(4 * BASIS_FLOATS) * max(share, 1e-3));
    int chunk = behind ? 1 << 20 : int(clamp(fitting, 1.0, 8.0)), i = 0;
    do {
      // On to the next step with something in it: llvmpipe would project the empty ones too.
      float m0 = 0.0;
      int first = -1, last = 0;
      bool more;
      do {
        float at = from + (float(i) + 0.5) * ds;
        BrickPlace place = brickPlace(r, at);
        int next = stepAtOrBehind(i, emptyUntil(r, place), from, 0.5, ds);
        float here = mediumAt(r, place).w, sigma = next == i ? here : 0.0;
        first = first < 0 && sigma > 0.0 ? i : first;
        last = behind ? sigma > 0.0 ? i + 1 : last : next == i ? i + 1 : max(i, first);
        m0 += sigma;
        more = behind || first < 0 || (next == i && i + 1 - first < chunk);
        i = max(next, i + 1);
      } while (more && i < n);
      float x0 = clamp((r.anchor + (from + float(max(first, 0)) * ds)) * toX, 0.0, 1.0),
            x1 = clamp((r.anchor + (from + float(last) * ds)) * toX, 0.0, 1.0);
      float depth = m0 * ds;
#if HORIZON
      p.behind += behind ? depth : 0.0;
      p.last = depth > 0.0 ? max(p.last, x1) : p.last;
      depth = behind ? 0.0 : depth;
#endif
      projectPart(depth, x0, x1, m, w, p);
    } while (i < n);
#if METRIC == METRIC_INTERVAL
    t = to;
    ++part;
#endif
  }
}

// Coefficients 4 layer .. 4 layer + 3 as they are stored.
vec4 projectionLayer(Projection p, int layer) {
  vec4 v = vec4(0.0);
  for (int j = 0; j < 4 && 4 * layer + j < BASIS_FLOATS; ++j) v[j] = p.c[4 * layer + j];
#if DAMPING
  // Lanczos sigma factors sin(x)/x, x = k pi / (n + 1) for harmonic k of n.
#if BASIS != BASIS_PIECEWISE
  for (int j = 0; j < 4 && 4 * layer + j < BASIS_FLOATS; ++j) {
    int i = 4 * layer + j;
    float k = BASIS == BASIS_FOURIER ? float((i + 1) / 2) : float(i),
          most = BASIS == BASIS_FOURIER ? float(BASIS_FLOATS / 2) : float(BASIS_FLOATS - 1);
    float x = kPi * k / (most + 1.0);
    v[j] *= k > 0.0 && BASIS != BASIS_SLAB ? sin(x) / x : 1.0;
  }
#endif
#endif
#if STORE == STORE_HALF
  v = clamp(v, -65504.0, 65504.0);
#endif
  return v;
}
