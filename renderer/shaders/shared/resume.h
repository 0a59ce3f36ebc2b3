// What marches keep between dispatches where one cannot run them to the end; read by C++ and GLSL.
#ifdef __cplusplus
#pragma once
#endif
#define BIND_MARCH_STATES 5
// Of one pixel of the region, with REACHED lights; in front of them 16 bytes that begin with the number of
// unfinished pixels.
#define MARCH_STATE_BYTES(reached) ((84 + 4 * (reached) + 15) / 16 * 16)
// Samples of a shadow march per loop iteration (measured: 8 make short marches slower).
#define MARCH_UNROLL 4
#define MARCH_MOST_STEPS 16384   // of one volume's shadow march
#define STRETCH_MOST_STEPS 8192  // of one stretch of a ray
