// What the cells of a lattice hold of media, and what of the lights is scattered there for the first time:
// one of SCATTER_SAMPLES places of each cell a dispatch, all media before all lights. An invocation has a
// cell: x of the region is its x, y is y + z * cells.y. Of a dense cell the light that comes in through its
// faces and does not go out is scattered there, or absorbed, wherever in it that is. Solid cells (known
// beforehand) get what each open face sends back of the lights.
// Variant constants: those of lib/light_transmittance.glsl and, of lib/stretch.glsl, EMISSION.
#include "shared/scatter.h"
#include "lib/camera.glsl"
#include "lib/light_transmittance.glsl"
#include "lib/tiles.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

#ifndef EMISSION
#define EMISSION 0
#endif

// transport::Cell.
struct ScatterCell {
  vec4 first[3];
  vec4 extinction, scattering, forward, glow;
};
layout(std430, binding = BIND_SCATTER_CELLS) buffer ScatterCells { ScatterCell cells[]; };
uniform ivec3 latticeCells;
uniform vec3 latticeMin;    // relative to the pass's origin
uniform float latticeCell;  // [m]
uniform int sampleIndex;
uniform int ofLights;       // 0: media are gathered; 1: lights
uniform int lightCount;     // at least one
uniform vec3 lightScale;    // scaled optical depths of light are so many times those of the maps

// At a place: scaled sums over the media of it.
struct Here {
  vec3 extinction, scattering, forward, glow;
};

// The mip whose voxels match a length [m], however dense they are: a cell has means.
int meanLevel(int v, float footprint) {
  ivec4 shape = shapeOf(v);
  float octave = floor(log2(max(footprint / detailOf(v), 1.0)) + 1e-4);
  return clamp(shape.w + int(octave), shape.w, max(shape.z - 1, shape.w));
}

