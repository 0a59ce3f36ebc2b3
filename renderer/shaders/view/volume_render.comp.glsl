// Single scattering, front to back: L = integral of T_cam sigma_s p E T_light ds, one sample per pixel and
// dispatch, averaged into the target. The march ends at the nearest solid, which adds T_cam albedo / pi SUM E
// cos T_light. What emits adds its radiance per metre to the source, and lights nothing.
// Variant constants: LIGHTS (their number, or 0: lightCount), DEPTH (1: no light, but the mean depth of what
// scatters), those of lib/camera_march.glsl and of lib/light_transmittance.glsl.
#define STRETCH_ALBEDO 1
#include "lib/camera_march.glsl"
#include "lib/light_transmittance.glsl"
#include "lib/random.glsl"
#include "lib/phase.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

#ifndef DEPTH
#define DEPTH 0
#endif

layout(rgba32f, binding = IMAGE_TARGET) uniform image2D target;
uniform int lightCount, sampleIndex, samples;  // at least one light (a black one, if need be)
const bool kDepth = DEPTH != 0;
const int kLights = LIGHTS;  // known: their loop is unrolled, offsets into the uniform block are constants

vec3 L = vec3(0.0);  // with DEPTH: sums of weight and depth, and of weight

int lightsHere() { return kLights > 0 ? kLights : lightCount; }

// What light l sends to p, black where that is counted already or has to wait for the next dispatch.
vec3 arrivingIfDue(int l, vec3 p, bool inMedium, out vec3 towards) {
  vec3 arriving = vec3(0.0);
  towards = vec3(0.0);
  if (lightIsDue(l)) {
    arriving = lightArriving(l, p, inMedium, towards);
    lightDone(l);
  }
  return paused ? vec3(0.0) : arriving;
}

// Scattering per unit length and solid angle of one volume: sigma_s p.
vec3 scattering(vec4 albedo, vec4 medium, float cosine) {
  return medium.w * (albedo.rgb * medium.rgb) * phaseHg(cosine, albedo.w);
}

// Of all that are active.
vec3 scattering(Stretch s, StretchSample x, float cosine) {
  vec3 sum = vec3(0.0);
  for (int k = 0; k < ACTIVE; ++k)
    sum += k < s.count ? scattering(s.albedo[k], x.media[k], cosine) : vec3(0.0);
  if (kOverflow) {
    for (int item = s.rest; item < s.range.y; ++item) {
      VolumeRay ray;
      if (isActive(s, item, ray)) sum += scattering(albedoOf(tileItem(item)), mediumAt(ray, x.at), cosine);
    }
  }
  return sum;
}

// What all lights send to the sample and it sends back along the ray, per metre.
vec3 scattered(CameraRay ray, Stretch s, StretchSample x) {
  vec3 p = eye + x.at * ray.d, sum = vec3(0.0);
  int l = 0;
  do {
    vec3 towards;
    vec3 arriving = arrivingIfDue(l, p, true, towards);
    // Light travels along -towards and is scattered into -d: the cosine between the two directions of travel.
    sum += scattering(s, x, dot(towards, ray.d)) * arriving;
    ++l;
  } while (l < lightsHere());
  return sum;
}

// Where nothing scatters no light is looked up: the step's emission passes as it is.
void passStep(Stretch s, inout StretchSample x) {
  L += x.sigma <= 0.0 ? T * s.ds * x.glow : vec3(0.0);
  x.glow = x.sigma <= 0.0 ? vec3(0.0) : x.glow;
}

void addDepth(CameraRay ray, Stretch s, StretchSample x) {
  L.xy += T * (1.0 - through(s, x)) * vec2(x.at * ray.forward, 1.0);
}

void addScattered(CameraRay ray, Stretch s, StretchSample x) {
  vec3 source = scattered(ray, s, x);
  source += paused ? vec3(0.0) : x.glow;  // with the step's last light
  // Exact over the step for a constant source and extinction.
  float depth = x.sigma * s.ds;
  L += T * (depth < 1e-4 ? s.ds * (1.0 - 0.5 * depth) : (1.0 - through(s, x)) / max(x.sigma, 1e-30)) * source;
}

void addSample(CameraRay ray, Stretch s, StretchSample x) {
  if (kDepth)
    addDepth(ray, s, x);
  else
    addScattered(ray, s, x);
}

// Radiance [W/(m^2 sr)] that the solid at the ray's end sends back.
vec3 reflected(CameraRay ray) {
  vec3 off = solidClear(ray), sum = vec3(0.0);
  int l = 0;
  do {
    vec3 towards;
    vec3 arriving = arrivingIfDue(l, off, false, towards);
    sum += arriving * max(dot(ray.normal, towards), 0.0);
    ++l;
  } while (l < lightCount);
  return sum * solidAlbedo(ray.solid) / 3.14159265358979;
}

void addSolid(CameraRay ray) {
  if (kDepth)
    L += T * vec3(ray.end * ray.forward, 1.0, 0.0);
  else
    L += T * reflected(ray);
  T = paused ? T : 0.0;
}

bool broken(vec4 v) { return any(isnan(v)) || any(isinf(v)); }

void storeRadiance(ivec2 pixel, vec4 before) {
  vec4 now = vec4(L, 1.0 - T);
  if (broken(now)) now = vec4(0.0);
  imageStore(target, pixel, before + (now - before) / float(sampleIndex + 1));
}

// Weights are averaged, depths by their weights: a pixel half covered is as far away as what covers it.
void storeDepth(ivec2 pixel, vec4 before) {
  if (broken(vec4(L, 0.0))) L = vec3(0.0);
  float weight = before.a * float(sampleIndex), all = weight + L.y;
  float depth = all > 0.0 ? (before.r * weight + L.x) / all : 0.0;
  imageStore(target, pixel, vec4(vec3(depth), all / float(sampleIndex + 1)));
}

void main() {
  ivec2 pixel = regionPixel();
  if (!inRegion(pixel)) return;
  CameraRay ray = cameraRay(pixel, pixelSample(pixel, sampleIndex, samples));
  vec4 seen = vec4(0.0, 0.0, 0.0, 1.0);
  if (!goOn(regionSlot(pixel), seen)) return;
  L = seen.rgb, T = seen.a;
  findSolid(ray);
  marchMedia(ray);
  if (T < kOpaque) T = 0.0;
  if (meetsSolid(ray)) addSolid(ray);
  keep(regionSlot(pixel), vec4(L, T));
  if (paused) return;
  vec4 before = sampleIndex == 0 ? vec4(0.0) : imageLoad(target, pixel);
  if (kDepth)
    storeDepth(pixel, before);
  else
    storeRadiance(pixel, before);
}
