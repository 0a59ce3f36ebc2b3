// What the lattice of scattered light is gathered with and read by; read by C++ and GLSL.
#ifdef __cplusplus
#pragma once
#endif
#define BIND_SCATTER_CELLS 4
#define UNIT_SCATTER 14
#define SCATTER_LATTICES 5  // at most: one around all, and within it finer ones
#define PEAK_ANGLES 64      // of scene::scatteredPeaks
#define PEAK_DEPTHS 24
#define PEAK_DEPTH 3.0
#define SCATTER_SAMPLES 8   // of a cell: 2^3; also its faces, where it is solid or dense
