// The mip level of volume 0 for given footprints, for the test that knows it.
#include "lib/volume.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = BIND_TEST_IN) readonly buffer In { float footprints[]; };
layout(std430, binding = BIND_TEST_OUT) writeonly buffer Out { float levels[]; };
uniform int count;
void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i < count) levels[i] = float(levelFor(0, footprints[i]));
}
