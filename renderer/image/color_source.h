#pragma once
// How ACEScg pixels enter a colour config, and whether the library can read the config at all. Internal to
// renderer/image.
#include <OpenColorIO/OpenColorIO.h>

#include <string>

#include "renderer/base/result.h"

namespace pileus::image {

struct ColorSource {
  std::string space;          ///< of the config
  bool fromAces2065 = false;  ///< `space` is ACES2065-1: a built-in ACEScg -> ACES2065-1 goes first
  std::string note;           ///< for the description where colours are not exact
};

/// In this order: the role scene_linear if it is ACEScg; any space named or aliased ACEScg; ACES2065-1
/// through the role aces_interchange; scene_linear as it is, with a note.
ColorSource chooseColorSource(const OCIO_NAMESPACE::Config& config);

/// Error (Input) for text that is no config, or one of a newer profile: OpenColorIO's own refusal speaks of
/// its versions only.
Result<void> checkProfile(const std::string& name, const std::string& text);

}  // namespace pileus::image
