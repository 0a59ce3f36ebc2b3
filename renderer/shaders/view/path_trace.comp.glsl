// All orders of scattering, without bias: paths from the camera through null collisions, at each vertex one
// light chosen by what it would bring; what is wide (the environment, the discs of soft suns) also where the
// phase function leads, what is near (points and spots in the media) also at places of each flight that are
// chosen for it. An invocation traces the samples of its pixel one after the other for as long as its share
// of work lasts, and leaves what the next dispatch goes on from.
// Variant constants: SOLIDS, ENVIRONMENT, BACKDROP, TINTED, TRANSMITTANCE (TRANSMITTANCE_*), ORDER (1: only
// one range of orders counts) and those of lib/flight.glsl, lib/along.glsl, lib/disc.glsl and
// lib/light_transmittance.glsl.
#ifndef BACKDROP
#define BACKDROP 0
#endif
#include "shared/path.h"
#include "lib/backdrop.glsl"
#include "lib/along.glsl"
#include "lib/camera.glsl"
#include "lib/disc.glsl"
#include "lib/environment.glsl"
#include "lib/flight.glsl"
#include "lib/light_transmittance.glsl"
#include "lib/scatter.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

#ifndef ORDER
#define ORDER 0
#endif

layout(rgba32f, binding = IMAGE_MEAN) uniform image2D meanImage;
layout(rgba32f, binding = IMAGE_DEVIATIONS) uniform image2D deviationImage;
layout(rgba32f, binding = IMAGE_ODD) uniform image2D oddImage;
#if !ALONG
uniform int lightCount;
#endif
uniform int solidCount;
uniform ivec2 sampleRange;  // of this round: first, one behind the last
uniform int pathDispatch, pathBudget;
uniform int firstPath;      // number of sample 0's path
uniform int mostBounces;    // vertices that scatter behind the first; what is beyond MOST_BOUNCES is counted
uniform ivec2 orders;       // with ORDER: of them only from .. up to
uniform vec2 chances;       // share of the choice by unshadowed power; factor of what maps say
uniform float skyFactor;    // of the environment's part in that choice
const bool kSolids = SOLIDS != 0, kEnvironment = ENVIRONMENT != 0, kDiscs = DISCS != 0;
const float kSeriesDepth = 3.0;  // a series serves up to that optical depth, by the map

struct PathState {
  vec4 origin, direction;   // of the flight; w: end, left
  vec4 weight, ratio;       // of the path; w: density of its direction, chance of the environment there
  vec4 radiance;            // of the sample; w: alpha
  vec4 through, pending;    // of a flight that measures; w: place
  vec4 next;                // direction behind it, its density
  vec4 nextWeight;          // weight there, or where it begins; w: how far into its stretch the flight is
  ivec4 counts;             // sample, draws, bounces, flags
};
layout(std430, binding = BIND_PATH_STATES) buffer PathStates {
  int pathsLeft, above, tooLong, spare_;
  PathState pathStates[];
};
const int kMeasures = 1, kChannel = 2, kPathDone = 8, kLight = 16, kNear = 1024;

int work = 0;
void spendWork(int iterations) { work += iterations; }
bool workIsLeft() { return work < pathBudget; }

// Of the path.
Flight flight = Flight(vec3(0.0), vec3(0.0), 0.0, ivec2(0), vec2(0.0), 0.0, 0.0, kFlying, false, vec3(1.0));
vec4 radiance = vec4(0.0);  // rgb, and alpha
int bounces = 0;            // vertices before the flight
float density = -1.0;       // of the flight's direction [1/sr]; < 0: there was no choice
float sky = 0.0;            // chance of the environment at the vertex where it began
// What a flight that measures brings, and where the path goes on behind it.
vec3 pending = vec3(0.0), nextDirection = vec3(0.0), nextWeight = vec3(0.0);
float nextDensity = 0.0;
int lightOfFlight = -1;     // that is measured; -1: none, or the environment
// Of what is measured for a place that was chosen for being near a light: nothing, the way there, or from
// there to the light. The flight proper, from nextWeight along nextDirection, waits behind it.
int nearWay = 0;
const int kToPlace = 1, kToLight = 2;

