// Adds the antiderivatives of the basis at this face; exit minus entry is the box's coverage. Depth clamp is
// on and t is clamped, so a face cut off by the near or far plane still counts.
#include "lib/metric.glsl"
flat in float side;
in vec3 inLight;
flat in vec4 depthOf;
layout(location = 0) out vec4 target0;
layout(location = 1) out vec4 target1;
layout(location = 2) out vec4 target2;
layout(location = 3) out vec4 target3;

float term(int i, float t) { return i < TERMS ? side * metricFace(METRIC, i, t) : 0.0; }
vec4 terms(int i, float t) { return vec4(term(i, t), term(i + 1, t), term(i + 2, t), term(i + 3, t)); }

void main() {
  float t = clamp(depthOf.x > 0.5 ? inLight.z : (length(inLight) - depthOf.y) / depthOf.z, 0.0, 1.0);
  target0 = terms(0, t);
  target1 = terms(4, t);
  target2 = terms(8, t);
  target3 = terms(12, t);
}
