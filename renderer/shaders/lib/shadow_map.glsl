// Reading shadow maps: lookupTransmittance is the one interface of all representations that keep something in
// the store. Variant constants (shadow::lookupDefines): METRIC_FLOATS and BASIS_FLOATS (largest of the lights
// present), STORES, WEIGHTS, HORIZON, LOOKUP_BASES (bit per BASIS_* of the extinction maps present),
// LIGHT_KINDS (bit SHADOW_* for each kind present), and where all mapped lights agree (UNIFORM_MAPS) their
// METRIC, METRIC_COUNT, BASIS, COEFFICIENTS, so that nothing else is compiled in.
#pragma once
#include "lib/shadow_blocks.glsl"
#include "lib/mixed_bit.glsl"

// Per map: headers (first vertex, count), then vertices (x, T).
layout(binding = UNIT_SHADOW_DEEP) uniform usamplerBuffer shadowDeep;

#ifdef UNIFORM_MAPS
int metricOf(int light) { return METRIC; }
int metricCountOf(int light) { return METRIC_COUNT; }
int basisOf(int light) { return BASIS; }
int coefficientsOf(int light) { return COEFFICIENTS; }
int coefficientStoreOf(int light) { return COEFFICIENT_STORE; }
int coefficientLayersOf(int light) { return (COEFFICIENTS + 3) / 4; }
#else
int metricOf(int light) { return lights[light].shadow.w; }
int metricCountOf(int light) { return lights[light].items.x; }
int basisOf(int light) { return lights[light].shadow.y; }
int coefficientsOf(int light) { return lights[light].shadow.z; }
int coefficientStoreOf(int light) { return lights[light].coefficients.kind.x; }
int coefficientLayersOf(int light) { return lights[light].coefficients.kind.y; }
#endif

// At `at` [texels of the coefficients' block].
void loadCoefficients(int light, int face, vec2 at, out float c[BASIS_FLOATS]) {
  ivec4 place = lights[light].coefficients.place;
  int layers = coefficientLayersOf(light);
  place.w += face * layers;
  int store = coefficientStoreOf(light);
  for (int i = 0; i < BASIS_FLOATS; i += 4) {
    vec4 v = sampleBlock(place, store, at, min(i / 4, layers - 1));
    for (int j = 0; j < 4 && i + j < BASIS_FLOATS; ++j) c[i + j] = v[j];
  }
}

// Optical depth at x by the metric and coefficients at `at` [texels of the coefficients' block]. `covers`:
// the ray meets a medium at all. What needs no coefficient is worked out before they are read, which takes as
// long.
float extinctionTau(int light, int face, vec2 at, float x, out bool covers) {
  float m[METRIC_FLOATS], w[kIntervals], c[BASIS_FLOATS];
  for (int i = 0; i < METRIC_FLOATS; ++i) m[i] = 1.0;
  for (int i = 0; i < kIntervals; ++i) w[i] = 1.0;
  int metric = metricOf(light);
  if (metric != METRIC_NONE)
    loadMetricAt(light, face,
                 at * (float(lights[light].metric.place.z) / float(lights[light].coefficients.place.z)), m,
                 w);
#if LOOKUP_BASES & ~PIECEWISE_BASES
  BasisPhase phase = basisPhase(basisOf(light), metricU(metric, metricCountOf(light), m, w, x));
#endif
  loadCoefficients(light, face, at, c);
  covers = metric != METRIC_INTERVAL || m[1] > m[0];
  float tau = 0.0;
#if LOOKUP_BASES & PIECEWISE_BASES
  if (basisOf(light) == BASIS_PIECEWISE) {
    int count, j;
    float v;
    pieceOf(m, x, count, j, v);
    tau = pieceTau(coefficientsOf(light), c, count, j, v);
  }
#endif
#if LOOKUP_BASES & ~PIECEWISE_BASES
#if LOOKUP_BASES & PIECEWISE_BASES
  if (basisOf(light) != BASIS_PIECEWISE)
#endif
    tau = basisTau(basisOf(light), coefficientsOf(light), c, phase);
#endif
#if HORIZON
  // Behind the horizon: a ramp from what is in front of it to all there is.
  if ((lights[light].solids.z & LIGHT_HAS_HORIZON) != 0) {
    vec2 h = textureLod(shadowPair,
                        storeCoordinates(lights[light].horizon, at, face, textureSize(shadowPair, 0)), 0.0)
                 .xy;
    float end = intervalsEnd(m);
    tau += x > end ? max(h.x - tau, 0.0) * clamp((x - end) / max(h.y, 1e-7), 0.0, 1.0) : 0.0;
  }
#endif
  return tau;
}

