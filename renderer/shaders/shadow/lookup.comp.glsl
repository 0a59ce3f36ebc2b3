// Transmittance between light 0 and given world positions, by whatever shadow the light has: what error
// measurements look at. The work groups of a row make the same lookups, over and over for timing.
#include "lib/light_transmittance.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = BIND_TEST_IN) readonly buffer In { vec4 positions[]; };
layout(std430, binding = BIND_TEST_OUT) writeonly buffer Out { float outputs[]; };
uniform int first, end;
void main() {
  int i = first + int(gl_WorkGroupID.y * gl_WorkGroupSize.x + gl_LocalInvocationID.x);
  if (i >= end) return;
  float T = lightTransmittance(0, placeAt(positions[i].xyz));
  if (gl_WorkGroupID.x == 0u || T < 0.0) outputs[i] = T;  // never below 0: the others only look up
}