float luminance(vec3 c) { return dot(c, vec3(0.2722287168, 0.6740817658, 0.0536895174)); }

int bounceLimit() { return mostBounces < 0 ? MOST_BOUNCES : mostBounces; }

// A list of volumes: 0 the drawn ones, 1 + l those that shadow light l.
ivec2 volumesOf(int list) { return tileRange(ivec2(kTile * list, 0)); }

// What a path brings by its vertices up to there, the first is 0.
void add(vec3 contribution, int vertex) {
#if ORDER
  contribution *= vertex >= orders.x && vertex <= orders.y ? 1.0 : 0.0;
#endif
  radiance.rgb += contribution;
}

// Fire is seen, and seen by so many scatterings as there are bounces.
void addGlow(vec3 glow) { add(bounces <= bounceLimit() ? glow : vec3(0.0), bounces); }

// Where the flight ends at the latest.
int endSolid = -1;
vec3 endNormal = vec3(0.0, 1.0, 0.0);
void findEnd() {
  endSolid = -1, endNormal = -flight.d;
  if (kSolids) flight.end = nearestSolid(solidCount, flight.o, flight.d, endSolid, endNormal);
}

// A flight that looks for a collision begins.
void look(vec3 o, vec3 d) {
  lightOfFlight = -1, nearWay = 0;
  flight = flightFrom(o, d, kNoHit, volumesOf(0), false);
  findEnd();
}

// One light, or -1 for the environment, chosen by what each would bring: its chance.
float chooseLight(Vertex v, out int chosen, out float skyChance) {
  vec3 u = random3();
  float power = 0.0, brought = 0.0;            // sums of both weights
  vec2 ofPower = vec2(0.0), ofBrought = vec2(0.0);  // of the light picked by either
  int byPower = 0, byBrought = 0;
  float pickPower = u.x, pickBrought = u.y;
  vec2 ofSky = vec2(0.0);
  int l = kEnvironment ? -1 : 0;
  do {
    float p = 0.0, b = 0.0;
#if ENVIRONMENT
    if (l < 0) {
      p = skyFactor * environmentPower / (4.0 * kPi), b = p / (4.0 * kPi);
      ofSky = vec2(p, b);
    } else
#endif
    {
      int light = max(l, 0);
      Incidence i = unshadowed(light, v.p);
      p = l < lightCount ? luminance(i.irradiance) : 0.0;
      b = p * scattersTo(v, i.towards);
#if LIGHT_KINDS & MAPPED_SHADOWS
      int shadow = lights[light].shadow.x;
      if (shadow != SHADOW_NONE && shadow != SHADOW_RAY_MARCH)
        b *= chances.y < 0.0 ? lookupTransmittance(light, v.p, !v.solid) : chances.y;
#endif
    }
    power += p, brought += b;
    bool takeP = p > 0.0 && pickPower * power < p, takeB = b > 0.0 && pickBrought * brought < b;
    pickPower = p <= 0.0 ? pickPower
                : takeP  ? pickPower * power / p
                         : (pickPower - p / power) / max(1.0 - p / power, 1e-30);
    pickBrought = b <= 0.0 ? pickBrought
                  : takeB  ? pickBrought * brought / b
                           : (pickBrought - b / brought) / max(1.0 - b / brought, 1e-30);
    byPower = takeP ? l : byPower, ofPower = takeP ? vec2(p, b) : ofPower;
    byBrought = takeB ? l : byBrought, ofBrought = takeB ? vec2(p, b) : ofBrought;
    spendWork(1);
    ++l;
  } while (l < lightCount);
  float share = brought > 0.0 ? chances.x : 1.0;
  bool usePower = u.z < share;
  chosen = usePower ? byPower : byBrought;
  vec2 w = usePower ? ofPower : ofBrought;
  float toPower = share / max(power, 1e-30), toBrought = (1.0 - share) / max(brought, 1e-30);
  skyChance = ofSky.x * toPower + ofSky.y * toBrought;
  return w.x * toPower + w.y * toBrought;
}

