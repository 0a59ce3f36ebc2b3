#include "editor/picture/displayed.h"

#include <fmt/core.h>

#include "editor/document/session.h"
#include "editor/exchange/messages.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/time/clock.h"
#include "renderer/base/file.h"

namespace pileus::editor {
namespace {

std::string textParam(const nodes::Node& node, const nodes::NodeType& type, const char* id, double frame) {
  const nodes::ParamSpec* spec = type.param(id);
  if (!spec) return {};
  const nodes::ParamValue value = nodes::paramValue(node, *spec, frame);
  const std::string* text = std::get_if<std::string>(&value);
  return text ? *text : std::string();
}

}  // namespace

void updateColors(Messages& messages, const Session& session, Shown& shown) {
  Displayed& displayed = shown.displayed;
  const std::string& wanted = session.document.graph().settings.ocio;
  const std::filesystem::path path =
      nodes::colorConfigPath(session.document.graph().settings, session.document.path().parent_path());
  const Key stamp = wanted.empty() ? Key{} : fileStamp(path);
  if (displayed.colorsOf == wanted && displayed.colorsStamp == stamp) return;
  displayed.colorsOf = wanted;
  displayed.colorsStamp = stamp;
  displayed.colorError.clear();
  for (Displayed::Drawn& drawn : displayed.drawn) drawn.picture.reset();
  Result<std::shared_ptr<const image::ColorConfig>> config = image::ColorConfig::load(path.string());
  if (!config) {
    displayed.colorError = config.error().message;
    config = wanted.empty() ? image::ColorConfig::shipped() : image::ColorConfig::load("");
    if (!config) config = image::ColorConfig::shipped();
    messages.error(
        config ? fmt::format("{}; shown with {} instead", displayed.colorError, (*config)->description())
               : displayed.colorError);
  }
  displayed.colors = config ? *config : nullptr;
}

unsigned displayTexture(Messages& messages, const Session& session, const Clock& clock, Shown& shown,
                        const std::shared_ptr<const view::Picture>& picture, ivec2 size, std::size_t slot) {
  Displayed& displayed = shown.displayed;
  Displayed::Drawn& drawn = displayed.drawn.at(slot);
  if (!picture || !displayed.colors) {
    drawn.picture.reset();
    return 0;
  }
  view::DisplaySettings settings = displaySettings(session, clock, shown);
  if (picture->layer.kind == view::PictureLayer::Kind::Depth) {
    const view::ScanResult* scan = shown.mode.scan.result();
    settings.range = scan && scan->depth.y > scan->depth.x ? scan->depth : vec2(0, 1);
  }
  if (drawn.picture.lock() == picture && drawn.fraction == picture->fraction &&
      drawn.samples == picture->samples && drawn.size == size && drawn.settings == settings && drawn.texture)
    return drawn.texture;
  const auto draw = [&](const view::DisplaySettings& s) {
    if (slot == 0) displayed.timer.begin();
    const Result<unsigned> result = displayed.display.draw(picture->color, picture->size, size,
                                                           *displayed.colors, s, static_cast<int>(slot));
    if (slot == 0) displayed.timer.end();
    return result;
  };
  Result<unsigned> texture = draw(settings);
  if (!texture && displayed.colorError != texture.error().message) {
    // A display, view or look this configuration does not have: say so, and show its default.
    displayed.colorError = texture.error().message;
    const std::string display = displayed.colors->defaultDisplay();
    messages.warn(fmt::format("{}; shown as {}, {} instead", displayed.colorError, display,
                              displayed.colors->defaultView(display)));
  }
  if (!texture) {
    view::DisplaySettings plain = settings;
    plain.display.clear(), plain.view.clear(), plain.look.clear();
    texture = draw(plain);
  } else if (slot == 0) {
    displayed.colorError.clear();
  }
  drawn = {picture, picture->fraction, picture->samples, size, settings, texture ? *texture : 0};
  return drawn.texture;
}

view::DisplaySettings displaySettings(const Session& session, const Clock& clock, const Shown& shown) {
  const nodes::Node* node = nodes::findNode(session.document.root(), displayNode(session, shown));
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  const DisplayMode& mode = shown.mode;
  view::DisplaySettings settings;
  settings.raw = mode.raw;
  settings.channel = mode.channel;
  settings.falseColor = mode.falseColor;
  settings.zebra = mode.zebra;
  if (!type) return settings;
  settings.display = textParam(*node, *type, "display", clock.frame);
  settings.view = textParam(*node, *type, "view", clock.frame);
  settings.look = textParam(*node, *type, "look", clock.frame);
  const auto number = [&](const char* id, double& out) {
    const nodes::ParamSpec* spec = type->param(id);
    if (!spec) return;
    const nodes::ParamValue value = nodes::paramValue(*node, *spec, clock.frame);
    if (const double* v = std::get_if<double>(&value)) out = *v;
  };
  number("exposure", settings.exposure);
  number("gamma", settings.gamma);
  return settings;
}

}  // namespace pileus::editor
