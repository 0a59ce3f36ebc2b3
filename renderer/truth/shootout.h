#pragma once
// Every shadow representation on the lights of one scene: at its defaults, and at equal memory. In steps; GL
// thread.
#include <optional>

#include "renderer/image/image.h"
#include "renderer/truth/shadow_measure.h"
#include "renderer/truth/truth_picture.h"

namespace pileus::truth {

enum class ShootoutGroup { Truth, Defaults, EqualMemory };
constexpr auto enumInfo(ShootoutGroup*) {
  using G = ShootoutGroup;
  return std::array{
      EnumItem<G>{G::Truth, "truth", "Truth",
                  "What all pictures are compared with: a converged ray march, or the judge."},
      EnumItem<G>{
          G::Defaults, "defaults", "Defaults",
          "Each representation with its usual parameters, in half floats, all at the same resolution."},
      EnumItem<G>{
          G::EqualMemory, "equal memory", "Equal memory",
          "Resolutions chosen so that every map takes the bytes of the improved map in its 32-byte layout."}};
}

struct Contender {
  std::string name;
  shadow::ShadowSpec spec;  ///< resolution: left to the shoot-out
};
/// All but the truth, in the order of tables.
std::vector<Contender> shootoutContenders();

struct ShootoutOptions {
  int resolution = 512;                  ///< texels along an edge; of the 32-byte map where memory is equal
  ivec2 size{320, 180};                  ///< of the pictures
  int samples = 4;                       ///< a pixel
  SampleOptions points;                  ///< a light
  TruthKind truth = TruthKind::Marched;  ///< of the pictures; shadows are always measured against a march
};

struct ShootoutEntry {
  ShootoutGroup group = ShootoutGroup::Defaults;
  std::string name;
  std::vector<ShadowMeasure> lights;  ///< in the scene's order
  image::Image picture;               ///< all lights with this representation
  double relMse = 0;                  ///< of the picture against the truth's; the judge's: scaled

  const ShadowMeasure& worst() const;  ///< of the light with the largest mean error
  double buildMs() const;              ///< of all lights
  std::size_t bytes() const;
};

class Shootout {
 public:
  Shootout(view::RenderScene scene, const ShootoutOptions& options);
  ~Shootout();
  /// Works for about `ms` milliseconds (see MeasurePass); the fraction done, 1 = finished. Error (Input): no
  /// lights, no media, or a light whose rays meet none, named by its number. To stop: destroy it.
  Result<double> step(const shadow::Gpu& gpu, double ms);
  /// Finished ones; the truth is the first.
  const std::vector<ShootoutEntry>& entries() const;
  const view::RenderScene& scene() const;
  const ShootoutOptions& options() const;
  int pointCount() const;     ///< over all lights
  std::string doing() const;  ///< "Paper, cosine 4 + 8 at equal memory"

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// One line per entry and light under a line of column names.
std::string shootoutCsv(const std::vector<ShootoutEntry>& entries);

}  // namespace pileus::truth
