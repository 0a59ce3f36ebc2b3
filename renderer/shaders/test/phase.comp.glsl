// The phase function at given (cosine, g), for the test that compares it with double precision.
#include "shared/bindings.h"
#include "lib/phase.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = BIND_TEST_IN) readonly buffer In { vec2 asked[]; };
layout(std430, binding = BIND_TEST_OUT) writeonly buffer Out { float values[]; };
uniform int count;
void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i < count) values[i] = phaseHg(asked[i].x, asked[i].y);
}
