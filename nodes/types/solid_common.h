#pragma once
// What the solid nodes share: a place, a size and a colour.
#include "nodes/declare/describe.h"

namespace pileus::nodes {

struct SolidIn {
  dvec3 center{0};
  dvec3 size{1};
  dvec3 rotate{0};
  Color albedo{vec3(0.5f)};
};

struct SolidOut {
  SolidValue solid;
};

/// `largest`: the size where dragging stops.
inline void describePlaced(Describe<SolidIn, SolidOut>& d, double largest, std::string sizes) {
  d.in("center", &SolidIn::center).unit("m").range(-1e6, 1e6).soft(-10, 10).help("Where its middle is.");
  d.in("size", &SolidIn::size).unit("m").range(1e-6, 1e6).soft(0.01, largest).help(std::move(sizes));
  d.in("rotate", &SolidIn::rotate)
      .unit("deg")
      .range(-36000, 36000)
      .soft(-180, 180)
      .help("Turns about X, then Y, then Z.");
  d.in("albedo", &SolidIn::albedo)
      .range(0, 1)
      .help("The part of the light it reflects, evenly (Lambert); linear, in the working space.");
  d.out("solid", &SolidOut::solid).help("One solid.");
}

inline SolidOut placed(scene::SolidShape shape, const SolidIn& in, const dvec3& size) {
  return {{{{shape, composeTransform(in.center, in.rotate, size), in.albedo.rgb}}}};
}

}  // namespace pileus::nodes
