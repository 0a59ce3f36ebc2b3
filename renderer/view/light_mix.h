#pragma once
// Layers of a picture added up, each times a gain: light is linear, so a scene whose lights are brighter or
// of another colour is another sum of the same layers. GL thread.
#include <memory>
#include <span>

#include "renderer/gl/shader_library.h"
#include "renderer/view/picture.h"

namespace pileus::view {

struct MixPart {
  std::shared_ptr<const Picture> picture;
  vec3 gain{1.0f};
};

/// The sum, with the size, the scene, the samples and the alpha of `base`, but without its layers. `into`:
/// one that nobody looks at any more is written over; null, or of another size: a new one. Errors: Gpu;
/// Internal for a part of another size.
Result<std::shared_ptr<Picture>> mixLights(gl::ShaderLibrary& shaders, const Picture& base,
                                           std::span<const MixPart> parts,
                                           std::shared_ptr<Picture> into = {});

}  // namespace pileus::view