// Within one kind of metric the hardware blends metric and coefficients and they are evaluated once; at
// silhouettes two rows, two columns or four texels are evaluated each by its own metric and transmittance is
// blended. `inMedium`: what is lit lies in a medium, so that a texel whose ray meets none says nothing about
// it; to a surface such a texel is as good as any.
float lookupExtinction(int light, int face, vec2 uv, float x, bool inMedium) {
  ivec4 place = lights[light].coefficients.place;
  int store = coefficientStoreOf(light), blend = BLEND_WHOLE;
  vec2 at = uv * float(place.z), f = at - 0.5, base = floor(f), w = f - base;
  if (metricOf(light) == METRIC_INTERVAL)
    blend = blendOf(lowBits(place, store, base, face * coefficientLayersOf(light)), coefficientsOf(light));
  int taps = blend == BLEND_WHOLE ? 1 : blend == BLEND_NONE ? 4 : 2;
  // Axes along which texels are taken one by one; along the others the hardware blends, all at the first tap.
  bvec2 single =
      bvec2(blend == BLEND_NONE || blend == BLEND_COLUMNS, blend == BLEND_NONE || blend == BLEND_ROWS);
  // Place of the first tap, share of the second along each axis.
  vec2 first = mix(at, base + 0.5, single), second = mix(vec2(0.0), w, single);
  float transmittance = 0.0, weights = 0.0;
  int tap = 0;
  do {
    vec2 o = vec2(float(blend == BLEND_ROWS ? 0 : tap & 1), float(blend == BLEND_ROWS ? tap : tap >> 1));
    bool covers;
    float T = exp(-extinctionTau(light, face, first + o, x, covers));
    vec2 share = mix(1.0 - second, second, o);
    float weight = (share.x * share.y + 1e-6) * (covers || !inMedium ? 1.0 : 1e-6);
    transmittance += weight * T;
    weights += weight;
    ++tap;
  } while (tap < taps);
  return transmittance / weights;
}

// The stored series is transmittance itself: linear, so the hardware's blend is right.
float lookupSeries(int light, int face, vec2 uv, float x) {
  float c[BASIS_FLOATS];
  loadCoefficients(light, face, uv * float(lights[light].coefficients.place.z), c);
  return clamp(basisValue(basisOf(light), coefficientsOf(light), c, x), 0.0, 1.0);
}

vec2 deepVertex(int i) { return uintBitsToFloat(texelFetch(shadowDeep, i).xy); }

// Transmittance of one texel's vertices at x: binary search, then a straight line.
float deepTransmittance(int base, ivec2 texel, int edge, int face, float x) {
  texel = clamp(texel, ivec2(0), ivec2(edge - 1));
  uvec2 header = texelFetch(shadowDeep, base + (face * edge + texel.y) * edge + texel.x).xy;
  int first = base + int(header.x), lo = 0, hi = max(int(header.y) - 1, 0);
  if (header.y == 0u) return 1.0;
  do {
    int middle = (lo + hi + 1) / 2;
    bool behind = deepVertex(first + middle).x <= x;
    lo = behind ? middle : lo;
    hi = behind ? hi : max(middle - 1, lo);
  } while (lo < hi);
  vec2 a = deepVertex(first + lo), b = deepVertex(first + min(lo + 1, int(header.y) - 1));
  // Within its bound a vertex may lie outside.
  return clamp(mix(a.y, b.y, clamp((x - a.x) / max(b.x - a.x, 1e-9), 0.0, 1.0)), 0.0, 1.0);
}

// Transmittances of the four texels are blended, never vertices.
float lookupDeep(int light, int face, vec2 uv, float x) {
  int edge = lights[light].coefficients.place.z, base = lights[light].items.y;
  vec2 f = clamp(uv * float(edge), vec2(0.5), vec2(float(edge) - 0.5)) - 0.5, o = floor(f), w = f - o;
  float T = 0.0;
  int tap = 0;
  do {
    ivec2 d = ivec2(tap & 1, tap >> 1);
    float weight = (d.x == 1 ? w.x : 1.0 - w.x) * (d.y == 1 ? w.y : 1.0 - w.y);
    T += weight * deepTransmittance(base, ivec2(o) + d, edge, face, x);
    ++tap;
  } while (tap < 4);
  return clamp(T, 0.0, 1.0);
}

// Transmittance between the light and a world position, by the light's map of whatever kind.
float lookupTransmittance(int light, vec3 world, bool inMedium) {
  int face;
  vec3 q = mapCoordinates(light, world, float(lights[light].coefficients.place.z), face);
  float x = clamp(q.z, 0.0, 1.0), T = 1.0;
  int kind = lights[light].shadow.x;
#if (LIGHT_KINDS & MAPPED_SHADOWS) == (1 << SHADOW_EXTINCTION)
  T = lookupExtinction(light, face, q.xy, x, inMedium);
#else
#if HAS_SHADOW(SHADOW_EXTINCTION)
  if (kind == SHADOW_EXTINCTION) T = lookupExtinction(light, face, q.xy, x, inMedium);
#endif
#if HAS_SHADOW(SHADOW_TRANSMITTANCE)
  if (kind == SHADOW_TRANSMITTANCE) T = lookupSeries(light, face, q.xy, x);
#endif
#if HAS_SHADOW(SHADOW_DEEP)
  if (kind == SHADOW_DEEP) T = lookupDeep(light, face, q.xy, x);
#endif
#endif
  bool outside = any(lessThan(q.xy, vec2(0.0))) || any(greaterThan(q.xy, vec2(1.0))) || q.z <= 0.0;
  return outside ? 1.0 : T;
}
