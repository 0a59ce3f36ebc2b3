#pragma once
// What an evaluation is asked for, beside the graph.
#include <filesystem>
#include <memory>
#include <optional>

#include "renderer/base/hash.h"
#include "renderer/base/math.h"
#include "renderer/scene/camera.h"
#include "renderer/view/picture_layer.h"

namespace pileus::view {
struct Picture;
}

namespace pileus::nodes {

enum class Quality {
  Draft,  ///< while something is dragged: small pictures, small maps, one sample
  Final,  ///< as the parameters say
};

struct EvalSettings {
  int frame = 1;
  ivec2 size{1280, 720};  ///< full picture size; a draft divides it itself
  Quality quality = Quality::Final;
  std::optional<scene::Camera>
      freeCamera;  ///< the viewport's camera; absent: pictures without a camera frame the volumes
  std::filesystem::path folder;  ///< relative file parameters start here
  int draftPixels = 0;           ///< of a draft's picture; 0: as the device allows
  int draftTexels = 0;           ///< along the edge of a draft's shadow map; 0: as the device allows
  view::PictureLayer layer;      ///< what pictures hold
  view::ExtraLayers extra;       ///< and what is made beside it
  view::PictureRegion region;    ///< the part of a picture that is made
  std::shared_ptr<const view::Picture> seed;  ///< what parts still to come show; no part of any key
  Key around;        ///< of the seed, where a region is made: it stays around the finished picture
  double fps = 24;   ///< the document's; the evaluator sets it
  std::string ocio;  ///< likewise: its colour configuration, as image::ColorConfig::load() takes it
  double budgetMs =
      30;  ///< of GL-thread time for one evaluate() of the whole graph; infinity: run to the end
};

}  // namespace pileus::nodes
