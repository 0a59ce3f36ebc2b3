#include "editor/graph_view/thumbnails.h"

#include <imgui.h>

#include <algorithm>

#include "editor/app/editor.h"
#include "editor/graph_view/node_status.h"
#include "editor/viewport/viewport_bar.h"
#include "nodes/declare/value.h"
#include "renderer/shadow/shadow_map.h"
#include "renderer/view/map_thumbnail.h"
#include "renderer/view/picture.h"

namespace pileus::editor {
namespace {

constexpr int kEdge = 160;        // pixels of an image's longer side
constexpr int kTile = 40;         // pixels of a map's tile
constexpr int kFirstSlot = 4096;  // of the display's textures
constexpr double kEvery = 1;      // seconds between two pictures while one still improves or frames go by

ivec2 fitted(ivec2 size) {
  const double scale = static_cast<double>(kEdge) / std::max({size.x, size.y, 1});
  return glm::max(ivec2(dvec2(size) * scale), ivec2(1));
}

std::shared_ptr<const view::Picture> pictureOf(const nodes::SocketValue* value) {
  const auto* image = value ? std::get_if<nodes::ImageValue>(value) : nullptr;
  return image ? image->picture : nullptr;
}

}  // namespace

bool Thumbnails::passing(const Editor& editor, const Entry& e) const {
  const bool moving = editor.timeline.clock.playing() || editor.preview.interacting();
  return moving && e.picture.texture && e.frame != editor.frame && ImGui::GetTime() - e.madeAt < kEvery;
}

void Thumbnails::made(const Editor& editor, Entry& e) {
  e.madeAt = ImGui::GetTime();
  e.frame = editor.preview.frame();
}

int Thumbnails::frameOf(const std::string& name) const {
  const auto it = entries_.find(name);
  return it == entries_.end() || !it->second.picture.texture ? 0 : it->second.frame;
}

NodePicture Thumbnails::image(Editor& editor, const std::string& name) {
  const std::shared_ptr<const view::Picture> picture =
      pictureOf(shownImage(editor.preview.evaluator(), editor.document.root(), evaluatedName(editor, name)));
  Entry& e = entries_[name];
  if (!picture || picture->size.x <= 0 || !editor.viewport.colors || passing(editor, e)) return e.picture;
  const view::DisplaySettings settings = displaySettings(editor);
  const std::string display = fmt::format("{}|{}|{}|{}|{}|{}", settings.display, settings.view, settings.look,
                                          settings.exposure, settings.gamma, settings.raw);
  const bool same = e.source == picture && e.fraction == picture->fraction && e.display == display;
  if (same || (e.picture.texture && picture->fraction < 1 && ImGui::GetTime() - e.madeAt < kEvery))
    return e.picture;
  if (e.slot == 0) e.slot = kFirstSlot + slots_++;
  view::DisplaySettings plain;
  plain.display = settings.display, plain.view = settings.view, plain.look = settings.look;
  plain.exposure = settings.exposure, plain.gamma = settings.gamma, plain.raw = settings.raw;
  const ivec2 size = fitted(picture->size);
  const Result<unsigned> texture = editor.viewport.display.draw(picture->color, picture->size, size,
                                                                *editor.viewport.colors, plain, e.slot);
  e.source = picture;
  e.fraction = picture->fraction;
  e.display = display;
  e.picture = {texture ? *texture : 0u, size, 0};
  made(editor, e);
  return e.picture;
}

NodePicture Thumbnails::map(Editor& editor, const std::string& name, const nodes::NodeType& type) {
  Entry& e = entries_[name];
  std::shared_ptr<const shadow::PseudometricMap> metric;
  std::shared_ptr<const shadow::ShadowMap> shadow;
  for (const nodes::SocketSpec& s : type.outputs) {
    const nodes::SocketValue* value = editor.preview.evaluator().output(evaluatedName(editor, name), s.id);
    if (!value) continue;
    if (const auto* m = std::get_if<nodes::MetricValue>(value); m && !m->items.empty())
      metric = m->items.front();
    if (const auto* l = std::get_if<nodes::LightValue>(value))
      for (const auto& item : l->items)
        if (item.shadow && !shadow) shadow = item.shadow;
  }
  const std::shared_ptr<const void> source =
      shadow ? std::shared_ptr<const void>(shadow) : std::shared_ptr<const void>(metric);
  if (!source || source == e.source || passing(editor, e)) return e.picture;
  const shadow::Gpu gpu = editor.renderer->gpu();
  const Result<int> tiles = shadow ? view::drawMapThumbnail(gpu, *shadow, kTile, e.texture)
                                   : view::drawMapThumbnail(gpu, *metric, kTile, e.texture);
  e.source = source;
  made(editor, e);
  e.picture = {};
  if (tiles && *tiles > 0) e.picture = {e.texture.id(), ivec2(kTile), *tiles};
  return e.picture;
}

NodePicture nodePicture(Editor& editor, const NodePlace& place) {
  Thumbnails& all = editor.canvas.pictures;
  const NodePicture picture = place.thumbnail == Thumbnail::Map ? all.map(editor, place.name, *place.type)
                                                                : all.image(editor, place.name);
  if (editor.trace.on())
    editor.trace.note("thumbnail " + place.name, std::to_string(all.frameOf(place.name)));
  return picture;
}

void toggleThumbnails(Editor& editor) {
  ThumbnailChoice& choice = editor.canvas.thumbnails;
  choice.all = editor.settings.showThumbnails;
  std::vector<std::string> able;
  for (const std::string& name : editor.document.selection()) {
    const nodes::Node* node = nodes::findNode(shownGraph(editor), name);
    const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
    if (type && thumbnailKind(*type) != Thumbnail::None) able.push_back(name);
  }
  if (able.empty())
    return editor.messages.hint("Select nodes that make a picture or a shadow map to show it on them.");
  const bool on =
      std::all_of(able.begin(), able.end(), [&](const std::string& n) { return choice.shows(n); });
  for (const std::string& name : able)
    if (choice.shows(name) == on && !choice.exceptions.erase(name)) choice.exceptions.insert(name);
}

}  // namespace pileus::editor
