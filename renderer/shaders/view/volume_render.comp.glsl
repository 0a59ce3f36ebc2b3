// Light that is scattered towards the eye, front to back: L = integral of T_cam sigma_s p E T_light ds, one
// sample per pixel and dispatch, averaged into the target. Over a step the medium is what it is in its
// middle; light is looked up where steps begin and end. The march ends at the nearest solid, which adds
// T_cam albedo / pi SUM E cos T_light. What emits adds its radiance per metre to the source. Behind all that
// lies what is seen of environments.
// With SCATTER_GRID light that was scattered before comes from moments on lattices (lib/scatter_field.glsl;
// what emits is in them), and peaks of phase functions count as going straight on, on all ways: what one
// scattering brings then is in lib/peak.glsl. Else what emits lights nothing.
// With OCTAVES so many sums stand for all orders, each with less light, depth and direction than the one
// before (Wrenninge 2013).
// With MULTIPLE the picture is all that less what it would be without: light that was scattered once alone.
// With TINTED extinction has colours, and so has what lights' shadows and media in front let through.
// Variant constants: TINTED, SCATTER_GRID, MULTIPLE (with SCATTER_GRID or OCTAVES), OCTAVES (at least 1),
// BACKDROP (1: there is one), LIGHTS (their number, or 0: lightCount), REACHED (at least as many), DEPTH (1:
// no light, but the mean depth of what scatters), those of lib/camera_march.glsl and of
// lib/light_transmittance.glsl.
#define STRETCH_ALBEDO 1
#ifndef SCATTER_GRID
#define SCATTER_GRID 0
#endif
#ifndef OCTAVES
#define OCTAVES 1
#endif
#ifndef MULTIPLE
#define MULTIPLE 0
#endif
#ifndef TINTED
#define TINTED 0
#endif
#define STRETCH_SCALED SCATTER_GRID
#define STRETCH_TINTED TINTED
#define STRETCH_IDS SCATTER_GRID
#include "lib/camera_march.glsl"
#include "lib/light_transmittance.glsl"
#include "lib/random.glsl"
#include "lib/phase.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

#ifndef DEPTH
#define DEPTH 0
#endif
#ifndef BACKDROP
#define BACKDROP 0
#endif
#include "lib/backdrop.glsl"
#if SCATTER_GRID
#include "lib/peak.glsl"
#include "lib/scatter_field.glsl"
#endif

layout(rgba32f, binding = IMAGE_TARGET) uniform image2D target;
uniform int lightCount, sampleIndex, samples;  // at least one light (a black one, if need be)
uniform int morePart;  // 1: of too many lights for one dispatch these come on top of those before
uniform vec3 lightTint;   // optical depths of a channel are so many times those of light's shadows, ...
uniform vec3 lightScale;  // ... and scaled ones so many times
const bool kDepth = DEPTH != 0;
const int kLights = LIGHTS;  // known: their loop is unrolled, offsets into the uniform block are constants

const float kNoLight = 1e-30;  // transmittance: its logarithm is taken

vec3 L = vec3(0.0);  // with DEPTH: sums of weight and depth, and of weight
float sunk = 0.0;    // metres that the way so far is longer in lattices of scattered light
const vec3 kWhole = vec3(-1.0);  // depth of peaks that do not count as going straight on

int lightsHere() { return kLights > 0 ? kLights : lightCount; }

// Of light through the media, as they are, and as the picture counts them.
Clear clearOf(float transmittance) {
#if TINTED
  return exp(lightTint * log(max(transmittance, kNoLight)));
#else
  return transmittance;
#endif
}
Through counted(float transmittance) {
#if SCATTER_GRID || TINTED
  return exp(lightScale * log(max(transmittance, kNoLight)));
#else
  return transmittance;
#endif
}

// What light l sends to a surface at p, and what of it is not scattered on its way; black where that is
// counted already or has to wait for the next dispatch.
vec3 arrivingIfDue(int l, vec3 p, vec3 normal, out vec3 once) {
  vec3 arriving = vec3(0.0);
  once = vec3(0.0);
  if (lightIsDue(l)) {
    Arriving a = lightArriving(l, p, false);
    vec3 open = a.open * max(dot(normal, a.towards), 0.0);
    arriving = open * counted(a.through), once = open * clearOf(a.through);
    lightDone(l);
  }
  once = paused ? vec3(0.0) : once;
  return paused ? vec3(0.0) : arriving;
}

