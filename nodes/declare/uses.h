#pragma once

namespace pileus::nodes {

/// Parts of an evaluation's context. Those that a node type declares enter its content key, and only those
/// may its evaluate() read.
enum Uses : unsigned {
  UsesNothing = 0,
  UsesFrame = 1,
  UsesSize = 2,
  UsesQuality = 4,
  UsesFreeCamera = 8,
  UsesLayers = 16,
  UsesRate = 32,
  UsesColors = 64
};

}  // namespace pileus::nodes
