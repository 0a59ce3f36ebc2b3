#pragma once
// Whether the driver had memory for what it was just asked to store. GL thread.
#include <string>
#include <string_view>

#include "renderer/base/result.h"

namespace pileus::gl {

/// "21.4 MiB" for what is needed, rounded up, and for what there is, rounded down: a message that refuses one
/// for the other never shows two equal numbers.
std::string neededMib(std::size_t bytes);
std::string givenMib(std::size_t bytes);

/// Errors of calls before; before storage is asked for.
void forgetErrors();
/// Behind it. Error (Gpu) with the label and the bytes, where they were not to be had.
Result<void> checkStorage(std::string_view label, std::size_t bytes);

}  // namespace pileus::gl