#if TRANSMITTANCE == TRANSMITTANCE_SERIES && (LIGHT_KINDS & MAPPED_SHADOWS)
// An unbiased estimate of the optical depth of what shadows a light, `combs` samples evenly placed along each
// grid and shifted together.
vec3 combDepth(ivec2 range, vec3 p, vec3 d, float end, float combs) {
  vec3 sum = vec3(0.0);
  int item = range.x;
  do {
    int v = tileItem(item);
    VolumeRay r;
    vec2 hit = enterVolume(v, p, d, 0, r);
    float t0 = max(hit.x, -r.anchor), t1 = max(min(hit.y, end - r.anchor), t0);
    bool grid = !r.analytic && t1 > t0;
    // At least one in each brick on average.
    vec3 voxels = abs(r.d) * (t1 - t0);
    int n = grid ? int(clamp(combs, 4.0 + largest(voxels) / kBrick, 256.0)) : 1;
    float ds = (t1 - t0) / float(n), u = random3().x, depth = 0.0;
    if (r.analytic) depth = max(r.extinction, 0.0) * (t1 - t0);
    int j = 0;
#if SHAPES & SHAPES_GRID
    do {
      for (int i = 0; i < 4; ++i) {
        float t = t0 + (float(j + i) + u) * ds;
        depth += grid && j + i < n ? sigmaAt(r, t) * ds : 0.0;
      }
      j += 4;
      spendWork(1);
    } while (j < n);
#endif
    sum += item < range.y ? depth * tintOf(v) : vec3(0.0);
    spendWork(1);
    ++item;
  } while (item < range.y);
  return sum;
}

// Transmittance around the optical depth that a map says, p: exp(-tau) = exp(-p) SUM (p - tau)^k / k!, each
// factor by a comb of its own, so that the mean is right whatever p is; ended at random.
vec3 seriesTransmittance(ivec2 range, vec3 p, vec3 d, float end, float mapped) {
  const float kGoesOn = 0.12;
  float combs = 32.0 * sqrt(mapped);
  vec3 term = vec3(1.0), sum = vec3(1.0);
  int k = 1;
  bool more = random3().x < kGoesOn;
  while (more) {
    term *= (mapped - combDepth(range, p, d, end, combs)) / (float(k) * kGoesOn);
    sum += term;
    ++k;
    more = random3().x < kGoesOn && k < 64;
  }
  return exp(-mapped) * sum;
}
#endif

#if DISCS
// Of what a disc brings from there: the part that is left to directions by the phase function, whose density
// that is. None where those see it through other media than it shines through.
float leftToPhase(int l, vec3 towards, float phase) {
  float dense = discDensity(l, towards);
  bool same = (lights[l].solids.z & LIGHT_BEHIND_ALL) != 0;
  return same && dense > 0.0 ? phase / (phase + dense) : 0.0;
}

// What a path that was led there gets of all discs.
vec3 discsAlong(vec3 d) {
  vec3 sum = vec3(0.0);
  int l = 0;
  do {
    float share = l < lightCount && isDisc(l) ? leftToPhase(l, d, density) * discDensity(l, d) : 0.0;
    sum += share * lights[l].emitted.rgb;
    spendWork(1);
    ++l;
  } while (l < lightCount);
  return sum;
}
#endif

#if ALONG
// Of what a vertex on the flight gets from light l that is in the media: the part that is left to collisions,
// with the extinction there for their density. What is near the light is left to the places chosen for it.
float leftToCollisions(int l, vec3 p) {
  NearRay r = nearRay(flight.o, flight.d, flight.end);
  float chosen = nearDensity(l, r, dot(p - flight.o, flight.d), allBroughtAlong(r));
  return metSigma / max(metSigma + chosen, 1e-30);
}
#endif

