// One volume's part of an extinction map, added to what is there (Gautron et al. 2011, pass 2): volumes may
// come in any order, over several frames. Half maps are rounded after each volume.
#include "lib/shadow_blocks.glsl"
#include "lib/project_volume.glsl"
layout(location = 0) out vec4 target[(BASIS_FLOATS + 3) / 4];
uniform int item, face;      // the volume, the face of the map
uniform ivec2 blockOrigin;   // of the block in its texture

void main() {
  MapTexel mt;
  mt.texel = ivec2(gl_FragCoord.xy) - blockOrigin;
  mt.face = face;
  vec2 uv = texelUv(mt);
  MapRay ray = mapRay(0, face, uv, float(mapEdge));
  float m[METRIC_FLOATS], w[kIntervals];
  for (int i = 0; i < METRIC_FLOATS; ++i) m[i] = 1.0;
  for (int i = 0; i < kIntervals; ++i) w[i] = 1.0;
#if METRIC != METRIC_NONE
  loadMetric(0, face, uv, m, w);
#endif
  Projection p = emptyProjection();
  projectVolume(item, ray, m, w, p);
  for (int layer = 0; layer < (BASIS_FLOATS + 3) / 4; ++layer) target[layer] = projectionLayer(p, layer);
}
