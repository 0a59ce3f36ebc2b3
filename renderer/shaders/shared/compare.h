// Constants of the comparison passes, read by C++ and GLSL.
#ifdef __cplusplus
#pragma once
#endif
#define BIND_ERROR_BINS 4
#define IMAGE_ERROR 0
#define IMAGE_TRANSMITTANCE 1
#define UNIT_COMPARED 4  // the texture that is shown, or what the truth is subtracted from
#define UNIT_TRUTH 5
#define UNIT_COLOURS 6

// Histogram of |dT|: bin 0 holds what is below ERROR_LEAST, the others share the decades up to 1 evenly.
#define ERROR_BINS 1024
#define ERROR_LEAST 1e-6
#define ERROR_DECADES 6.0

// What truth/compare.comp.glsl shows.
#define SHOW_RADIANCE_ERROR 0  // luminance of compared - truth
#define SHOW_SHADOW_ERROR 1    // mean dT seen by a pixel
#define SHOW_WORST_ERROR 2     // the largest dT on a pixel's ray
#define SHOW_MAPPED_TRANSMITTANCE 3
#define SHOW_TRUE_TRANSMITTANCE 4