// What the chosen light brings to a vertex through nothing, over the chance that it was chosen; black where a
// solid stands between.
vec3 lightBrought(Vertex v, int light, float chance, out vec3 towards, out float distance, out ivec2 range) {
  vec3 brought = vec3(0.0);
  range = volumesOf(0), towards = vec3(0.0, 1.0, 0.0), distance = kNoHit;
#if ENVIRONMENT
  if (light < 0) {
    ivec2 at;
    towards = sampleEnvironment(random3(), at);
    float dense = environmentDensity(at) * chance, other = scattersTo(v, towards);
    vec3 n;
    int solid;
    bool seen = !kSolids || nearestSolid(solidCount, v.p, towards, solid, n) >= kNoHit;
    brought = dense > 0.0 && seen ? environmentAt(at).rgb * other / (dense + other) : vec3(0.0);
    return brought;
  }
#endif
  light = max(light, 0);
  Incidence i = unshadowed(light, v.p);
  towards = i.towards, distance = i.distance, range = volumesOf(1 + light);
  float share = 1.0;
#if DISCS
  if (isDisc(light)) {
    towards = discDirection(light, random3().xy);
    share = 1.0 - leftToPhase(light, towards, scattersTo(v, towards));
  }
#endif
#if ALONG
  if (!v.solid && (lights[light].solids.z & LIGHT_INSIDE) != 0) share = leftToCollisions(light, v.p);
#endif
  float visible = share * solidVisibility(light, v.p, towards, distance);
  return chance > 0.0 ? visible * scattersTo(v, towards) / chance * i.irradiance : vec3(0.0);
}

// On with what a light brings to p through nothing: the flight that measures the rest; or, where its map is
// good for that, a series at once (false).
bool measure(vec3 p, bool inMedium, vec3 brought, int light, vec3 towards, float distance, ivec2 range) {
#if TRANSMITTANCE == TRANSMITTANCE_SERIES && (LIGHT_KINDS & MAPPED_SHADOWS)
  // Where the map is dark a flight is soon over.
  int shadow = lights[max(light, 0)].shadow.x;
  if (light >= 0 && shadow != SHADOW_NONE && shadow != SHADOW_RAY_MARCH && chances.y < 0.0) {
    float mapped = -log(max(lookupTransmittance(light, p, inMedium), 1e-30));
    if (mapped < kSeriesDepth) {
      add(brought * seriesTransmittance(range, p, towards, distance, mapped), bounces);
      return false;
    }
  }
#endif
  pending = brought, lightOfFlight = light;
  flight = flightFrom(p, towards, distance, range, true);
  return true;
}

// Where there are lights in the media, and a vertex would still count: before a flight, the way to a place of
// it that is near one.
void beginNear() {
#if ALONG
  if (bounces > bounceLimit()) return;
  vec3 u = random3(), o = flight.o, d = flight.d;
  NearRay r = nearRay(o, d, flight.end);
  float all = allBroughtAlong(r), t;
  int l = chooseNear(r, all, u.xy, t);
  float sigma = mediumAlong(flight.range, o, d, t, u.z), chosen = nearDensity(max(l, 0), r, t, all);
  if (l < 0 || sigma <= 0.0 || chosen <= 0.0) return;
  Vertex v = mediumVertex(d);
  Incidence i = unshadowed(l, v.p);
  float visible = solidVisibility(l, v.p, i.towards, i.distance) * scattersTo(v, i.towards);
  // By the balance of both ways to come to this place.
  float share = visible * sigma / (chosen + sigma);
  vec3 brought = pathMean() * v.albedo * tintOf(metVolume) * i.irradiance * share;
  if (largest(brought) <= 0.0) return;
  pending = brought, lightOfFlight = l, nearWay = kToPlace;
  nextWeight = o, nextDirection = d;
  flight = flightFrom(o, d, t, volumesOf(0), true);
#endif
}

