// Binding points, read by C++ and GLSL.
#define BIND_VOLUMES 0
#define BIND_LEVELS 1
#define BIND_PAGES 2
#define BIND_LIGHTS 3
#define BIND_TILE_OFFSETS 4
#define BIND_TILE_ITEMS 5
#define BIND_SHADOW_ITEMS 6
#define BIND_TEST_IN 7
#define BIND_TEST_OUT 8

#define UNIT_ATLAS 0
#define UNIT_SHADOW_FLOAT 1
#define UNIT_SHADOW_HALF 2
#define UNIT_SHADOW_UNORM 3
#define UNIT_PICTURE 4
#define UNIT_LUT 5

#define IMAGE_TARGET 0
