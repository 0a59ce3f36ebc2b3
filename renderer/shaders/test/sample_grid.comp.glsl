// Samples volume 0 at given local positions, for the tests that compare voxels and trilinear values with the
// CPU's.
#include "lib/volume.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = BIND_TEST_IN) readonly buffer In { vec4 positions[]; };
layout(std430, binding = BIND_TEST_OUT) writeonly buffer Out { float outputs[]; };
uniform int count;
void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i < count) outputs[i] = sampleGrid(0, positions[i].xyz, int(positions[i].w));
}