// Of the volume in register k, and of volume v; `w` of its albedo. `narrow` is the mean cosine of the
// directions that a light stands for: lobes of Henyey and Greenstein blurred by it have g times that.
#if PHASE_LOBES
float phaseOf(vec4 lobes, float w, float cosine, float narrow) {
  return phaseOfLobes(cosine, lobes * vec4(narrow, 1.0, narrow, 1.0), w);
}
float phaseOf(Stretch s, int k, float cosine, float narrow) {
  return phaseOf(s.lobes[k], s.albedo[k].w, cosine, narrow);
}
float phaseOf(int v, float w, float cosine, float narrow) { return phaseOf(lobesOf(v), w, cosine, narrow); }
#else
float phaseOf(Stretch s, int k, float cosine, float narrow) {
  return phaseHg(cosine, narrow * s.albedo[k].w);
}
float phaseOf(int v, float w, float cosine, float narrow) { return phaseHg(cosine, narrow * w); }
#endif

// Scattering per unit length and solid angle of one volume: sigma_s p.
vec3 scattering(vec4 albedo, vec4 medium, vec3 tint, float phase) {
  return medium.w * (albedo.rgb * medium.rgb) * tint * phase;
}

// Of all that are active.
vec3 scattering(Stretch s, StretchSample x, float cosine, float narrow) {
  vec3 sum = vec3(0.0);
  for (int k = 0; k < ACTIVE; ++k)
    if (k < s.count)
      sum += scattering(s.albedo[k], x.media[k], tinted(s, k), phaseOf(s, k, cosine, narrow));
  if (kOverflow) {
    for (int item = s.rest; item < s.range.y; ++item) {
      VolumeRay ray;
      if (isActive(s, item, ray)) {
        int v = tileItem(item);
        vec4 albedo = albedoOf(v);
        vec4 medium = mediumAt(ray, middleOf(x));
        sum += scattering(albedo, medium, tinted(v), phaseOf(v, albedo.w, cosine, narrow));
      }
    }
  }
  return sum;
}

#if SCATTER_GRID
const float kOneDirection = 0.999;  // mean cosine of what is a single one

// Scattering of one volume within peaks alone. Next to the directions that a light stands for, whose mean
// cosine is `narrow`, peaks have none.
vec3 peaks(vec4 albedo, vec4 medium, int v, float cosine, float narrow, vec3 depth) {
  vec3 sum;
  vec2 scaled = scaledPhaseOf(v);
  if (scaled.x <= 0.0) {
    // No peak: what is not linear in the cosine.
    float smooth_ = (1.0 + 3.0 * narrow * cosine * scaled.y) / (4.0 * 3.14159265358979);
    sum = vec3(phaseOf(v, albedo.w, cosine, narrow) - smooth_);
  } else if (narrow < kOneDirection) {
    vec3 much = (1.0 - exp(-depth)) / max(depth, 1e-3);
    vec3 share = mix(much, 1.0 - 0.5 * depth, 1.0 - step(1e-3, depth));
    sum = scaled.x * phaseHg(cosine, narrow) * share;
  } else {
    int first = int(volumeRow(v, 15).w);
    sum = vec3(scatteredPeak(first, cosine, depth.r));
    if (depth.g != depth.r || depth.b != depth.r)
      sum.gb = vec2(scatteredPeak(first, cosine, depth.g), scatteredPeak(first, cosine, depth.b));
  }
  return medium.w * (albedo.rgb * medium.rgb) * tinted(v) * sum;
}

