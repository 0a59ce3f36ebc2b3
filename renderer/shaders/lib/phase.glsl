// Phase functions [1/sr]; cosine 1 is forward.
#pragma once
// Henyey and Greenstein 1941. 1 + g^2 - 2 g cos as a sum of what cannot cancel, for g next to 1 or -1.
float phaseHg(float cosine, float g) {
  float a = abs(g), off = g < 0.0 ? 1.0 + cosine : 1.0 - cosine;
  float d = max((1.0 - a) * (1.0 - a) + 2.0 * a * max(off, 0.0), 1e-20);
  return (1.0 - a) * (1.0 + a) / (4.0 * 3.14159265358979 * d * sqrt(d));
}
