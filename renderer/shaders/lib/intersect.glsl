// Ray-shape intersections: the part (t0, t1) of the line o + t d inside, or t0 >= t1. Twins in
// renderer/base/math.h.
#pragma once

vec2 intersectBox(vec3 o, vec3 d, vec3 lo, vec3 hi) {
  // A zero component would give 0 * inf; a huge finite slope has the same sign and no NaN.
  vec3 inv = mix(1.0 / d, vec3(1e30), equal(d, vec3(0.0)));
  vec3 a = (lo - o) * inv, b = (hi - o) * inv;
  vec3 n = min(a, b), f = max(a, b);
  return vec2(max(max(n.x, n.y), n.z), min(min(f.x, f.y), f.z));
}

vec2 intersectBall(vec3 o, vec3 d) {
  float a = dot(d, d), b = dot(o, d);
  vec3 closest = o - (b / a) * d;  // better conditioned than b*b - a*c for far origins
  float q = 1.0 - dot(closest, closest);
  if (q <= 0.0) return vec2(1.0, 0.0);
  float s = sqrt(q / a);
  return vec2(-b / a - s, -b / a + s);
}
