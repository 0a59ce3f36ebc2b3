// The same for tests (CompileOptions.cmake).
#include <gtest/gtest.h>

#include "cmake/precompiled.h"