// Behind the way to a place near a light, or from there to it.
bool arriveNear() {
#if ALONG
  pending *= flight.through;
  bool dark = largest(pending) <= 0.0;
  if (nearWay == kToPlace && !dark) {
    int l = lightOfFlight;
    vec3 p = flight.o + flight.end * flight.d;
    Incidence i = unshadowed(l, p);
    nearWay = kToLight;
    if (measure(p, true, pending, l, i.towards, i.distance, volumesOf(1 + l))) return true;
  } else if (!dark) {
    add(pending, bounces);
  }
  look(nextWeight, nextDirection);
#endif
  return true;
}

void beginSample(ivec2 pixel, int s) {
  seedPath(pixel, firstPath + s);
  vec3 u = random3();
  pathWeight = vec3(1.0), pathRatio = vec3(1.0);
  pathChannel = min(int(3.0 * u.z), 2);
  radiance = vec4(0.0);
  bounces = 0, density = -1.0, sky = 0.0;
  look(eye, cameraDirection(pixel, u.xy));
  beginNear();
}

// Behind a vertex and its light: on, or the end of the sample.
bool continuePath() {
  pathWeight = nextWeight, density = nextDensity;
  ++bounces;
  if (largest(pathWeight) <= 0.0) return false;
  look(flight.o, nextDirection);
  beginNear();
  return true;
}

// A vertex: chooses where the path goes and what lights it. False: the sample ends here.
bool scatter(Vertex v) {
  pathWeight *= v.albedo;
  nextWeight = pathWeight;
  nextDirection = scatteredDirection(v), nextDensity = scattersTo(v, nextDirection);
  // Roulette, once a path is long.
  float loud = largest(pathWeight), goes = bounces < 8 ? 1.0 : clamp(loud / 0.25, 0.05, 1.0);
  nextWeight *= random3().x < goes ? 1.0 / goes : 0.0;
  bool last = bounces >= bounceLimit();
  if (last && mostBounces < 0) atomicAdd(tooLong, 1);
  // What is wide is still looked at behind the last vertex.
  nextWeight *= last && !kEnvironment && !kDiscs ? 0.0 : 1.0;
  int light;
  float chance = chooseLight(v, light, sky);
  vec3 towards;
  float distance;
  ivec2 range;
  vec3 brought = pathMean() * lightBrought(v, light, chance, towards, distance, range);
  flight.o = v.p;
  if (largest(brought) <= 0.0) return continuePath();
  return measure(v.p, !v.solid, brought, light, towards, distance, range) || continuePath();
}

// The end of a flight. False: the sample ends with it.
bool arrive() {
  if (flight.measures) {
    if (nearWay > 0) return arriveNear();
    add(pending * flight.through, bounces);
    return continuePath();
  }
  bool collided = flight.state == kCollided, solid = !collided && flight.end < kNoHit;
  bool camera = density < 0.0;
  vec3 passes = pathMean();
  if (camera && collided) radiance.a = 1.0;
  if (camera && !collided) radiance.a = solid ? 1.0 : 1.0 - (passes.r + passes.g + passes.b) / 3.0;
  if (!collided && !solid) {
#if ENVIRONMENT
    if (!camera) {
      ivec2 at = environmentTexel(flight.d);
      float other = environmentDensity(at) * sky;
      add(passes * density / max(density + other, 1e-30) * environmentAt(at).rgb, bounces - 1);
    }
#endif
#if DISCS
    if (!camera) add(passes * discsAlong(flight.d), bounces - 1);
#endif
#if BACKDROP
    if (camera) add(passes * backdrop(flight.d), 0);
#endif
    return false;
  }
  if (bounces > bounceLimit()) return false;
  Vertex v = mediumVertex(flight.d);
  if (solid) {
    v.solid = true, v.normal = endNormal;
    v.p = flight.o + flight.end * flight.d;
    v.p += solidClearance(endSolid, v.p, endNormal, flight.end) * endNormal;
    v.albedo = solidAlbedo(endSolid);
  }
  return scatter(v);
}

