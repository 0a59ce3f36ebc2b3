#include "editor/graph_view/thumbnails.h"

#include <imgui.h>

#include <algorithm>

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/graph_room.h"
#include "editor/graph_view/node_status.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/time/clock.h"
#include "editor/toolkit/ui.h"
#include "nodes/declare/value.h"
#include "renderer/shadow/shadow_map.h"
#include "renderer/view/environment_thumbnail.h"
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

/// What of the display's settings a picture shows.
std::string displayText(const view::DisplaySettings& s) {
  return fmt::format("{}|{}|{}|{}|{}|{}", s.display, s.view, s.look, s.exposure, s.gamma, s.raw);
}

std::shared_ptr<const view::Picture> pictureOf(const nodes::SocketValue* value) {
  const auto* image = value ? std::get_if<nodes::ImageValue>(value) : nullptr;
  return image ? image->picture : nullptr;
}

}  // namespace

bool Thumbnails::passing(const Clock& clock, const Shown& shown, const Entry& e) const {
  const bool moving = clock.play.playing() || shown.preview.interacting();
  return moving && e.picture.texture && e.frame != clock.frame && ImGui::GetTime() - e.madeAt < kEvery;
}

void Thumbnails::made(const Shown& shown, Entry& e) {
  e.madeAt = ImGui::GetTime();
  e.frame = shown.preview.frame();
}

void Thumbnails::prune(const nodes::Graph& graph) {
  std::erase_if(entries_, [&](const auto& entry) {
    if (graph.nodes.contains(entry.first)) return false;
    if (entry.second.slot) freeSlots_.push_back(entry.second.slot);
    return true;
  });
}

void Thumbnails::draw(const Session& session, const Clock& clock, Shown& shown, const gl::Texture& texels,
                      ivec2 size, Entry& e) {
  const view::DisplaySettings settings = displaySettings(session, clock, shown);
  if (e.slot == 0 && !freeSlots_.empty()) {
    e.slot = freeSlots_.back();
    freeSlots_.pop_back();
  }
  if (e.slot == 0) e.slot = kFirstSlot + slots_++;
  view::DisplaySettings plain;
  plain.display = settings.display, plain.view = settings.view, plain.look = settings.look;
  plain.exposure = settings.exposure, plain.gamma = settings.gamma, plain.raw = settings.raw;
  const ivec2 small = fitted(size);
  const Result<unsigned> texture =
      shown.displayed.display.draw(texels, size, small, *shown.displayed.colors, plain, e.slot);
  e.picture = {texture ? *texture : 0u, small, 0};
}

int Thumbnails::frameOf(const std::string& name) const {
  const auto it = entries_.find(name);
  return it == entries_.end() || !it->second.picture.texture ? 0 : it->second.frame;
}

NodePicture Thumbnails::image(const Session& session, const Clock& clock, Shown& shown,
                              const std::string& name) {
  const std::shared_ptr<const view::Picture> picture =
      pictureOf(shownImage(shown.preview.evaluator(), session.document.root(), evaluatedName(session, name)));
  Entry& e = entries_[name];
  if (!picture || picture->size.x <= 0 || !shown.displayed.colors || passing(clock, shown, e))
    return e.picture;
  const std::string display = displayText(displaySettings(session, clock, shown));
  const bool same = e.source.lock() == picture && e.fraction == picture->fraction && e.display == display;
  if (same || (e.picture.texture && picture->fraction < 1 && ImGui::GetTime() - e.madeAt < kEvery))
    return e.picture;
  draw(session, clock, shown, picture->color, picture->size, e);
  e.source = picture;
  e.fraction = picture->fraction;
  e.display = display;
  made(shown, e);
  return e.picture;
}

