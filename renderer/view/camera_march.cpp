#include "renderer/view/camera_march.h"

#include <cmath>

#include "renderer/view/march_cost.h"

namespace pileus::view {
namespace {

/// Pixels each instance may touch; the whole picture where a corner is beside or behind the eye.
std::vector<residency::PixelBounds> pixelBounds(std::span<const volume::Instance> instances,
                                                const RenderOptions& o) {
  const glm::dmat3 axes = scene::basis(o.camera);
  const double th = std::tan(glm::radians(o.camera.fov) / 2), tw = th * o.size.x / o.size.y;
  const dvec2 size(o.size);
  std::vector<residency::PixelBounds> out;
  for (const volume::Instance& i : instances) {
    const Box3 local = volume::localBounds(i);
    dvec2 lo(1e9), hi(-1e9);
    bool near = false, front = false;
    for (int c = 0; c < 8; ++c) {
      const dvec3 p =
          glm::transpose(axes) * (dvec3(i.worldFromLocal * dvec4(local.corner(c), 1.0)) - o.camera.eye);
      const double depth = -p.z;
      front |= depth > 0;
      if (depth < 1e-9 * glm::length(p) + 1e-12) {
        near = true;
        continue;
      }
      const dvec2 ndc(p.x / (depth * tw), -p.y / (depth * th));
      lo = glm::min(lo, ndc), hi = glm::max(hi, ndc);
    }
    const auto pixel = [&](dvec2 ndc, double room) {
      return glm::clamp((ndc * 0.5 + 0.5) * size + room, dvec2(-1), size + 1.0);
    };
    if (near)
      out.push_back(front ? residency::PixelBounds{ivec2(0), o.size} : residency::PixelBounds{});
    else
      out.push_back({ivec2(glm::floor(pixel(lo, -1))), ivec2(glm::ceil(pixel(hi, 1)))});
  }
  return out;
}

std::span<const volume::Instance> drawn(const LightSet& lights) {
  return std::span(lights.volumes()).first(lights.drawnVolumes());
}

}  // namespace

void setCamera(gl::Program& program, const RenderOptions& o, const dvec3& origin) {
  const glm::dmat3 axes = scene::basis(o.camera);
  const double th = std::tan(glm::radians(o.camera.fov) / 2);
  program.set("size", o.size);
  program.set("eye", vec3(o.camera.eye - origin));
  program.set("right", vec3(axes[0] * th * (static_cast<double>(o.size.x) / o.size.y)));
  program.set("up", vec3(axes[1] * th));
  program.set("back", vec3(axes[2]));
}

dvec3 originOf(const RenderOptions& options, const LightSet& lights) {
  Box3 media;
  for (const volume::Instance& i : drawn(lights)) {
    const Box3 box = volume::worldBounds(i);
    if (!box.empty()) media.extend(box);
  }
  return media.empty() ? options.camera.eye : glm::clamp(options.camera.eye, media.min, media.max);
}

Result<residency::Residency> CameraMarch::prepare(const shadow::Gpu& gpu, const RenderOptions& options,
                                                  const LightSet& lights, double ms) {
  return run.prepare(gpu.bricks, lights.volumes(), ms, originOf(options, lights),
                     options.scatter.kind == Scattering::Grid);
}

void CameraMarch::list(const RenderOptions& options, const LightSet& lights) {
  bounds_ = pixelBounds(drawn(lights), options);
  run.list(options.size, bounds_);
}

void CameraMarch::plan(residency::MarchBudget& budget, const RenderOptions& options, const LightSet& lights,
                       const gl::DeviceInfo& device, int lane, int reached) const {
  residency::MarchCost cost = marchCost(options, drawn(lights), bounds_, run.longestList(), lights);
  cost.reached = reached;
  budget.plan(cost, device, lane);
}

Result<gl::Program*> CameraMarch::bind(const shadow::Gpu& gpu, const char* entry,
                                       const RenderOptions& options, const LightSet& lights,
                                       const residency::MarchBudget& budget, const gl::Defines& defines) {
  gl::Defines all = lights.defines();
  for (const gl::Defines& more : {run.defines(), defines}) all.insert(all.end(), more.begin(), more.end());
  all.insert(
      all.end(),
      {{"SOLIDS", lights.drawnSolids() > 0}, {"RESUME", budget.resumes()}, {"REACHED", budget.reached()}});
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({entry}, all));
  PILEUS_CHECK(run.bind(gpu.bricks, *program));
  setCamera(*program, options, run.origin());
  program->set("pixelAngle",
               static_cast<float>(2 * std::tan(glm::radians(options.camera.fov) / 2) / options.size.y));
  program->set("stepScale", static_cast<float>(options.stepScale));
  program->set("solidCount", int(lights.drawnSolids()));
  return program;
}

}  // namespace pileus::view
