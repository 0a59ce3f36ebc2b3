// Notes in a splatted extinction map which texels must not be blended (gathering does so while it stores).
#include "lib/map_texel.glsl"
#include "lib/shadow_blocks.glsl"
#include "lib/footprint.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
#if STORE == STORE_FLOAT
layout(rgba32f, binding = IMAGE_TARGET) uniform image2DArray target;
#else
layout(rgba16f, binding = IMAGE_TARGET) uniform image2DArray target;
#endif

void main() {
  MapTexel mt = mapTexelOf(gl_GlobalInvocationID.xy);
  if (!mt.valid) return;
  BlockRecord block = lights[0].coefficients;
  vec2 uv = texelUv(mt);
  float m[METRIC_FLOATS], w[kIntervals];
  loadMetric(0, mt.face, uv, m, w);
  ivec3 at = ivec3(block.place.xy + mt.texel, block.place.w + mt.face * block.kind.y);
  vec4 first = imageLoad(target, at);
  imageStore(target, at,
             withBlend(first, footprintBlend(mt.face, uv, 1.0 / float(mapEdge), m, w), COEFFICIENTS, STORE));
}