// What one scattering brings along scaled ways: by what of phase functions is smooth, or within peaks alone,
// of which `depth` is passed.
vec3 scatteredOnce(Stretch s, StretchSample x, float cosine, float narrow, vec3 depth) {
  if (MULTIPLE != 0 && depth == kWhole) return scattering(s, x, cosine, narrow);
  vec3 sum = (x.scattering + 3.0 * narrow * cosine * x.forward) / (4.0 * 3.14159265358979);
  for (int k = 0; k < ACTIVE; ++k)
    if (k < s.count && x.media[k].w > 0.0)
      sum += peaks(s.albedo[k], x.media[k], s.ids[k], cosine, narrow, depth);
  if (kOverflow) {
    for (int item = s.rest; item < s.range.y; ++item) {
      VolumeRay ray;
      int v = tileItem(item);
      if (isActive(s, item, ray))
        sum += peaks(albedoOf(v), mediumAt(ray, middleOf(x)), v, cosine, narrow, depth);
    }
  }
  return max(sum, 0.0);
}
#else
vec3 scatteredOnce(Stretch s, StretchSample x, float cosine, float narrow, vec3 depth) {
  return scattering(s, x, cosine, narrow);
}
#endif

// What one scattering brings of what light l sends, over a step; phase functions have `contrast` of their
// directions. Light
// travels along -towards and is scattered into -d: the
// cosine is that between the two directions of travel. A near light's turns on the way; at an angle a it is
// -sin a, and each angle has the same part in 1/r^2.
vec3 scattering(Stretch s, StretchSample x, int l, Passage q, float contrast, vec3 depth) {
#if LOCAL_LIGHTS
  bool sun = lights[l].items.w == LIGHT_SUN;
  // Two points of Gauss in parts of a quarter radian: 0.5 % off at g = 0.8.
  const float kAngle = 0.25, kGauss = 0.28867513;
  float turn = q.angles.y - q.angles.x, parts = clamp(ceil(turn / kAngle), 1.0, 16.0);
  int points = sun || turn < 0.1 ? 1 : 2 * int(parts), i = 0;
  vec3 sum = vec3(0.0);
  do {
    float part = points == 1 ? 0.5 : (float(i / 2) + 0.5 + ((i & 1) == 0 ? -kGauss : kGauss)) / parts;
    sum += scatteredOnce(s, x, sun ? dot(lights[l].towards.xyz, s.d) : -sin(q.angles.x + part * turn),
                         contrast * (sun ? lights[l].towards.w : 1.0), depth);
    ++i;
  } while (i < points);
  return sum / float(points);
#else
  return scatteredOnce(s, x, dot(lights[l].towards.xyz, s.d), contrast * lights[l].towards.w, depth);
#endif
}

// Mean over a step of the light that comes out of it where it begins: `first` and `last` reach its ends, and
// from one to the other light falls off exponentially, exactly so in what is uniform; what is between costs
// the depth of the step.
Through meanReaching(Through first, Through last, Through depth, Passage q) {
  Through fall = log(first / last) + depth, seen = last * exp(-depth);
  Through flat_ = 1.0 - step(0.05, abs(fall));
  Through even =
      mix((first - seen) / (fall + flat_), 0.5 * (first + seen) * (1.0 - fall * fall / 12.0), flat_);
#if LOCAL_LIGHTS
  // Between that, where 1/r^2 is the same everywhere, and what there is where it has its peak.
  return mix(first * exp(-fall * q.centre), even, q.spread);
#else
  return even;
#endif
}

// The optical depth of peaks on both ways to the middle of a step, where so much of the light arrives.
vec3 peaksPassed(StretchSample x, float ofLight) {
#if SCATTER_GRID
  vec3 unscaled = vec3(clear * exp(-0.5 * clearDepthOf(x))), seen = T * sqrt(through(x));
  vec3 ofCamera = log(max(seen, 1e-30)) - log(max(unscaled, 1e-30));
  return max(ofCamera + (lightScale - lightTint) * log(ofLight), 0.0);
#else
  return vec3(0.0);
#endif
}

// What of light that is not scattered on its way shows: with MULTIPLE without what shows of it anyway.
vec3 seenOf(vec3 light) { return MULTIPLE != 0 ? (T - clear) * light : T * light; }

// Where nothing scatters no light is looked up: the step's emission passes as it is.
void passStep(Stretch s, inout StretchSample x) {
  bool nothing = x.sigma <= 0.0;
  L += nothing ? seenOf(x.ds * x.glow) : vec3(0.0);
  x.glow = nothing ? vec3(0.0) : x.glow;
  lit = lit && !(nothing && x.ds > 0.0);
}
void passGap() { lit = false; }

