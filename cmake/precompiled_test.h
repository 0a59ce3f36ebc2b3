// The same for tests (CompileOptions.cmake).
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cmake/precompiled.h"
