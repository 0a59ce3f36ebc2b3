// What arrives of a light at a point: through the media by whatever shadow it has, and past the solids that
// block it. What is read here is bound by view/light_set.h, volumes by residency/volume_set.h.
// Variant constants: LIGHT_KINDS (1: lights without shadow, 2: extinction maps, 4: ray marches,
// 8: transmittance maps, 16: deep maps), LOCAL_LIGHTS (0: suns only), BLOCKERS of lib/solid.glsl and those of
// lib/shadow_map.glsl.
#pragma once
#include "lib/volume.glsl"
#include "lib/light.glsl"
#include "lib/shadow_map.glsl"
#include "lib/solid.glsl"

#ifndef LOCAL_LIGHTS
#define LOCAL_LIGHTS 1
#endif

layout(binding = UNIT_SHADOW_ITEMS) uniform isamplerBuffer shadowItems;  // volumes to march through

// Towards the light, and E without shadow.
Incidence unshadowed(int l, vec3 p) {
#if LOCAL_LIGHTS
  return lightAt(l, p);
#else
  return Incidence(lights[l].towards.xyz, 1e30, lights[l].emitted.rgb);
#endif
}

// `inMedium`: p is a point of a medium, not of a surface. With RESUME it goes on where state.item and state.tau say, and means
// nothing where `paused` is set behind it.
float lightTransmittanceTowards(int l, vec3 p, vec3 towards, float distance, bool inMedium) {
  float T = 1.0;
#if LIGHT_KINDS & 26
#if LIGHT_KINDS & 5
  int shadow = lights[l].shadow.x;
  if (shadow != SHADOW_NONE && shadow != SHADOW_RAY_MARCH)
#endif
    T = lookupTransmittance(l, p, inMedium);
#endif
#if LIGHT_KINDS & 4
  int count = lights[l].shadow.x == SHADOW_RAY_MARCH ? lights[l].items.z : 0, k = 0;
  float tau = 0.0;
#if RESUME
  k = state.item;
  tau = state.tau;
#endif
  for (; k < count && tau < 30.0; ++k) {
#if RESUME
    SPEND(1);
    if (mustPause()) {
      paused = true;
      break;
    }
#endif
    tau += opticalDepth(texelFetch(shadowItems, lights[l].items.y + k).x, p, towards, lights[l].extent.y,
                        distance);
  }
#if RESUME
  state.item = paused ? k : 0;
  state.tau = paused ? tau : 0.0;
#endif
  T *= exp(-tau);
#endif
  return T;
}

// Transmittance between p, in a medium, and light l.
float lightTransmittance(int l, vec3 p) {
  Incidence i = unshadowed(l, p);
  return lightTransmittanceTowards(l, p, i.towards, i.distance, true);
}

// E(p) [W/m^2] of light l on a surface that faces it, shadows included.
vec3 lightArriving(int l, vec3 p, bool inMedium, out vec3 towards) {
  Incidence i = unshadowed(l, p);
  towards = i.towards;
  float transmittance = lightTransmittanceTowards(l, p, i.towards, i.distance, inMedium);
  return i.irradiance * (transmittance * solidVisibility(l, p, i.towards, i.distance));
}
