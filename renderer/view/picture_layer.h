#pragma once
// What a picture can hold beside or instead of the beauty, and what part of it is made. Plain values without
// OpenGL.
#include <string>

#include "renderer/base/math.h"

namespace pileus::view {

/// What the texels of a picture are.
struct PictureLayer {
  enum class Kind {
    Beauty,    ///< radiance of all lights, premultiplied, with alpha
    Depth,     ///< metres along the viewing axis to the mean point that scatters (three times), and how much
               ///< scatters; 0 where nothing does
    Light,     ///< radiance of one light alone, as the beauty
    Emission,  ///< radiance of what emits alone, behind what is in front of it; with those of all lights the
               ///< beauty
    Single,    ///< the beauty without what was scattered more than once
    Multiple,  ///< what the beauty has more (or less) than that; alpha as in all of them
  };
  Kind kind = Kind::Beauty;
  int light = 0;  ///< Light: its index in the scene
  bool operator==(const PictureLayer&) const = default;
  /// Is it made of all lights and of what emits?
  bool ofAll() const { return kind == Kind::Beauty || kind == Kind::Single || kind == Kind::Multiple; }
};

/// Layers made beside the beauty, for files and for mixing.
struct ExtraLayers {
  bool depth = false, lights = false;  ///< lights: and the emission, where something emits
  bool orders = false;                 ///< light that was scattered once, and more than once
  /// Lights: what is seen of each environment is a layer apart ("backdrop1" of light 1), not of the emission.
  bool backdrops = false;
  bool operator==(const ExtraLayers&) const = default;
};

/// A part of a picture, 0..1, y down; all of it by default.
struct PictureRegion {
  dvec2 min{0}, max{1};
  bool whole() const { return min == dvec2(0) && max == dvec2(1); }
  bool operator==(const PictureRegion&) const = default;
};

}  // namespace pileus::view
