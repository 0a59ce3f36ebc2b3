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

void projectVolume(int v, MapRay ray, float m[METRIC_FLOATS], float w[kIntervals], inout Projection p) {
  VolumeRay r;
  float size = footprintAt(0.0);
#if PERSPECTIVE
  size =
      footprintAt(0.5 * dot(vec2(1.0), clamp(extentOfVolume(v, ray.o, ray.d), vec2(0.0), vec2(ray.tMax))));
#endif
  vec2 hit = enterVolume(v, ray.o, ray.d, levelFor(v, size), r);
  // Metres count from the line's anchor.
  float t0 = max(hit.x, -r.anchor), t1 = min(hit.y, ray.tMax - r.anchor), end = intervalsEnd(m);
#if METRIC == METRIC_INTERVAL
  // Nothing lies outside the intervals (those of a half map are widened outwards), but behind a horizon.
  t0 = max(t0, m[0] * ray.tMax - r.anchor);
#if !HORIZON
  t1 = min(t1, end * ray.tMax - r.anchor);
#endif
#endif
  if (t0 >= t1) return;
  int n = r.analytic ? 64 : int(clamp(ceil((t1 - t0) / stepFor(v, size)), 1.0, 8192.0));
  float ds = (t1 - t0) / float(n);
  // Neighbouring steps are projected together while they span little of a basis period.
  int chunk = clamp(n / (4 * BASIS_FLOATS), 1, 8);
  int i = 0;
  do {
    // On to the next step with something in it: llvmpipe would project the empty ones too.
    float m0 = 0.0;
    int first = -1, last = 0;
    bool more;
    do {
      float t = t0 + (float(i) + 0.5) * ds;
      int next = stepAtOrBehind(i, emptyUntil(r, t), t0, 0.5, ds);
      float sigma = next == i ? sigmaAt(r, t) : 0.0;
      first = first < 0 && sigma > 0.0 ? i : first;
      last = next == i ? i + 1 : max(i, first);
      m0 += sigma;
      more = first < 0 || (next == i && i + 1 - first < chunk);
      i = max(next, i + 1);
    } while (more && i < n);
    float x0 = clamp((r.anchor + (t0 + float(max(first, 0)) * ds)) / ray.tMax, 0.0, 1.0),
          x1 = clamp((r.anchor + (t0 + float(last) * ds)) / ray.tMax, 0.0, 1.0);
    float depth = m0 * ds;
#if HORIZON
    float front = clamp((end - x0) / max(x1 - x0, 1e-12), 0.0, 1.0);
    p.behind += depth * (1.0 - front);
    p.last = depth > 0.0 ? max(p.last, x1) : p.last;
    depth *= front;
#endif
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
  } while (i < n);
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
