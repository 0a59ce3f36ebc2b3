// Phase functions [1/sr]; cosine 1 is forward.
#pragma once
// Henyey and Greenstein 1941.
float phaseHg(float cosine, float g) {
  float d = max(1.0 + g * g - 2.0 * g * cosine, 1e-6);
  return (1.0 - g * g) / (4.0 * 3.14159265358979 * d * sqrt(d));
}
