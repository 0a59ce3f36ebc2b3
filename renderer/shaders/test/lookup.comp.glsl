// Optical depth of light 0 at given world positions: by its shadow map, for tests and benchmarks.
#include "lib/volume.glsl"
#include "lib/shadow_map.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = BIND_TEST_IN) readonly buffer In { vec4 positions[]; };
layout(std430, binding = BIND_TEST_OUT) writeonly buffer Out { float outputs[]; };
uniform int count;
void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i < count) outputs[i] = lookupTau(0, positions[i].xyz);
}
