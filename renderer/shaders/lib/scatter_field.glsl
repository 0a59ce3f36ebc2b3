// Light that has been scattered at least once: moments of its radiance on lattices, the first one around all,
// the others within it where media are denser and finer. Of each three blocks, one per channel, lie side by
// side along z in one texture (view/scatter_field.h).
#pragma once
#include "shared/scatter.h"

layout(binding = UNIT_SCATTER) uniform sampler3D scatterMoments;
uniform int scatterCount;
uniform float scatterCellDepth;
uniform vec4 scatterMin[SCATTER_LATTICES];    // xyz: relative to the pass's origin; w: edge of a cell [m]
uniform ivec4 scatterCells[SCATTER_LATTICES]; // xyz: cells; w: first layer of the texture

// Where a place is in the texture: texels of the first channel, and from one channel to the next.
struct ScatterPlace {
  vec3 texel;
  float next;
};

// The finest one that holds a place.
int scatterLattice(vec3 p) {
  int chosen = 0;
  for (int i = 1; i < SCATTER_LATTICES; ++i) {
    vec3 q = (p - scatterMin[i].xyz) / scatterMin[i].w, size = vec3(scatterCells[i].xyz);
    bool inside = i < scatterCount && all(greaterThan(q, vec3(0.0))) && all(lessThan(q, size));
    chosen = inside ? i : chosen;
  }
  return chosen;
}

ScatterPlace scatterPlace(int lattice, vec3 p) {
  vec3 size = vec3(scatterCells[lattice].xyz);
  vec3 q = clamp((p - scatterMin[lattice].xyz) / scatterMin[lattice].w, vec3(0.5), size - 0.5);
  return ScatterPlace(q + vec3(0.0, 0.0, float(scatterCells[lattice].w)), size.z);
}

// xyz: radiance times direction, w: radiance, over all directions.
vec4 scatterMoment(ScatterPlace at, int channel) {
  vec3 texel = at.texel + vec3(0.0, 0.0, float(channel) * at.next);
  return textureLod(scatterMoments, texel / vec3(textureSize(scatterMoments, 0)), 0.0);
}

// How much longer a way through media of that extinction is in the lattice: there none has a greater optical
// depth than scatterCellDepth per cell.
float scatterStretch(int lattice, vec3 extinction) {
  float depth = max(max(extinction.r, extinction.g), extinction.b) * scatterMin[lattice].w;
  return max(depth / scatterCellDepth, 1.0);
}

// What of it is scattered at p, in that lattice, into direction d, per metre: by scaled scattering, and that
// times the mean cosine [1/m].
vec3 scatteredAgain(int lattice, vec3 p, vec3 d, vec3 scattering, vec3 forward) {
  ScatterPlace at = scatterPlace(lattice, p);
  vec3 sum = vec3(0.0);
  for (int c = 0; c < 3; ++c) {
    vec4 m = scatterMoment(at, c);
    sum[c] = max(scattering[c] * m.w + 3.0 * forward[c] * dot(m.xyz, d), 0.0);
  }
  return sum / (4.0 * 3.14159265358979);
}

// What falls of it on a surface at p, looked up a cell off it, where none of its own cells are [W/m^2].
vec3 scatteredOnto(vec3 p, vec3 normal) {
  int lattice = scatterLattice(p);
  ScatterPlace at = scatterPlace(lattice, p + scatterMin[lattice].w * normal);
  vec3 sum = vec3(0.0);
  for (int c = 0; c < 3; ++c) {
    vec4 m = scatterMoment(at, c);
    sum[c] = max(0.25 * m.w - 0.5 * dot(m.xyz, normal), 0.0);
  }
  return sum;
}
