#pragma once
// Every shadow representation on the picture's own lights: a table that sorts, with pictures.
#include <memory>
#include <string>
#include <vector>

#include "renderer/base/enum_info.h"
#include "renderer/gl/texture.h"
#include "renderer/truth/shootout.h"

namespace pileus::editor {

struct Lab;
struct LabRoom;
struct Shown;
struct Ui;

enum class ShootoutShow { Defaults, EqualMemory };
constexpr auto enumInfo(ShootoutShow*) {
  using S = ShootoutShow;
  return std::array{EnumItem<S>{S::Defaults, "defaults", "Defaults",
                                "Each with its usual parameters, all at one resolution"},
                    EnumItem<S>{S::EqualMemory, "equal", "Equal memory",
                                "Resolutions chosen so that every map takes the same bytes"}};
}

struct ShootoutPanel {
  std::unique_ptr<truth::Shootout> run;
  bool running = false;
  double fraction = 0;
  std::string error;
  std::shared_ptr<const view::RenderScene> scene;  ///< what was measured
  ShootoutShow show = ShootoutShow::Defaults;
  truth::TruthKind truth = truth::TruthKind::Marched;  ///< of the next run's pictures
  int column = 1;                                      ///< the table is sorted by
  bool descending = false;

  /// The pictures of an entry on the GPU: as rendered, and its error in false colours.
  struct Pictures {
    gl::Texture picture, error;
  };
  std::vector<Pictures> pictures;  ///< by entry
};

void startShootout(const Shown& shown, Lab& lab);
void stopShootout(Lab& lab);
void stepShootout(Ui& ui, const Shown& shown, Lab& lab, double ms);
/// Controls from the cursor on, up to `right`; the table in the rectangle.
void drawShootout(const LabRoom& room, float right, vec2 lo, vec2 hi);

}  // namespace pileus::editor