Here mediaAt(vec3 p) {
  Here here = Here(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
  ivec2 range = tileRange(ivec2(0));
  for (int item = range.x; item < range.y; ++item) {
    int v = tileItem(item);
    VolumeRay ray;
    vec2 hit = enterVolume(v, p, vec3(1.0, 0.0, 0.0), meanLevel(v, 0.5 * latticeCell), ray);
    float t = -ray.anchor;
    bool inside = hit.x <= t && t < hit.y;
    vec4 albedo = albedoOf(v), medium = mediumAt(ray, t);
    medium.w = inside ? medium.w : 0.0;
    vec2 scaled = scaledPhaseOf(v);
    vec3 sigma = medium.w * tintOf(v), w = albedo.rgb * medium.rgb, s = sigma * w * (1.0 - scaled.x);
    here.extinction += sigma * (1.0 - w * scaled.x);
    here.scattering += s;
    here.forward += s * scaled.y;
#if EMISSION
    here.glow += inside && ray.extinction < 0.0 ? albedo.rgb * medium.rgb : vec3(0.0);
#endif
  }
  return here;
}

// E of light l at p through what is scaled of the media, and past solids. Near lights are no nearer than a
// quarter of a cell, of which the place stands for an eighth.
vec3 scaledArriving(int l, vec3 p, float transmittance, Incidence i) {
  float nearest = 0.25 * latticeCell;
  float r = i.distance, falloff = r < nearest ? r * r / (nearest * nearest) : 1.0;
  vec3 through = exp(lightScale * log(max(transmittance, 1e-30)));
  return i.irradiance * falloff * through * solidVisibility(l, p, i.towards, i.distance);
}

vec3 placeOf(ivec3 cell) {
  vec3 corner = vec3(sampleIndex & 1, (sampleIndex >> 1) & 1, (sampleIndex >> 2) & 1);
  return latticeMin + latticeCell * (vec3(cell) + 0.25 + 0.5 * corner);
}
vec3 faceNormal() {
  vec3 normal = vec3(0.0);
  normal[sampleIndex >> 1] = (sampleIndex & 1) == 0 ? -1.0 : 1.0;
  return normal;
}

void gatherMedium(int index, ivec3 cell) {
  const float kShare = 1.0 / float(SCATTER_SAMPLES);
  Here here = mediaAt(placeOf(cell));
  cells[index].extinction.rgb += kShare * here.extinction;
  cells[index].scattering.rgb += kShare * here.scattering;
  cells[index].forward.rgb += kShare * here.forward;
  cells[index].glow.rgb += kShare * here.glow;
}

// What is scattered of the light that arrives at `p`: `scattering` and `forward` of it per metre, or where
// there is a normal as much of what passes that way.
void gatherScattered(int index, vec3 p, vec3 normal, vec3 scattering, vec3 forward) {
  bool passing = normal != vec3(0.0);
  int l = 0;
  do {
    if (lightIsDue(l)) {
      Incidence i = unshadowed(l, p);
      float T = lightTransmittanceTowards(l, placeAt(p), i.towards, i.distance, true);
      lightDone(l);
      if (!paused) {
        vec3 arriving = scaledArriving(l, p, T, i);
        arriving *= passing ? dot(normal, i.towards) : 1.0;
        // Lights that stand for many directions are blurred, as phase functions are under them.
        float narrow = lights[l].items.w == LIGHT_SUN ? lights[l].towards.w : 1.0;
        vec3 first = scattering * arriving, ahead = narrow * forward * arriving;
        for (int c = 0; c < 3; ++c) cells[index].first[c] += vec4(-i.towards * ahead[c], first[c]);
      }
    }
    ++l;
  } while (l < lightCount);
}

// Deeper than this cells are dense: between samples light changes too much.
const float kDense = 1.0;

void gatherLight(int index, ivec3 cell) {
  vec3 deep = cells[index].extinction.rgb, scattering = cells[index].scattering.rgb;
  if (max(max(scattering.r, scattering.g), scattering.b) <= 0.0) return;
  if (max(max(deep.r, deep.g), deep.b) * latticeCell <= kDense) {
    Here here = mediaAt(placeOf(cell));
    if (any(greaterThan(here.scattering, vec3(0.0)))) {
      const float kShare = 1.0 / float(SCATTER_SAMPLES);
      gatherScattered(index, placeOf(cell), vec3(0.0), kShare * here.scattering, kShare * here.forward);
    }
  } else if (sampleIndex < 6) {
    vec3 normal = faceNormal(), of = 1.0 / (max(deep, vec3(1e-30)) * latticeCell);
    gatherScattered(index, latticeMin + latticeCell * (vec3(cell) + 0.5 + 0.5 * normal), normal,
                    scattering * of, cells[index].forward.rgb * of);
  }
}

// What a face sends back of the lights: transport::sentOf(). Open faces are bits of glow.w.
void gatherSolid(int index, ivec3 cell) {
  int face = sampleIndex;
  if (face >= 6 || (int(cells[index].glow.w) & (1 << face)) == 0) return;
  vec3 normal = faceNormal(), p = latticeMin + latticeCell * (vec3(cell) + 0.5 + 0.501 * normal);
  int l = 0;
  do {
    if (lightIsDue(l)) {
      Incidence i = unshadowed(l, p);
      float facing = max(dot(normal, i.towards), 0.0), T = 0.0;
      if (facing > 0.0) T = lightTransmittanceTowards(l, placeAt(p), i.towards, i.distance, true);
      lightDone(l);
      if (!paused) {
        vec3 sent = cells[index].scattering.rgb * facing * scaledArriving(l, p, T, i);
        for (int c = 0; c < 3; ++c) {
          if (face < 4) cells[index].first[c][face] += sent[c];
          else if (face == 4) cells[index].forward[c] += sent[c];
          else cells[index].glow[c] += sent[c];
        }
      }
    }
    ++l;
  } while (l < lightCount);
}

void main() {
  ivec2 pixel = regionPixel();
  if (!inRegion(pixel)) return;
  vec4 seen = vec4(0.0);
  int slot = regionSlot(pixel);
  if (!goOn(slot, seen)) return;
  ivec3 cell = ivec3(pixel.x, pixel.y % latticeCells.y, pixel.y / latticeCells.y);
  int index = pixel.y * latticeCells.x + pixel.x;
  bool solid = cells[index].extinction.w > 0.0;
  if (ofLights == 0) {
    if (!solid) gatherMedium(index, cell);
  } else if (solid) {
    gatherSolid(index, cell);
  } else {
    gatherLight(index, cell);
  }
  keep(slot, vec4(1.0));
}