NodePicture Thumbnails::environment(const Session& session, const Clock& clock, Shown& shown,
                                    const std::string& name) {
  Entry& e = entries_[name];
  const nodes::SocketValue* value = shown.preview.evaluator().output(evaluatedName(session, name), "light");
  const auto* lights = value ? std::get_if<nodes::LightValue>(value) : nullptr;
  if (!lights || !shown.displayed.colors || passing(clock, shown, e)) return e.picture;
  std::shared_ptr<const scene::Environment> light;
  std::vector<scene::Light> suns;
  for (const nodes::LightWithShadow& item : lights->items)
    if (item.light.environment)
      light = item.light.environment;
    else
      suns.push_back(item.light);
  const std::string display = displayText(displaySettings(session, clock, shown));
  if (!light || (e.source.lock() == light && e.display == display)) return e.picture;
  const ivec2 size(kEdge, kEdge / 2);
  const Result<gl::Texture> texels = view::environmentThumbnail(*light, suns, size);
  if (!texels) return e.picture;
  draw(session, clock, shown, *texels, ivec2(texels->size()), e);
  e.source = light;
  e.display = display;
  made(shown, e);
  return e.picture;
}

NodePicture Thumbnails::map(const Session& session, const Clock& clock, const Shown& shown,
                            const std::string& name, const nodes::NodeType& type) {
  Entry& e = entries_[name];
  std::shared_ptr<const shadow::PseudometricMap> metric;
  std::shared_ptr<const shadow::ShadowMap> shadow;
  for (const nodes::SocketSpec& s : type.outputs) {
    const nodes::SocketValue* value = shown.preview.evaluator().output(evaluatedName(session, name), s.id);
    if (!value) continue;
    if (const auto* m = std::get_if<nodes::MetricValue>(value); m && !m->items.empty())
      metric = m->items.front();
    if (const auto* l = std::get_if<nodes::LightValue>(value))
      for (const auto& item : l->items)
        if (item.shadow && !shadow && item.light.kind != scene::LightKind::Environment) shadow = item.shadow;
  }
  const std::shared_ptr<const void> source =
      shadow ? std::shared_ptr<const void>(shadow) : std::shared_ptr<const void>(metric);
  if (!source || source == e.source.lock() || passing(clock, shown, e)) return e.picture;
  const shadow::Gpu gpu = shown.renderer.gpu();
  const Result<int> tiles = shadow ? view::drawMapThumbnail(gpu, *shadow, kTile, e.texture)
                                   : view::drawMapThumbnail(gpu, *metric, kTile, e.texture);
  e.source = source;
  made(shown, e);
  e.picture = {};
  if (tiles && *tiles > 0) e.picture = {e.texture.id(), ivec2(kTile), *tiles};
  return e.picture;
}

NodePicture nodePicture(const GraphRoom& room, const NodePlace& place) {
  Thumbnails& all = room.canvas.pictures;
  const NodePicture picture = place.thumbnail == Thumbnail::Map
                                  ? all.map(room.session, room.clock, room.shown, place.name, *place.type)
                              : place.thumbnail == Thumbnail::Environment
                                  ? all.environment(room.session, room.clock, room.shown, place.name)
                                  : all.image(room.session, room.clock, room.shown, place.name);
  if (room.ui.trace.on())
    room.ui.trace.note("thumbnail " + place.name, std::to_string(all.frameOf(place.name)));
  return picture;
}

void toggleThumbnails(Ui& ui, const Session& session, const Settings& settings, Canvas& canvas) {
  ThumbnailChoice& choice = canvas.thumbnails;
  choice.all = settings.showThumbnails;
  std::vector<std::string> able;
  for (const std::string& name : session.document.selection()) {
    const nodes::Node* node = nodes::findNode(shownGraph(session, canvas), name);
    const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
    if (type && thumbnailKind(*type) != Thumbnail::None) able.push_back(name);
  }
  if (able.empty())
    return ui.messages.hint("Select nodes that make a picture, a sky or a shadow map to show it on them.");
  const bool on =
      std::all_of(able.begin(), able.end(), [&](const std::string& n) { return choice.shows(n); });
  for (const std::string& name : able)
    if (choice.shows(name) == on && !choice.exceptions.erase(name)) choice.exceptions.insert(name);
}

}  // namespace pileus::editor
