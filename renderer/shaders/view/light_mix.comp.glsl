// Layers of a picture, each times a gain, added up: PARTS of them at a time. The first dispatch takes what no
// light decides, alpha, from the base.
#include "shared/bindings.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(rgba32f, binding = IMAGE_TARGET) uniform image2D target;
layout(binding = UNIT_PICTURE) uniform sampler2D base;
layout(binding = UNIT_MIX) uniform sampler2D parts[PARTS];
uniform vec3 gains[PARTS];
uniform ivec2 size;
uniform int first;

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (p.x >= size.x || p.y >= size.y) return;
  vec4 sum = first == 1 ? vec4(0.0, 0.0, 0.0, texelFetch(base, p, 0).a) : imageLoad(target, p);
  for (int i = 0; i < PARTS; ++i) sum.rgb += gains[i] * texelFetch(parts[i], p, 0).rgb;
  imageStore(target, p, sum);
}
