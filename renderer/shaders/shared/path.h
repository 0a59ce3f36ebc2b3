// What the path tracer's shader and its pass share; read by C++ and GLSL.
#ifdef __cplusplus
#pragma once
#endif
#define BIND_PATH_STATES 6
#define UNIT_MAJORANTS 11    // residency/majorants.h
#define UNIT_ENVIRONMENT 12  // view/environment_table.h
#define UNIT_BACKDROP 13     // what is seen of it
#define IMAGE_MEAN 0         // of all samples
#define IMAGE_DEVIATIONS 1   // rgb: sums of squared deviations from it
#define IMAGE_ODD 2          // mean of every other sample
#define PATH_STATE_BYTES 160
#define PATH_NOISE_PIXELS 64  // whose sums come back as one

#define TRANSMITTANCE_RATIO 0   // of shadow rays: ratio tracking
#define TRANSMITTANCE_SERIES 1  // a power series around what the light's map says

#define MOST_BOUNCES 1000000  // of a path without a limit: those that are ended there are counted
