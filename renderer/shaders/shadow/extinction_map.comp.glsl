// Extinction map: optical depth of every volume along the texel's light ray, projected at u(x) in any order (gather: one thread a
// texel, float registers, one store). Projecting m = sigma ds keeps the end of the ray exact for any metric.
#include "lib/volume.glsl"
#include "lib/tiles.glsl"
#include "lib/shadow_map.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

#if STORE == STORE_FLOAT
layout(rgba32f, binding = IMAGE_TARGET) writeonly uniform image2DArray target;
#else
layout(rgba16f, binding = IMAGE_TARGET) writeonly uniform image2DArray target;
#endif
uniform ivec2 regionOrigin, regionEnd;
uniform float footprint;  // metres a texel covers

void main() {
  ivec2 texel = regionOrigin + ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, regionEnd))) return;
  BlockRecord block = lights[0].coefficients;
  float edge = float(block.place.z);
  vec2 uv = (vec2(texel) + 0.5) / edge;
  vec3 o = (lights[0].worldFromLight * vec4(uv, 0.0, 1.0)).xyz;
  vec3 end = (lights[0].worldFromLight * vec4(uv, 1.0, 1.0)).xyz;
  float rayLength = length(end - o);
  vec3 d = (end - o) / rayLength;
  float m[METRIC_FLOATS];
  for (int i = 0; i < METRIC_FLOATS; ++i) m[i] = 1.0;
  bool mixed = false;
  float covered = 0.0;  // end of the last interval
#if METRIC != METRIC_NONE
  loadMetric(0, uv, m);
#if METRIC == METRIC_INTERVAL
  for (int j = 0; j + 1 < METRIC_FLOATS; j += 2) covered = m[j + 1] > m[j] ? max(covered, m[j + 1]) : covered;
  for (int tap = 1; tap < 4; ++tap) {
    float neighbour[METRIC_FLOATS];
    loadMetric(0, uv + vec2(float(tap & 1), float(tap >> 1)) / edge, neighbour);
    mixed = mixed || !intervalsMatch(m, neighbour);
  }
#endif
#endif
  float c[BASIS_FLOATS];
  for (int i = 0; i < BASIS_FLOATS; ++i) c[i] = 0.0;

  ivec2 range = tileRange(texel);
  for (int item = range.x; item < range.y; ++item) {
    int v = tileItem(item);
    VolumeRay r;
    vec2 hit = enterVolume(v, o, d, levelFor(v, footprint), r);
    float t0 = max(hit.x, 0.0), t1 = min(hit.y, rayLength);
#if METRIC == METRIC_INTERVAL
    // Nothing lies outside the intervals (those of a half map are widened outwards).
    t0 = max(t0, m[0] * rayLength);
    t1 = min(t1, covered * rayLength);
#endif
    if (t0 >= t1) continue;
    int n = r.analytic ? 64 : int(clamp(ceil((t1 - t0) / stepFor(v, footprint)), 1.0, 8192.0));
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
      float u0 = metricU(METRIC, METRIC_COUNT, m, clamp((t0 + float(max(first, 0)) * ds) / rayLength, 0.0, 1.0));
      float u1 = metricU(METRIC, METRIC_COUNT, m, clamp((t0 + float(last) * ds) / rayLength, 0.0, 1.0));
      projectStep(BASIS, c, m0 * ds, u0, u1);
    } while (i < n);
  }
  for (int layer = 0; layer < (BASIS_FLOATS + 3) / 4; ++layer) {
    vec4 v = vec4(0.0);
    for (int j = 0; j < 4 && 4 * layer + j < BASIS_FLOATS; ++j) v[j] = c[4 * layer + j];
#if STORE == STORE_HALF
    v = clamp(v, -65504.0, 65504.0);
#endif
    if (layer == 0) v[mixedChannel(BASIS_FLOATS)] = withMixedBit(v[mixedChannel(BASIS_FLOATS)], mixed, STORE);
    imageStore(target, ivec3(block.place.xy + texel, block.place.w + layer), v);
  }
}
