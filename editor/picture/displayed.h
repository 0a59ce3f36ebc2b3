#pragma once
// Pictures through the display transform of the shown output: the colour configuration that is in use, and
// what was drawn with it. GL thread.
#include <array>
#include <memory>
#include <string>

#include "editor/picture/snapshots.h"
#include "renderer/base/hash.h"
#include "renderer/gl/gpu_timer.h"
#include "renderer/image/color.h"
#include "renderer/view/display.h"
#include "renderer/view/picture.h"

namespace pileus::editor {

class Messages;
struct Clock;
struct Session;
struct Shown;

struct Displayed {
  explicit Displayed(gl::ShaderLibrary& shaders) : display(shaders) {}

  view::Display display;
  std::shared_ptr<const image::ColorConfig> colors;
  std::string colorsOf = "\n";  ///< settings.ocio the config was loaded for
  Key colorsStamp;              ///< of its file then
  std::string colorError;

  /// A picture through the display transform, and what it was drawn from.
  struct Drawn {
    std::weak_ptr<const view::Picture> picture;  ///< what was drawn keeps neither texels nor scene
    double fraction = -1;
    int samples = -1;
    ivec2 size{0};
    view::DisplaySettings settings;
    unsigned texture = 0;
  };
  static constexpr std::size_t kStills = 4;  ///< first slot of those
  /// The picture, the truth it is compared with, the sides of a wipe between stills, and their thumbnails.
  std::array<Drawn, kStills + Snapshots::kMost> drawn;
  unsigned texture = 0;  ///< of the picture; 0 = none
  gl::GpuTimer timer;
  double ms = 0;  ///< of the display stage, as last known
};

/// As the shown output's parameters say.
view::DisplaySettings displaySettings(const Session& session, const Clock& clock, const Shown& shown);
/// Follows the document's colour configuration.
void updateColors(Messages& messages, const Session& session, Shown& shown);
/// `picture` through the shown output's display transform; redrawn only where something has changed. 0: it
/// cannot be. Slot 0 is the viewport's own.
unsigned displayTexture(Messages& messages, const Session& session, const Clock& clock, Shown& shown,
                        const std::shared_ptr<const view::Picture>& picture, ivec2 size, std::size_t slot);

}  // namespace pileus::editor
