// Structures in buffers, read by C++ (glm types) and GLSL. Everything is a multiple of 16 bytes: the same in
// std140, std430 and as texels.
#ifdef __cplusplus
#pragma once
#include "renderer/base/math.h"
namespace pileus::gpu {
#endif

#define SHAPE_GRID 0
#define SHAPE_BOX 1
#define SHAPE_BALL 2

// The variant constant SHAPES has a bit for each kind of volume the scene has.
#define SHAPES_GRID 1
#define SHAPES_EXACT 2     // boxes and balls
#define SHAPES_REMAPPED 4  // grids with a table

// One placed volume, VOLUME_ROWS texels of the scene table. Local space is index coordinates relative to the
// lattice origin for grids, [-0.5,0.5]^3 for boxes, the unit ball.
#define VOLUME_ROWS 16
struct VolumeRecord {
  mat4 localFromWorld;
  mat4 worldFromLocal;
  vec4 boundsMin;  // local; w: extinction [1/m per unit density], or < 0: it only emits
  vec4 boundsMax;  // local; w: uniform density of a box or ball
  vec4 albedo;  // rgb; w: g of Henyey and Greenstein, or with PHASE_LOBES the share of the second lobe. Of
                // what emits: factor of the table's rgb, radiance gained per metre
  vec4 detail;  // x: smallest detail [m], y: shortest mean free path [m], z: share of the phase function that
                // goes straight on, w: mean cosine of the rest (scene::scaledPhase)
  ivec4 shape;  // x: SHAPE_*, y: texel of its first LevelRecord, z: number of levels, w: first resident level
  vec4 remap;  // x: first of the REMAP_ENTRIES texels of its table, < 0: none; y, z: density d is entry y d +
               // z; w: empty up to it
  vec4 phase;  // g and alpha of Draine's lobe, and of a second one
  vec4 tint;   // rgb: sigma_t of a channel by the mean of all three; w: texel of its table of scattered peaks
};

// Tables of remapped densities follow the volume records in the table: rgb factor of the albedo, w density.
#define REMAP_ENTRIES 256

// One mip level of a resident grid, a texel behind the volume records.
struct LevelRecord {
  ivec4 bricks;  // xyz: lattice size in bricks, w: index of its first page
};

// A page is a uvec4: x slot in the atlas (10 bits per axis: integer division costs 100 cycles a lane on a
// CPU) or PAGE_CONSTANT, y bits of offset, z bits of scale, w bits of the brick's maximum.
#define PAGE_CONSTANT 0xFFFFFFFFu

#define SHADOW_NONE 0
#define SHADOW_EXTINCTION 1
#define SHADOW_RAY_MARCH 2
#define SHADOW_TRANSMITTANCE 3
#define SHADOW_DEEP 4

// The variant constant LIGHT_KINDS has a bit for each SHADOW_* that lights of the scene have.
#define HAS_SHADOW(kind) ((LIGHT_KINDS >> (kind)) & 1)
#define MAPPED_SHADOWS (1 << SHADOW_EXTINCTION | 1 << SHADOW_TRANSMITTANCE | 1 << SHADOW_DEEP)  // looked up

#define LIGHT_SUN 0
#define LIGHT_POINT 1
#define LIGHT_SPOT 2

#define METRIC_NONE 0
#define METRIC_INTERVAL 1
#define METRIC_COSINE 2
#define METRIC_FOURIER 3

#define BASIS_COSINE 0
#define BASIS_FOURIER 1
#define BASIS_SLAB 2
#define BASIS_PIECEWISE 3
// The variant constant LOOKUP_BASES has a bit for each BASIS_* of the extinction maps.
#define PIECEWISE_BASES (1 << BASIS_PIECEWISE)

#define STORE_FLOAT 0
#define STORE_HALF 1
#define STORE_UNORM 2
#define STORE_BYTE 3  // RGBA8: compact intervals; fourth roots of weights
#define STORE_PAIR 4  // RG16F: horizons

// Where a block of map layers lies in the shadow store.
struct BlockRecord {
  ivec4 place;  // x, y: first texel; z: edge in texels; w: first layer
  ivec4 kind;   // x: STORE_*, y: layers of one face, z: faces (6 for a point light, in order; else 1)
};

// Bits of a light's solids.z.
#define LIGHT_HAS_WEIGHTS 1  // of intervals
#define LIGHT_HAS_HORIZON 2
// For path tracers: a point or spot in the box around what is drawn; one that all that is drawn shadows.
#define LIGHT_INSIDE 4
#define LIGHT_BEHIND_ALL 8

// Of a sun behind air, so many texels of the scene table: transmittance by colour at heights above the sea
// that rise with the square of the index up to AIR_TOP metres.
#define SUN_HEIGHTS 512
#define AIR_TOP 100e3

// As a uniform block, which is guaranteed 16 KiB; with MANY_LIGHTS they are a storage block without limit.
#define MAX_LIGHTS 48
struct LightRecord {
  mat4 lightFromWorld;  // sun: world -> (u, v, x) in [0,1]^3, x from the near to the far plane; else: rigid,
                        // the light at the origin, z along its axis
  mat4 worldFromLight;
  vec4 towards;   // xyz: unit vector towards the sun, or against the axis of a spot; w: cosine at the edge of
                  // a spot's cone, of a sun the mean cosine of the directions it stands for
  vec4 emitted;   // rgb: irradiance [W/m^2] or radiant intensity [W/sr]; w: radius [m], of a sun the
                  // sine of half its diameter
  vec4 extent;    // x: metres from near to far; y: step scale of a ray march; z: near distance [m] (0 for a
                  // sun); w: tangent of a map's half angle
  vec4 position;  // xyz: of a point or spot light; w: cosine where a spot begins to fade. Of a sun behind
                  // air y: height above the sea of what places are relative to
  ivec4 shadow;   // x: SHADOW_*, y: BASIS_*, z: coefficients, w: METRIC_*
  ivec4 items;    // x: metric's interval or coefficient count; y, z: first and count of SHADOW_ITEMS (ray
                  // march) or first deep texel; w: LIGHT_*
  ivec4 solids;   // x, y: first and count in SolidRecords of those that block this light; z: LIGHT_HAS_*,
                  // LIGHT_INSIDE ...; w: of a sun behind air 1 + its first texel there, else 0
  BlockRecord metric;
  BlockRecord coefficients;
  ivec4 weights;  // place of the weights' layers (STORE_BYTE), edge and faces as the metric's
  ivec4 horizon;  // place of (tau in all, x from the horizon to the last exit) (STORE_PAIR), edge and faces
                  // as the coefficients'
};

// One opaque solid, SOLID_ROWS texels of the scene table.
#define SOLID_ROWS 9
#define SOLID_PLANE 0
#define SOLID_BOX 1
struct SolidRecord {
  mat4 localFromWorld;
  mat4 worldFromLocal;
  vec4 albedo;  // rgb; w: SOLID_* as a number
};

#ifdef __cplusplus
}  // namespace pileus::gpu
#endif
