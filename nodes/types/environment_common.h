#pragma once
// What the nodes share that give light from everywhere.
#include "nodes/declare/value.h"
#include "renderer/scene/environment_strata.h"

namespace pileus::nodes {

/// A few suns that stand for an environment where light has to come from somewhere, each with a shadow of its
/// own: one for each of 16 parts of equal energy. Those who can do better find the environment itself in each
/// of them.
std::vector<LightWithShadow> standIns(const std::shared_ptr<const scene::Environment>& environment,
                                      const scene::EnvironmentStrata& strata);

}  // namespace pileus::nodes