void store(ivec2 pixel, int s) {
  vec4 before = s == 0 ? vec4(0.0) : imageLoad(meanImage, pixel), now = radiance;
  vec4 mean = before + (now - before) / float(s + 1);
  imageStore(meanImage, pixel, mean);
  vec4 deviations = s == 0 ? vec4(0.0) : imageLoad(deviationImage, pixel);
  imageStore(deviationImage, pixel, deviations + (now - before) * (now - mean));
  if ((s & 1) == 1) {
    vec4 odd = s == 1 ? vec4(0.0) : imageLoad(oddImage, pixel);
    imageStore(oddImage, pixel, odd + (now - odd) / float((s + 1) / 2));
  }
}

int keepFlags() {
  return (flight.measures ? kMeasures : 0) | pathChannel * kChannel | (lightOfFlight + 1) * kLight |
         nearWay * kNear;
}

void load(PathState k, ivec2 pixel) {
  seedPath(pixel, firstPath + k.counts.x);
  pathDraws = uint(k.counts.y);
  bounces = k.counts.z;
  pathChannel = k.counts.w / kChannel & 3;
  flight.measures = (k.counts.w & kMeasures) != 0;
  lightOfFlight = (k.counts.w / kLight & 63) - 1, nearWay = k.counts.w / kNear & 3;
  flight.o = k.origin.xyz, flight.end = k.origin.w;
  flight.d = k.direction.xyz, flight.left = k.direction.w;
  flight.place = vec2(k.through.w, k.pending.w);
  flight.at = k.nextWeight.w;
  flight.through = k.through.rgb, flight.state = kFlying;
  flight.range = volumesOf(nearWay == kToPlace ? 0 : lightOfFlight + 1);
  pathWeight = k.weight.rgb, density = k.weight.w;
  pathRatio = k.ratio.rgb, sky = k.ratio.w;
  radiance = k.radiance;
  pending = k.pending.rgb;
  nextDirection = k.next.xyz, nextDensity = k.next.w;
  nextWeight = k.nextWeight.rgb;
  if (!flight.measures) findEnd();
}

void save(int slot, int s, bool finished) {
  PathState k;
  k.origin = vec4(flight.o, flight.end), k.direction = vec4(flight.d, flight.left);
  k.through = vec4(flight.through, flight.place.x), k.pending = vec4(pending, flight.place.y);
  k.weight = vec4(pathWeight, density), k.ratio = vec4(pathRatio, sky);
  k.radiance = radiance;
  k.next = vec4(nextDirection, nextDensity), k.nextWeight = vec4(nextWeight, flight.at);
  k.counts = ivec4(s, int(pathDraws), bounces, keepFlags() | (finished ? kPathDone : 0));
  pathStates[slot] = k;
}

void main() {
  ivec2 pixel = regionPixel();
  if (!inRegion(pixel)) return;
  int slot = regionSlot(pixel), s = sampleRange.x;
  if (pathDispatch == 0) {
    beginSample(pixel, s);
  } else {
    PathState k = pathStates[slot];
    if ((k.counts.w & kPathDone) != 0) return;
    s = k.counts.x;
    load(k, pixel);
  }
  bool finished = false;
  do {
    fly(flight);
    if (flight.state != kFlying && !arrive()) {
      store(pixel, s);
      ++s;
      finished = s >= sampleRange.y;
      beginSample(pixel, s);
    }
    spendWork(4);
  } while (!finished && workIsLeft());
  save(slot, s, finished);
  if (!finished) atomicAdd(pathsLeft, 1);
  if (violations > 0) atomicAdd(above, violations);
}
