// Runs the shared functions on given inputs, for the tests that compare them with C++.
#include "shared/bindings.h"
#include "lib/intersect.glsl"
#include "lib/metric.glsl"
#include "lib/phase.glsl"
layout(local_size_x = 64) in;
// Input record i: 64 floats; output record i: 40 floats.
layout(std430, binding = BIND_TEST_IN) readonly buffer In { float inputs[]; };
layout(std430, binding = BIND_TEST_OUT) writeonly buffer Out { float outputs[]; };
uniform int count, metric, metricCount, basis;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  int a = i * 64, o = i * 40;
  vec3 ro = vec3(inputs[a], inputs[a + 1], inputs[a + 2]),
       rd = vec3(inputs[a + 3], inputs[a + 4], inputs[a + 5]);
  vec2 box = intersectBox(ro, rd, vec3(-0.5), vec3(0.5)), ball = intersectBall(ro, rd);
  outputs[o] = box.x, outputs[o + 1] = box.y, outputs[o + 2] = ball.x, outputs[o + 3] = ball.y;
  outputs[o + 4] = phaseHg(inputs[a + 6], inputs[a + 7]);
  float x = inputs[a + 8], m[METRIC_FLOATS], w[kIntervals], c[BASIS_FLOATS];
  for (int k = 0; k < METRIC_FLOATS; ++k) m[k] = inputs[a + 16 + k];
  for (int k = 0; k < BASIS_FLOATS; ++k) c[k] = inputs[a + 32 + k];
  for (int k = 0; k < kIntervals; ++k) w[k] = inputs[a + 12 + k];
  outputs[o + 5] = metricU(metric, metricCount, m, w, x);
  outputs[o + 6] = metricFace(metric, i % 8, x);
  outputs[o + 7] = basisTau(basis, BASIS_FLOATS, c, basisPhase(basis, x));
  // Fewer than the variant has room for.
  outputs[o + 17] = basisTau(basis, 1 + i % 7, c, basisPhase(basis, x));
  outputs[o + 16] = basisValue(basis, BASIS_FLOATS, c, x);
  for (int k = 0; k < BASIS_FLOATS; ++k) c[k] = 0.0;
  projectStep(basis, c, inputs[a + 9], inputs[a + 10], inputs[a + 11]);
  for (int k = 0; k < BASIS_FLOATS; ++k) outputs[o + 8 + k] = c[k];
}
