#pragma once
// The viewport's compare mode: the picture with the graph's shadows against the same picture with marched
// ones, or against unbiased paths. The truth is first made as a draft of few pixels, of drafts of the picture
// too, then small, then at the picture's own size, while nothing else is to be done. GL thread.
#include <array>
#include <memory>
#include <string>

#include "renderer/base/enum_info.h"
#include "renderer/truth/compare.h"

namespace pileus::editor {

class Messages;
struct Shown;

/// How the two sides are laid out.
enum class CompareLayout { Wipe, SideBySide, Error };
constexpr auto enumInfo(CompareLayout*) {
  using L = CompareLayout;
  return std::array{
      EnumItem<L>{L::Wipe, "wipe", "Wipe",
                  "The picture left of a line, the truth right of it. Drag the line."},
      EnumItem<L>{L::SideBySide, "side_by_side", "Side by side", "The picture left, the truth right."},
      EnumItem<L>{L::Error, "error", "Error", "Where it is too dark (blue) and where light leaks (red)."}};
}

/// What is compared.
enum class CompareOf { Radiance, Shadow };
constexpr auto enumInfo(CompareOf*) {
  using C = CompareOf;
  return std::array{
      EnumItem<C>{C::Radiance, "radiance", "Radiance", "The light that reaches the camera."},
      EnumItem<C>{C::Shadow, "shadow", "Shadow",
                  "Transmittance T between light and medium, averaged over what a pixel sees."}};
}

struct CompareMode {
  bool on = false;
  CompareLayout layout = CompareLayout::Wipe;
  CompareOf of = CompareOf::Radiance;
  truth::TruthKind against = truth::TruthKind::Marched;  ///< of radiance
  bool worst = false;  ///< Error of Shadow: the largest along a ray, not the mean
  double wipe = 0.5;   ///< of the picture's width
  bool draggingWipe = false;
  double shadowScale = 0.1;    ///< |dT| at the ends of the colours
  double radianceScale = 0.1;  ///< the same for radiance; follows the picture while `autoScale`
  bool autoScale = true;

  std::shared_ptr<const view::RenderScene> scene;  ///< what the passes below compare; null: only a draft yet
  truth::TruthKind kind = truth::TruthKind::Marched;  ///< of their truths
  std::unique_ptr<truth::ComparePass> coarse, fine;
  std::shared_ptr<const view::RenderScene> draftScene;  ///< of the draft, perhaps with the maps of drafts
  std::unique_ptr<truth::ComparePass> draft;
  double draftMs = 0;                    ///< spent on the draft
  double workedMs = 0, workedUnits = 0;  ///< spent on them, and what was done in it: for the time left
  std::string error;

  truth::CompareDisplay display;

  /// What there is to show: the fine pass once it has a whole picture of what is asked for, else the coarse
  /// one, else the draft if its maps are the picture's own; null while none has.
  const truth::ComparePass* shown() const;
  /// Whose truth there is to show: it does not depend on maps.
  const truth::ComparePass* shownTruth() const;
  /// The scene of a pass with every figure, else the best there is; null before the first.
  const truth::ComparePass* measured() const;
};

/// Follows the picture: starts over when it shows something else, drops everything where there is nothing to
/// compare or the mode is off. Call once a frame.
void followPicture(Shown& shown);
/// Is there work that can be done now?
bool compareWantsFrame(const Shown& shown);
/// Is the work that can be done now the draft of the truth, behind the draft of the picture? One waits for
/// it: the refinement rests until it is there, for a second or two at most.
bool compareGoesFirst(const Shown& shown);
/// About `ms` milliseconds of it.
void stepCompare(Messages& messages, Shown& shown, double ms);
/// 0..1 of the final comparison.
double compareFraction(const CompareMode& mode);
/// Seconds that are left of it, by what was done so far; -1: not known yet.
double compareSecondsLeft(const CompareMode& mode);

void toggleCompare(Messages& messages, Shown& shown);
/// Into that layout, and out of compare mode from there.
void toggleWipe(Messages& messages, Shown& shown);
void toggleError(Messages& messages, Shown& shown);

}  // namespace pileus::editor