// At the foot of a near light, from where on it falls off again, and half as far on as the light is away.
float nextCut(Stretch s) {
  float cut = kNoEdge;
#if LOCAL_LIGHTS
  int l = 0;
  do {
    vec3 to = lights[l].position.xyz - s.start.p;
    float foot = dot(to, s.d), near = 0.5 * length(to - s.at * s.d);
    bool ahead = lights[l].items.w != LIGHT_SUN && foot > s.at + 1e-3 * s.wanted;
    cut = ahead ? min(cut, foot) : cut;
    near = max(near, 0.125 * min(s.wanted, s.voxel));
    cut = lights[l].items.w != LIGHT_SUN ? min(cut, s.at + near) : cut;
    ++l;
  } while (l < lightsHere());
#endif
  return cut;
}

void addDepth(CameraRay ray, Stretch s, StretchSample x) {
  L.xy += meanOf(clear) * (1.0 - exp(-depthOf(x))) * vec2(metresTo(s, middleOf(x)) * ray.forward, 1.0);
}

// Where the light is looked up that a step begins or ends with. Next to a face of a volume a hair inside:
// whatever a ray along the face would meet, none of it is seen here. In maps places are as exact as they are
// far from the pass's origin, in the volume itself the hair is enough.
Place endOfStep(Stretch s, StretchSample x, bool begin) {
  float at = begin ? x.from : x.from + x.ds, rounding = 0.0;
#if LIGHT_KINDS & MAPPED_SHADOWS
  rounding = 1e-7 * length(s.start.p);
#endif
  float hair = min(max(1e-3 * x.ds, rounding), 0.5 * x.ds);
  at += begin && x.from <= 0.0 ? hair : 0.0;
  at -= !begin && s.at >= s.span ? hair : 0.0;
  return placeAt(s, at);
}

// Solids and cones may cut light off anywhere, so they count as they are in the middle of a step. Where a
// step begins the light is known from the one before it, or is looked up first.
bool addScattered(Stretch s, StretchSample x) {
  bool begin = !lit && x.sigma > 0.0;
  vec3 from = pointAt(s, x.from), middle = pointAt(s, middleOf(x));
  Place end = endOfStep(s, x, begin);
  vec3 sum = vec3(0.0), once = vec3(0.0);
  int l = 0;
  do {
    if (lightIsDue(l)) {
      float reaches = max(lightTransmittance(l, end), kNoLight);
      lightDone(l);
      Passage q = passage(l, from, s.d, x.ds);
      vec3 open = openTo(l, middle) * q.falloff * airPasses(l, middle) * lights[l].emitted.rgb;
      vec3 source = scattering(s, x, l, q, 1.0, peaksPassed(x, sqrt(reached[l] * reaches))) *
                    meanReaching(counted(reached[l]), counted(reaches), seenDepthOf(x), q);
#if OCTAVES > 1 && !SCATTER_GRID
      float share = 1.0;
      for (int n = 1; n < OCTAVES; ++n) {
        share *= 0.5;
        source += share * scattering(s, x, l, q, share, vec3(0.0)) *
                  meanReaching(pow(counted(reached[l]), Through(share)),
                               pow(counted(reaches), Through(share)), seenDepthOf(x), q);
      }
#endif
      bool counts = !(begin || paused || x.sigma <= 0.0);
      sum += counts ? source * open : vec3(0.0);
#if MULTIPLE
      source = scattering(s, x, l, q, 1.0, kWhole) *
               meanReaching(Through(clearOf(reached[l])), Through(clearOf(reaches)),
                            Through(clearDepthOf(x)), q);
      once += counts ? source * open : vec3(0.0);
#endif
      reached[l] = paused ? reached[l] : reaches;
    }
    ++l;
  } while (l < lightsHere());
  L += MULTIPLE != 0 ? x.ds * (T * sum - clear * once) : T * x.ds * sum;
  if (paused) return true;
  vec3 glow = x.glow;
#if SCATTER_GRID
  if (!begin) {
    int lattice = scatterLattice(middle);
    float longer = (scatterStretch(lattice, x.extinction) - 1.0) * x.ds;
    vec3 there = middle + (sunk + 0.5 * longer) * s.d;
    if (morePart == 0) x.glow += scatteredAgain(lattice, there, -s.d, x.scattering, x.forward);
    sunk += longer;
  }
#endif
  if (!begin) L += T * x.ds * meanThrough(x) * x.glow;
#if MULTIPLE
  Clear depth = clearDepthOf(x), flat_ = 1.0 - step(1e-2, depth);
  Clear shows = mix((1.0 - exp(-depth)) / max(depth, Clear(1e-2)), 1.0 - depth * (0.5 - depth / 6.0), flat_);
  if (!begin) L -= clear * x.ds * shows * glow;
#endif
  lit = x.sigma > 0.0;
  if (begin) lightsAgain();
  return !begin;
}

