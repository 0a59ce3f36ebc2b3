// The texel of a light's map a thread works on. The faces of a point light stand one below the other,
// faceStride rows apart.
#pragma once
#include "lib/light.glsl"
uniform ivec2 regionOrigin, regionEnd;
uniform int faceStride, mapEdge;
// Metres a texel covers: footprint + footprintAngle * metres from the light.
uniform float footprint, footprintAngle;

struct MapTexel {
  ivec2 tall, texel;  // in the tall map (tile lists); on its face
  int face;
  bool valid;
};

MapTexel mapTexel(ivec2 tall) {
  MapTexel m;
  m.tall = tall;
  m.face = tall.y / faceStride;
  m.texel = ivec2(tall.x, tall.y - m.face * faceStride);
  m.valid = all(lessThan(tall, regionEnd)) && all(lessThan(m.texel, ivec2(mapEdge)));
  return m;
}

MapTexel mapTexelOf(uvec2 thread) { return mapTexel(regionOrigin + ivec2(thread)); }
vec2 texelUv(MapTexel m) { return (vec2(m.texel) + 0.5) / float(mapEdge); }
float footprintAt(float metres) {
  return footprint + footprintAngle * (lights[0].extent.z + max(metres, 0.0));
}
