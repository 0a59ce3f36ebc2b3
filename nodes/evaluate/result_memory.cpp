#include "nodes/evaluate/result_memory.h"

#include <algorithm>

#include "renderer/shadow/shadow_map.h"
#include "renderer/view/picture.h"
#include "renderer/view/render_scene.h"

namespace pileus::nodes {
namespace {

class Holdings {
 public:
  void add(const SocketValue& value) {
    if (const auto* v = std::get_if<VolumeValue>(&value)) add(v->items);
    if (const auto* v = std::get_if<LightValue>(&value)) add(v->items);
    if (const auto* v = std::get_if<MetricValue>(&value))
      for (const auto& metric : v->items) add(metric.get());
    if (const auto* v = std::get_if<ImageValue>(&value)) add(v->picture.get());
  }
  std::vector<Held> all() {
    std::sort(held_.begin(), held_.end());
    held_.erase(std::unique(held_.begin(), held_.end()), held_.end());
    return std::move(held_);
  }

 private:
  void put(const void* what, std::size_t bytes, bool map = false) {
    if (what) held_.push_back({what, bytes, map});
  }
  template <class Block>
  void block(const std::shared_ptr<const Block>& b) {
    if (b) put(b.get(), b->bytes(), true);
  }
  void add(const volume::InstanceList& volumes) {
    for (const volume::Instance& i : volumes)
      if (i.grid) put(i.grid.get(), std::size_t(i.grid->payloadCount) * volume::kStoredVoxels);
  }
  void add(const std::vector<LightWithShadow>& lights) {
    for (const LightWithShadow& l : lights) {
      if (!l.shadow) continue;
      block(l.shadow->block);
      block(l.shadow->horizon);
      block(l.shadow->deep);
      add(l.shadow->metric.get());
      add(l.shadow->volumes);
    }
  }
  void add(const shadow::PseudometricMap* metric) {
    if (!metric) return;
    block(metric->block);
    block(metric->weights);
    add(metric->volumes);
  }
  void add(const view::Picture* picture) {
    if (!picture) return;
    put(picture, picture->color.bytes());
    for (const auto& layer : picture->layers) add(layer.picture.get());
    if (!picture->scene) return;
    add(picture->scene->volumes);
    add(picture->scene->lights);
  }

  std::vector<Held> held_;
};

}  // namespace

std::vector<Held> heldBy(const std::vector<SocketValue>& values) {
  Holdings holdings;
  for (const SocketValue& value : values) holdings.add(value);
  return holdings.all();
}

}  // namespace pileus::nodes
