// What arrives of a light at a point: through the media by whatever shadow it has, and past the solids that
// block it. What is read here is bound by view/light_set.h, volumes by residency/volume_set.h.
// Variant constants: LIGHT_KINDS (bit SHADOW_* for each kind of shadow the lights have), LOCAL_LIGHTS (0:
// suns only), AIR (1: some of these behind air), BLOCKERS of lib/solid.glsl and those of
// lib/shadow_map.glsl.
#pragma once
#include "lib/volume.glsl"
#include "lib/light.glsl"
#include "lib/shadow_map.glsl"
#include "lib/solid.glsl"

#ifndef LOCAL_LIGHTS
#define LOCAL_LIGHTS 1
#endif

// Of the volumes that shadows march through.
int shadowItem(int i) { return sceneNumber(4 * sceneSections.z + i); }

#ifndef AIR
#define AIR 0
#endif

// What the air lets through of light l at p.
vec3 airPasses(int l, vec3 p) {
#if AIR
  int first = lights[l].solids.w - 1;
  float above = clamp((p.y + lights[l].position.y) / float(AIR_TOP), 0.0, 1.0);
  float at = sqrt(above) * float(SUN_HEIGHTS - 1);
  int i = min(int(at), SUN_HEIGHTS - 2), texel = sceneAir + max(first, 0) + i;
  vec3 passes = mix(sceneFloats(texel).rgb, sceneFloats(texel + 1).rgb, at - float(i));
  return first < 0 ? vec3(1.0) : passes;
#else
  return vec3(1.0);
#endif
}

// Towards the light, and E without shadow.
Incidence unshadowed(int l, vec3 p) {
#if LOCAL_LIGHTS
  Incidence i = lightAt(l, p);
#else
  Incidence i = Incidence(lights[l].towards.xyz, 1e30, 1.0, lights[l].emitted.rgb);
#endif
  i.irradiance *= airPasses(l, p);
  return i;
}

// Through the volumes that light l's shadow marches through. Where they take several dispatches: on from the
// first one that is missing, and without meaning where `paused` is set behind it.
float marchedTransmittance(int l, Place from, vec3 towards, float distance) {
  int count = lights[l].shadow.x == SHADOW_RAY_MARCH ? lights[l].items.z : 0, k = firstItem();
  float tau = firstTau();
  for (; k < count && tau < kDarkness; ++k) {
    spend(1);
    if (pausesAtItem()) break;
    int v = shadowItem(lights[l].items.y + k);
    tau += opticalDepth(v, from, towards, lights[l].extent.y, distance);
  }
  itemsDone(k, tau);
  return exp(-tau);
}

// `inMedium`: the place is in a medium, not on a surface.
float lightTransmittanceTowards(int l, Place from, vec3 towards, float distance, bool inMedium) {
  float T = 1.0;
#if LIGHT_KINDS & MAPPED_SHADOWS
#if LIGHT_KINDS & ~MAPPED_SHADOWS
  int shadow = lights[l].shadow.x;
  if (shadow != SHADOW_NONE && shadow != SHADOW_RAY_MARCH)
#endif
    T = lookupTransmittance(l, from.p, inMedium);
#endif
#if HAS_SHADOW(SHADOW_RAY_MARCH)
  T *= marchedTransmittance(l, from, towards, distance);
#endif
  return T;
}

// Transmittance between a place in a medium and light l.
float lightTransmittance(int l, Place from) {
  Incidence i = unshadowed(l, from.p);
  return lightTransmittanceTowards(l, from, i.towards, i.distance, true);
}

// What is left of light l at p, in a medium, by solids and its cone: not by media, which light passes
// gradually.
float openTo(int l, vec3 p) {
  Incidence i = unshadowed(l, p);
  return i.cone * solidVisibility(l, p, i.towards, i.distance);
}

// A piece of a ray as light l sees it.
Passage passage(int l, vec3 p, vec3 d, float ds) {
#if LOCAL_LIGHTS
  if (lights[l].items.w != LIGHT_SUN) return passageOf(l, p, d, ds);
#endif
  return kSunPassage;
}

// Of light l at p: E [W/m^2] on a surface that faces it, past solids but not through the media, and what of
// it these let through.
struct Arriving {
  vec3 towards, open;
  float through;
};
Arriving lightArriving(int l, vec3 p, bool inMedium) {
  Incidence i = unshadowed(l, p);
  float through = lightTransmittanceTowards(l, placeAt(p), i.towards, i.distance, inMedium);
  return Arriving(i.towards, i.irradiance * solidVisibility(l, p, i.towards, i.distance), through);
}
