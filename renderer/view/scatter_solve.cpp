#include "renderer/view/scatter_solve.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "renderer/base/profile.h"

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

/// The first around all, and the others with what it sends in.
Result<std::vector<transport::Solution>> solveAll(const std::vector<transport::Cells>& cells, double residual,
                                                  JobControl& control) {
  std::vector<transport::Solution> out;
  for (const transport::Cells& c : cells) {
    transport::SolveOptions options;
    options.residual = residual;
    options.around = out.empty() ? nullptr : &out.front();
    PILEUS_TRY(transport::Solution s, transport::solve(c, options, control));
    out.push_back(std::move(s));
  }
  return out;
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
  std::size_t bytes = 0;
  const auto last = std::find_if(fields_.begin(), fields_.end(),
                                 [&](const auto& f) { return (bytes += f.second->bytes()) > kMostBytes; });
  if (last != fields_.end()) fields_.erase(last == fields_.begin() ? std::next(last) : last, fields_.end());
}

ScatterSolve::ScatterSolve(std::shared_ptr<const RenderScene> scene, std::shared_ptr<ScatterCache> cache,
                           SampledLights& sampled)
    : scene_(std::move(scene)), cache_(std::move(cache)), sampled_(sampled) {
  emission_ = scene_->options.layer.kind != Kind::Light && emits(*scene_);
  key_ = keyOf(*scene_, emission_);
  if (cache_) field_ = cache_->find(key_);
  if (!field_) lattices_ = scatterLattices(scene_->volumes, scene_->solids, scene_->options.scatter);
}

Result<double> ScatterSolve::gather(const shadow::Gpu& gpu, double ms) {
  const Stopwatch clock;
  const auto left = [&] { return std::max(ms - clock.ms(), 0.0); };
  constexpr double kLights = 0.2;  // share of the work
  if (!lights_) {
    PILEUS_TRY(const double lit, sampled_.make(gpu, std::nullopt, ms));
    if (lit < 1) return kLights * lit;
    lights_.emplace(sampled_.lights(), scene_->volumes, scene_->solids, emission_);
  }
  const Stopwatch work;
  double gathered = 0;  // of the lattice at hand
  while (cells_.size() < lattices_.size()) {
    if (!gather_)
      gather_ = std::make_unique<ScatterGather>(lattices_[cells_.size()], *scene_, *lights_, emission_);
    PILEUS_TRY(gathered, gather_->step(gpu, left()));
    gpuMs_ += gather_->takeGpuMs();
    if (gathered >= 1) cells_.push_back(gather_->cells()), gather_ = nullptr, gathered = 0;
    if (clock.ms() >= ms) break;
  }
  ms_ += work.ms();
  return kLights + (1 - kLights) * (double(cells_.size()) + gathered) / double(lattices_.size());
}

Result<void> ScatterSolve::finish(std::vector<transport::Solution> solutions) {
  PILEUS_TRY(ScatterField field, ScatterField::create(std::move(solutions)));
  field_ = std::make_shared<const ScatterField>(std::move(field));
  if (cache_) cache_->keep(key_, field_);
  job_ = nullptr;
  return {};
}

Result<double> ScatterSolve::step(const shadow::Gpu& gpu, double ms) {
  constexpr double kGathering = 0.5;  // share of the work
  if (field_) return 1.0;
  if (lattices_.empty()) {
    PILEUS_CHECK(finish({}));
    return 1.0;
  }
  if (!job_) {
    PILEUS_TRY(const double gathered, gather(gpu, ms));
    if (cells_.size() < lattices_.size()) return kGathering * gathered;
    lights_.reset();
    job_ = looseJob<std::vector<transport::Solution>>(
        [cells = std::move(cells_), residual = scene_->options.scatter.residual](JobControl& control) {
          return solveAll(cells, residual, control);
        });
  }
  if (std::isinf(ms)) job_->wait();
  if (!job_->waitFor(std::isinf(ms) ? 0 : ms)) return kGathering + (0.99 - kGathering) * job_->progress();
  if (!job_->result()) return job_->result().error();
  PILEUS_CHECK(finish(job_->result().value()));
  return 1.0;
}

}  // namespace pileus::view