bool addSample(CameraRay ray, Stretch s, StretchSample x) {
  if (!kDepth) return addScattered(s, x);
  addDepth(ray, s, x);
  return true;
}

// Radiance [W/(m^2 sr)] that the solid at the ray's end sends back; `once`: of the lights alone.
vec3 reflected(CameraRay ray, out vec3 once) {
  vec3 off = solidClear(ray), sum = vec3(0.0), color = solidAlbedo(ray.solid) / 3.14159265358979;
  once = vec3(0.0);
  int l = 0;
  do {
    vec3 unscattered;
    sum += arrivingIfDue(l, off, ray.normal, unscattered);
    once += unscattered * color;
    ++l;
  } while (l < lightCount);
#if SCATTER_GRID
  sum += paused || morePart == 1 ? vec3(0.0) : scatteredOnto(off, ray.normal);
#endif
  return sum * color;
}

void addSolid(CameraRay ray) {
  vec3 once;
  if (kDepth)
    L += meanOf(clear) * vec3(ray.end * ray.forward, 1.0, 0.0);
  else
    L += T * reflected(ray, once);
  if (MULTIPLE != 0) L -= clear * once;
  T = paused ? T : Through(0.0);
  clear = paused ? clear : Clear(0.0);
}

// What is not a number is stored as such: whoever reads the picture back says at which pixel it is.
void storeRadiance(ivec2 pixel, vec4 before) {
  vec4 now = vec4(L, 1.0 - meanOf(clear)), sum = morePart == 1 ? vec4(L, 0.0) : now - before;
  imageStore(target, pixel, before + sum / float(sampleIndex + 1));
}

// Weights are averaged, depths by their weights: a pixel half covered is as far away as what covers it.
void storeDepth(ivec2 pixel, vec4 before) {
  float weight = before.a * float(sampleIndex), all = weight + L.y;
  float depth = all > 0.0 ? (before.r * weight + L.x) / all : 0.0;
  imageStore(target, pixel, vec4(vec3(depth), all / float(sampleIndex + 1)));
}

void main() {
  ivec2 pixel = regionPixel();
  if (!inRegion(pixel)) return;
  CameraRay ray = cameraRay(pixel, pixelSample(pixel, sampleIndex, samples));
  vec4 seen = vec4(0.0, 0.0, 0.0, 1.0);
  seenBeside = vec4[2](vec4(1.0, 1.0, 1.0, 0.0), vec4(1.0));
  if (!goOn(regionSlot(pixel), seen)) return;
  L = seen.rgb, clear = Clear(seen.a), T = Through(seen.a);
#if SCATTER_GRID || TINTED
  T = seenBeside[0].rgb, sunk = seenBeside[0].w;
#endif
#if SCATTER_GRID && TINTED
  clear = seenBeside[1].rgb;
#endif
  findSolid(ray);
  marchMedia(ray);
  if (mostOf(T) < kOpaque) T = Through(0.0), clear = Clear(0.0);
  if (meetsSolid(ray)) addSolid(ray);
#if BACKDROP
  if (!paused && ray.end >= kNoHit) L += seenOf(backdrop(ray.d));
#endif
#if SCATTER_GRID || TINTED
  seenBeside = vec4[2](vec4(T, sunk), vec4(vec3(clear), 1.0));
#endif
  keep(regionSlot(pixel), vec4(L, meanOf(clear)));
  if (paused) return;
  vec4 before = sampleIndex == 0 && morePart == 0 ? vec4(0.0) : imageLoad(target, pixel);
  if (kDepth)
    storeDepth(pixel, before);
  else
    storeRadiance(pixel, before);
}
