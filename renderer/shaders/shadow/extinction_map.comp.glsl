// Extinction map: optical depth of every volume along the texel's light ray, projected at u(x) in any order
// (gather: one thread a texel, float registers, one store). Projecting m = sigma ds keeps the end of the ray
// exact for any metric. BATCHED 1: so many volumes that llvmpipe would end the loops early (65535 iterations
// an invocation): a dispatch takes batch.y volumes of each list, and sums wait in `sums` for the next one.
#include "lib/tiles.glsl"
#include "lib/shadow_blocks.glsl"
#include "lib/footprint.glsl"
#include "lib/project_volume.glsl"
#include "lib/coefficient_target.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

#if HORIZON
layout(rg16f, binding = IMAGE_TARGET + 1) writeonly uniform image2DArray horizonTarget;
#endif

#if BATCHED
#include "shared/resume.h"
layout(std430, binding = BIND_MARCH_STATES) buffer Sums { float sums[]; };
uniform ivec2 batch;  // its number, volumes in each
#endif

void main() {
  MapTexel mt = mapTexelOf(gl_GlobalInvocationID.xy);
  if (!mt.valid) return;
  BlockRecord block = lights[0].coefficients;
  vec2 uv = texelUv(mt);
  MapRay ray = mapRay(0, mt.face, uv, float(mapEdge));
  float m[METRIC_FLOATS], w[kIntervals];
  for (int i = 0; i < METRIC_FLOATS; ++i) m[i] = 1.0;
  for (int i = 0; i < kIntervals; ++i) w[i] = 1.0;
  int blend = BLEND_WHOLE;
#if METRIC != METRIC_NONE
  loadMetric(0, mt.face, uv, m, w);
#if METRIC == METRIC_INTERVAL
  blend = footprintBlend(mt.face, uv, 1.0 / float(mapEdge), m, w);
#endif
#endif
  Projection p = emptyProjection();
  ivec2 range = tileRange(mt.tall);
#if BATCHED
  int slot =
      int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x) *
      (BASIS_FLOATS + 2);
  if (batch.x > 0) {
    for (int i = 0; i < BASIS_FLOATS; ++i) p.c[i] = sums[slot + i];
    p.behind = sums[slot + BASIS_FLOATS], p.last = sums[slot + BASIS_FLOATS + 1];
  }
  int all = range.y;
  range = min(range.x + batch.y * (batch.x + ivec2(0, 1)), all);
  if (batch.x > 0 && range.x == all) return;  // finished by an earlier dispatch
#endif
  for (int item = range.x; item < range.y; ++item) projectVolume(tileItem(item), ray, m, w, p);
#if BATCHED
  if (range.y < all) {
    for (int i = 0; i < BASIS_FLOATS; ++i) sums[slot + i] = p.c[i];
    sums[slot + BASIS_FLOATS] = p.behind, sums[slot + BASIS_FLOATS + 1] = p.last;
    return;
  }
#endif
  ivec3 at = ivec3(block.place.xy + mt.texel, block.place.w + mt.face * block.kind.y);
  for (int layer = 0; layer < (BASIS_FLOATS + 3) / 4; ++layer) {
    vec4 v = projectionLayer(p, layer);
    if (layer == 0) v = withBlend(v, blend, BASIS_FLOATS, STORE);
    imageStore(target, at + ivec3(0, 0, layer), v);
  }
#if HORIZON
  float front = BASIS == BASIS_FOURIER ? 0.5 * p.c[0] : p.c[0];
#if BASIS == BASIS_SLAB
  for (int i = 1; i < BASIS_FLOATS; ++i) front += p.c[i];
#elif BASIS == BASIS_PIECEWISE
  int count, j;
  float v;
  pieceOf(m, 1.0, count, j, v);
  for (int i = 1; i < BASIS_FLOATS; ++i) front += i < count ? p.c[i] : 0.0;
#endif
  imageStore(horizonTarget, ivec3(lights[0].horizon.xy + mt.texel, lights[0].horizon.w + mt.face),
             vec4(min(front + p.behind, 65504.0), max(p.last - intervalsEnd(m), 0.0), 0.0, 0.0));
#endif
}
