// Runs the shared functions on given inputs, for the tests that compare them with C++.
#include "shared/bindings.h"
#include "lib/intersect.glsl"
#include "lib/metric.glsl"
#include "lib/mixed_bit.glsl"
#include "lib/phase.glsl"
#ifndef IN_FLOATS
#define IN_FLOATS 64
#define OUT_FLOATS 80
#endif
layout(local_size_x = 64) in;
// Record i: IN_FLOATS of the input, OUT_FLOATS of the output.
layout(std430, binding = BIND_TEST_IN) readonly buffer In { float inputs[]; };
layout(std430, binding = BIND_TEST_OUT) writeonly buffer Out { float outputs[]; };
uniform int count, metric, metricCount, basis;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  int a = i * IN_FLOATS, o = i * OUT_FLOATS;
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
  outputs[o + 8] = basisTau(basis, 1 + i % (BASIS_FLOATS - 1), c, basisPhase(basis, x));
  outputs[o + 9] = basisValue(basis, BASIS_FLOATS, c, x);
  int pieces = int(inputs[a + 24]), piece = int(inputs[a + 25]);
  outputs[o + 10] = pieceTau(BASIS_FLOATS, c, pieces, piece, x);
  outputs[o + 11] = withLowBit(inputs[a + 28], i % 2 == 1, STORE_FLOAT);
  outputs[o + 12] = withLowBit(inputs[a + 28], i % 2 == 1, STORE_HALF);
  for (int k = 0; k < BASIS_FLOATS; ++k) c[k] = 0.0;
  projectStep(basis, c, inputs[a + 9], inputs[a + 10], inputs[a + 11]);
  for (int k = 0; k < BASIS_FLOATS; ++k) outputs[o + 16 + k] = c[k], c[k] = 0.0;
  projectPiece(c, inputs[a + 9], pieces, piece, inputs[a + 26], inputs[a + 27]);
  for (int k = 0; k < BASIS_FLOATS; ++k) outputs[o + 16 + BASIS_FLOATS + k] = c[k];
}
