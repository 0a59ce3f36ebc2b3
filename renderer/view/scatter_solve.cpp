#include "renderer/view/scatter_solve.h"

#include <algorithm>
#include <cmath>

namespace pileus::view {
namespace {

using Kind = PictureLayer::Kind;

void add(Hasher& h, const dvec3& v) { h.add(v.x).add(v.y).add(v.z); }

/// Of all that decides the solution.
Key keyOf(const RenderScene& scene, bool emission) {
  Hasher h;
  h.add(volume::contentKey(scene.volumes)).add(emission);
  h.add(scene.options.scatter.cells).add(scene.options.scatter.residual);
  for (const shadow::ShadowedLight& l : layerLights(scene)) {
    const scene::Light& light = l.light;
    h.add(light.kind);
    for (const dvec3& v : {light.towards, dvec3(light.emitted), light.position}) add(h, v);
    for (const double v : {light.radius, light.cone, light.softness, light.narrow}) h.add(v);
    // A shadow that is made anew is another one; its address may be that of one before, its number not.
    h.add(l.shadow ? l.shadow->number : 0);
    if (light.environment) {
      const scene::EnvironmentMap& map = *light.environment->map;
      h.add(map.size.x).bytes(map.radiance.data(), map.radiance.size() * sizeof(vec3));
      h.add(light.environment->rotation);
      add(h, dvec3(light.environment->scale));
    }
    if (light.air)
      h.add(light.air->altitude).bytes(light.air->passes.data(), light.air->passes.size() * sizeof(vec3));
  }
  for (const scene::Solid& s : scene.solids) {
    h.add(s.shape).bytes(&s.worldFromLocal, sizeof s.worldFromLocal);
    add(h, dvec3(s.albedo));
  }
  return h.key();
}

}  // namespace

std::shared_ptr<const ScatterField> ScatterCache::find(const Key& key) {
  const auto it = std::find_if(fields_.begin(), fields_.end(), [&](const auto& f) { return f.first == key; });
  if (it == fields_.end()) return nullptr;
  fields_.splice(fields_.begin(), fields_, it);
  return fields_.front().second;
}

void ScatterCache::keep(const Key& key, std::shared_ptr<const ScatterField> field) {
  ++solved_;
  fields_.emplace_front(key, std::move(field));
  if (fields_.size() > kMost) fields_.pop_back();
}

ScatterSolve::ScatterSolve(std::shared_ptr<const RenderScene> scene, std::shared_ptr<ScatterCache> cache,
                           std::shared_ptr<KeptSuns> kept)
    : scene_(std::move(scene)), cache_(std::move(cache)) {
  const bool emission = scene_->options.layer.kind != Kind::Light && emits(*scene_);
  key_ = keyOf(*scene_, emission);
  if (cache_) field_ = cache_->find(key_);
  if (field_) return;
  gather_ = std::make_unique<ScatterGather>(scene_, scatterLattice(scene_->volumes, scene_->options.scatter),
                                            emission, std::move(kept));
}

Result<double> ScatterSolve::step(const shadow::Gpu& gpu, double ms) {
  if (field_) return 1.0;
  const auto keep = [&](transport::Solution solution) -> Result<double> {
    PILEUS_TRY(ScatterField field, ScatterField::create(std::move(solution), scaledLight(scene_->volumes)));
    field_ = std::make_shared<const ScatterField>(std::move(field));
    if (cache_) cache_->keep(key_, field_);
    job_ = nullptr;
    return 1.0;
  };
  if (!job_) {
    if (gather_->empty()) return keep({});
    PILEUS_TRY(const double gathered, gather_->step(gpu, ms));
    if (gathered < 1) return 0.5 * gathered;
    job_ = looseJob<transport::Solution>(
        [cells = gather_->cells(), residual = scene_->options.scatter.residual](JobControl& control) {
          transport::SolveOptions options;
          options.residual = residual;
          return transport::solve(cells, options, control);
        });
  }
  if (std::isinf(ms)) job_->wait();
  if (!job_->done()) return 0.5 + 0.49 * job_->progress();
  if (!job_->result()) return job_->result().error();
  return keep(job_->result().value());
}

}  // namespace pileus::view
