// How far shadow maps are off in what a picture shows: marches camera rays as view/volume_render does, pixel
// centres, and in the middle of each step with extinction asks both lights of each pair, 2 i with its
// map and 2 i + 1 with ray-marched truth.
// Adds to `errors` (SUM w dT, SUM |dT|, the dT of largest magnitude, number of samples) and to
// `transmittances` (SUM w T, SUM w T true, SUM w, 0), w: how much of the sample is seen. A solid behind the
// media has its say in the picture (w, dT), but is no sample of them.
// Variant constants: those of lib/camera_march.glsl and of lib/light_transmittance.glsl.
#include "shared/compare.h"
#include "lib/camera_march.glsl"
#include "lib/light_transmittance.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = IMAGE_ERROR) uniform image2D errors;
layout(rgba32f, binding = IMAGE_TRANSMITTANCE) uniform image2D transmittances;
layout(std430, binding = BIND_ERROR_BINS) buffer Bins { uint bins[ERROR_BINS]; };
uniform int pairCount;

vec4 error, transmittance;
float mapped = 1.0;  // of the pair at work

int binOf(float magnitude) {
  const float kBinsPerDecade = float(ERROR_BINS - 1) / ERROR_DECADES;
  int bin = magnitude < ERROR_LEAST
                ? 0
                : 1 + int(kBinsPerDecade * log2(magnitude / ERROR_LEAST) / log2(10.0));
  return min(bin, ERROR_BINS - 1);
}

void addPair(int i, Place from, float weight, float facing, bool inMedium) {
  int l = 2 * i;
  Incidence in_ = unshadowed(l, from.p);
  float reached = solidVisibility(l, from.p, in_.towards, in_.distance) * facing;
  if (reached <= 0.0 || all(lessThanEqual(in_.irradiance, vec3(0.0)))) return;
  if (!lightIsDue(l + 1)) return;
  if (lightIsDue(l)) {
    mapped = lightTransmittanceTowards(l, from, in_.towards, in_.distance, inMedium);
    lightDone(l);
    if (paused) return;
  }
  float truth = lightTransmittanceTowards(l + 1, from, in_.towards, in_.distance, inMedium);
  lightDone(l + 1);
  if (paused) return;
  float d = mapped - truth, magnitude = abs(d);
  transmittance += weight * reached * vec4(mapped, truth, 1.0, 0.0);
  error.x += weight * reached * d;
  if (!inMedium) return;
  error.y += magnitude;
  error.z = magnitude > abs(error.z) ? d : error.z;
  error.w += 1.0;
  atomicAdd(bins[binOf(magnitude)], 1u);
}

void passStep(Stretch s, inout StretchSample x) {}
void passGap() {}
float nextCut(Stretch s) { return kNoEdge; }

bool addSample(CameraRay ray, Stretch s, StretchSample x) {
  Place at = placeAt(s, middleOf(x));
  float weight = T * (1.0 - through(x));
  if (x.sigma > 0.0)
    for (int i = 0; i < pairCount; ++i) addPair(i, at, weight, 1.0, true);
  return true;
}

void addSolid(CameraRay ray) {
  vec3 off = solidClear(ray);
  for (int i = 0; i < pairCount; ++i)
    addPair(i, placeAt(off), T, max(dot(ray.normal, unshadowed(2 * i, off).towards), 0.0), false);
}

void main() {
  ivec2 pixel = regionPixel();
  if (!inRegion(pixel)) return;
  CameraRay ray = cameraRay(pixel, vec3(0.5));
  error = imageLoad(errors, pixel);
  transmittance = imageLoad(transmittances, pixel);
  vec4 seen = vec4(mapped, 0.0, 0.0, T);
  if (!goOn(regionSlot(pixel), seen)) return;
  mapped = seen.x, T = seen.a;
  findSolid(ray);
  marchMedia(ray);
  if (meetsSolid(ray)) addSolid(ray);
  keep(regionSlot(pixel), vec4(mapped, 0.0, 0.0, T));
  imageStore(errors, pixel, error);
  imageStore(transmittances, pixel, transmittance);
}
