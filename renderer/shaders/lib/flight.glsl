// Free flights by null collisions: from majorant to majorant, brick by brick, through whatever volumes
// overlap. A flight that looks for a collision ends at the first real one; a flight that measures (ratio
// tracking) gathers transmittance instead. Unbiased in whatever is bounded rightly; what is above its bound
// is counted and weighted.
// Who includes this says when to pause (spendWork, workIsLeft) and what to do with emission that is passed
// (addGlow). Variant constants: those of lib/stretch.glsl,
// TINTED (1: extinction has colours).
#pragma once
#define STRETCH_IDS 1
#include "lib/stretch.glsl"
#include "lib/majorants.glsl"
#include "lib/path_random.glsl"

#ifndef TINTED
#define TINTED 0
#endif

const int kFlying = 0, kCollided = 1, kArrived = 2;
const float kAbove = 1e-4;  // rounding of what is at its bound
const float kFaint = 0.05;  // a measured transmittance below that is weighed against ending

void spendWork(int iterations);
void addGlow(vec3 glow);  // weighted
bool workIsLeft();
int violations = 0;

struct Flight {
  vec3 o, d;
  float end;     // [m]: a solid or a light, else kNoHit
  ivec2 range;   // list of volumes
  vec2 place;    // where its stretch begins: anchor, rest; ...
  float at;      // ... and how far into that it is
  float left;    // of the majorants' optical depth to the next tentative collision
  int state;
  bool measures;
  vec3 through;  // that one's transmittance
};

// What a flight that looks for collisions weighs: its contribution over the density of the channel that
// decides, and the densities of all channels over that one's (Miller, Georgiev and Jarosz 2019).
vec3 pathWeight = vec3(1.0), pathRatio = vec3(1.0);
int pathChannel = 0;  // that decides

// Where it collided, and with what.
vec3 metAt = vec3(0.0);
int metVolume = 0;
vec3 metFactor = vec3(1.0);  // of its albedo, by a table of densities
float metSigma = 0.0;        // of all that is there [1/m]

vec3 tint(int v) {
#if TINTED
  return tintOf(v);
#else
  return vec3(1.0);
#endif
}
float largest(vec3 c) { return max(max(c.r, c.g), c.b); }

// What the weight counts where any of the channels might have decided.
vec3 pathMean() {
#if TINTED
  return pathWeight * 3.0 / max(pathRatio.r + pathRatio.g + pathRatio.b, 1e-30);
#else
  return pathWeight;
#endif
}

Flight flightFrom(vec3 o, vec3 d, float end, ivec2 range, bool measures) {
  Flight f;
  f.o = o, f.d = d, f.end = end, f.range = range;
  f.place = vec2(0.0), f.at = 0.0, f.left = exponential(random3().x);
  f.state = kFlying, f.measures = measures, f.through = vec3(1.0);
  return f;
}

// At a tentative collision under a bound `most` of every channel: real (true) or null, chosen by the deciding
// channel.
bool decide(vec3 sigma, float most, float u) {
  vec3 null = abs(most - sigma), real = sigma / max(sigma + null, vec3(1e-30));
#if TINTED
  float p = real[pathChannel];
#else
  float p = real.r;
#endif
  bool collides = u < p;
  vec3 chance = collides ? real : 1.0 - real;
  float chosen = collides ? p : 1.0 - p;
  pathWeight *= (collides ? vec3(1.0) : most - sigma) / max(most * chosen, 1e-30);
#if TINTED
  pathRatio *= chance / max(chosen, 1e-30);
#endif
  return collides;
}

// The sum of extinctions so far, and a volume picked by its share of it with a number in [0, 1), of which
// what is left is one again.
struct Pick {
  float sum, number;
};

void takeVolume(inout Pick p, int v, vec4 medium) {
  float share = medium.w;
  p.sum += share;
  bool taken = share > 0.0 && p.number * p.sum < share;
  p.number = share <= 0.0 ? p.number
             : taken      ? p.number * p.sum / share
                          : (p.number - share / p.sum) / (1.0 - share / p.sum);
  metVolume = taken ? v : metVolume;
  metFactor = taken ? medium.rgb : metFactor;
}

