// Binding points, read by C++ and GLSL.
// What shaders read at random goes through buffer textures: llvmpipe gathers texels in vectors but loads
// storage buffers lane by lane (measured: 5 to 10 times slower). Lights are a uniform block.
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
#define UNIT_VOLUMES 8
#define UNIT_LEVELS 9
#define UNIT_PAGES 10
#define UNIT_TILE_OFFSETS 11
#define UNIT_TILE_ITEMS 12
#define UNIT_SHADOW_ITEMS 13
#define UNIT_SOLIDS 14
#define UNIT_SHADOW_HALF_BITS 15

#define IMAGE_TARGET 0
