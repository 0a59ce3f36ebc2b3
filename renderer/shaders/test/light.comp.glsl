// What light 0 sends to given points, and the nearest solid along given rays from them, for the tests that
// compare with C++.
#include "lib/light_transmittance.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = BIND_TEST_IN) readonly buffer In { vec4 inputs[]; };     // point, direction
layout(std430, binding = BIND_TEST_OUT) writeonly buffer Out { vec4 outputs[]; };  // five each
uniform int count, solidCount;
void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec3 p = inputs[2 * i].xyz, normal = vec3(0.0);
  Incidence unblocked = unshadowed(0, p);
  outputs[5 * i] = vec4(unblocked.towards, unblocked.distance);
  outputs[5 * i + 1] = vec4(unblocked.irradiance, lightTransmittance(0, placeAt(p)));
  float visible = solidVisibility(0, p, unblocked.towards, unblocked.distance);
  Arriving a = lightArriving(0, p, true);
  outputs[5 * i + 2] = vec4(a.open * a.through, visible);
  int solid = -1;
  float t = kNoHit;
  if (solidCount > 0) t = nearestSolid(solidCount, p, inputs[2 * i + 1].xyz, solid, normal);
  outputs[5 * i + 3] = vec4(normal, t);
  outputs[5 * i + 4] = vec4(float(solid), 0.0, 0.0, 0.0);
}
