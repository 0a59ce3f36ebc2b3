// Records and lists of a pass in one buffer texture, cut into sections; residency/scene_table.h fills it.
// Its texels are integers: what is read as floats may lose small numbers on the way.
#pragma once
#include "shared/bindings.h"

layout(binding = UNIT_SCENE) uniform usamplerBuffer sceneTexels;
uniform ivec4 sceneSections;  // first texels: x tile offsets, y tile items, z shadow items, w solids
uniform int sceneAir;         // and of what suns are seen through

uvec4 sceneBits(int texel) { return texelFetch(sceneTexels, texel); }
vec4 sceneFloats(int texel) { return uintBitsToFloat(sceneBits(texel)); }

// Of numbers that lie four to a texel, counted from the start of the table.
int sceneNumber(int i) { return int(sceneBits(i >> 2)[i & 3]); }
