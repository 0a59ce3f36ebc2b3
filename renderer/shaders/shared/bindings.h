// Binding points, read by C++ and GLSL.
// What shaders read at random goes through buffer textures: llvmpipe gathers texels in vectors but loads
// storage buffers lane by lane (measured: 5 to 10 times slower). Lights are a uniform block.
// A stage is guaranteed 16 texture units. Those that look at volumes use 0 to 3 and 5 to 10 at most
// (Shaders.MarchLeavesTextureUnits counts them); 11 to 15 are free.
#define BIND_LIGHTS 3
#define BIND_TEST_IN 7
#define BIND_TEST_OUT 8

#define UNIT_ATLAS 0
#define UNIT_SHADOW_FLOAT 1
#define UNIT_SHADOW_HALF 2
#define UNIT_SHADOW_UNORM 3
#define UNIT_PICTURE 4
#define UNIT_LUT 5  // and those behind it: passes that look at volumes bind no LUTs
#define UNIT_SHADOW_BYTE 5
#define UNIT_SHADOW_PAIR 6
#define UNIT_SHADOW_DEEP 7
#define UNIT_SHADOW_HALF_BITS 8
#define UNIT_SCENE 9  // records and lists: residency/scene_table.h
#define UNIT_PAGES 10
#define UNIT_MIX 5  // and those behind it: layers that are added up, no volumes beside
#define MIX_PARTS 8  // of them at a time

#define IMAGE_TARGET 0