// One piece: up to where a bound ends or a tentative collision is.
void flyPiece(inout Stretch s, inout Flight f) {
  Bound bounds[ACTIVE];
  float most = 0.0, until = s.span;
  for (int k = 0; k < ACTIVE; ++k) {
    bounds[k] = boundOf(s.rays[k], s.ids[k], s.at);
    bool counts = k < s.count;
    most += counts ? bounds[k].most * largest(tint(s.ids[k])) : 0.0;
    until = counts ? min(until, bounds[k].until) : until;
  }
  if (kOverflow) {
    for (int item = s.rest; item < s.range.y; ++item) {
      VolumeRay ray;
      int v = tileItem(item);
      if (isActive(s, item, ray)) {
        Bound b = boundOf(ray, v, s.at);
        most += b.most * largest(tint(v));
        until = min(until, b.until);
      }
      spendWork(1);
    }
  }
  vec3 u = random3();
  float reach = f.left / max(most, 1e-30);
  bool tentative = most > 0.0 && s.at + reach < until;
  float to = tentative ? s.at + reach : min(until, s.span);
  // Somewhere in the piece: what is emitted there stands for all of it.
  float glowing = mix(s.at, to, u.y);
  vec3 sigma = vec3(0.0), glow = vec3(0.0);
  Pick pick = Pick(0.0, u.x);
  for (int k = 0; k < ACTIVE; ++k) {
    bool counts = k < s.count;
    vec4 here = mediumAt(s.rays[k], placeWithin(bounds[k], s.rays[k], to));
    here.w = counts ? here.w : 0.0;
    sigma += here.w * tint(s.ids[k]);
#if EMISSION
    vec4 table = mediumAt(s.rays[k], placeWithin(bounds[k], s.rays[k], glowing));
    glow += counts ? glowOf(s, k, table) : vec3(0.0);
#endif
    takeVolume(pick, s.ids[k], here);
  }
  if (kOverflow) {
    for (int item = s.rest; item < s.range.y; ++item) {
      VolumeRay ray;
      int v = tileItem(item);
      if (isActive(s, item, ray)) {
        Bound b = boundOf(ray, v, s.at);
        vec4 here = mediumAt(ray, placeWithin(b, ray, to));
        sigma += here.w * tint(v);
#if EMISSION
        glow += glowOf(item, ray, mediumAt(ray, placeWithin(b, ray, glowing)));
#endif
        takeVolume(pick, v, here);
      }
      spendWork(1);
    }
  }
#if EMISSION
  if (!f.measures) addGlow(pathMean() * glow * (to - s.at));
#endif
  f.left = tentative ? exponential(u.z) : max(f.left - most * (to - s.at), 0.0);
  s.at = to;
  if (!tentative) return;
  violations += largest(sigma) > most * (1.0 + kAbove) ? 1 : 0;
  vec3 v = random3();
  if (f.measures) {
    f.through *= (most - sigma) / most;
    float loudest = largest(abs(f.through)), goes = max(loudest / kFaint, 0.2);
    bool ends = goes < 1.0 && v.y >= goes;
    f.through = ends ? vec3(0.0) : f.through / min(goes, 1.0);
    f.state = loudest <= 0.0 || ends ? kArrived : kFlying;
  } else if (decide(sigma, most, v.x)) {
    f.state = kCollided;
    metAt = pointAt(s, to), metSigma = pick.sum;
    // The chosen one's part of the extinction over the chance that it was chosen by.
    pathWeight *= pick.sum * tint(metVolume);
  }
}

void flyThrough(inout Stretch s, inout Flight f) {
  s.at = f.at;
  do {
    flyPiece(s, f);
    spendWork(1);
  } while (f.state == kFlying && s.at < s.span && workIsLeft());
}

// On, until something has happened or the work of this dispatch is done.
void fly(inout Flight f) {
  Stretch s = beginStretches(f.o, f.d, f.place, f.end, f.range, 0.5, 1.0);
  bool more = f.state == kFlying;
  if (more && f.range.x >= f.range.y) f.state = kArrived, more = false;
  while (more) {
    spendWork(1 + f.range.y - f.range.x);
    if (!nextStretch(s, 0.0, 1.0)) {
      f.state = kArrived;
      break;
    }
    bool inside = s.count > 0;
    if (inside) flyThrough(s, f);
    bool through = !inside || s.at >= s.span;
    // What goes on in another dispatch is the same there to the last bit.
    f.place = through ? s.next : s.begin, f.at = through ? 0.0 : s.at;
    if (f.state == kFlying && through && endsHere(s)) f.state = kArrived;
    more = f.state == kFlying && workIsLeft();
  }
}
