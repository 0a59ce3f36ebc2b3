// The map that a pass fills with coefficients: floats or halves, by the variant constant STORE.
#pragma once
#include "shared/bindings.h"
#include "shared/records.h"
#if STORE == STORE_FLOAT
layout(rgba32f, binding = IMAGE_TARGET) writeonly uniform image2DArray target;
#else
layout(rgba16f, binding = IMAGE_TARGET) writeonly uniform image2DArray target;
#endif
