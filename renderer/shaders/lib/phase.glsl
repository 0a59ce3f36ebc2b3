// Phase functions [1/sr]; cosine 1 is forward. Twin: scene/phase.h.
#pragma once
// Henyey and Greenstein 1941. 1 + g^2 - 2 g cos as a sum of what cannot cancel, for g next to 1 or -1.
float phaseHg(float cosine, float g) {
  float a = abs(g), off = g < 0.0 ? 1.0 + cosine : 1.0 - cosine;
  float d = max((1.0 - a) * (1.0 - a) + 2.0 * a * max(off, 0.0), 1e-20);
  return (1.0 - a) * (1.0 + a) / (4.0 * 3.14159265358979 * d * sqrt(d));
}

// Draine 2003.
float phaseDraine(float cosine, float g, float alpha) {
  return phaseHg(cosine, g) * (1.0 + alpha * cosine * cosine) / (1.0 + alpha * (1.0 + 2.0 * g * g) / 3.0);
}

// Two such lobes (g, alpha, g, alpha), the second with a share of `blend`.
float phaseOfLobes(float cosine, vec4 lobes, float blend) {
  return mix(phaseDraine(cosine, lobes.x, lobes.y), phaseDraine(cosine, lobes.z, lobes.w), blend);
}

// The cosine behind which lies the share u of Henyey and Greenstein's lobe.
float henyeyGreensteinCosine(float g, float u) {
  float q = 2.0 * u - 1.0, s = 1.0 + g * q;
  // Next to 1 and -1 what is left of it is told apart: s may be as small as 1 - |g|.
  float c = (q * (1.0 + g * g) * (2.0 + g * q) + g * (3.0 - g * g)) / (2.0 * s * s);
  return clamp(c, -1.0, 1.0);
}
