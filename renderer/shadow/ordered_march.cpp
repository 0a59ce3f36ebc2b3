#include "renderer/shadow/ordered_march.h"

#include <algorithm>
#include <cmath>

#include "renderer/shaders/shared/resume.h"

namespace pileus::shadow {
namespace {

constexpr double kOneDispatch = 20000;  ///< loop iterations, with room for lanes that wait for each other

/// Loop iterations of a whole light ray at most.
double iterations(const MapPass& pass, int halves) {
  double finest = std::numeric_limits<double>::infinity();
  for (const volume::Instance& i : pass.volumes()) finest = std::min(finest, volume::detailSize(i));
  const double list = pass.longestList();
  const double steps =
      std::min(list * mostSteps(pass.volumes()), pass.frustum().depth() / finest) * 2 / halves;
  return steps * (1 + std::max(list - residency::kInRegisters, 0.0)) + (2 * list + 1) * list;
}

}  // namespace

OrderedMarch::OrderedMarch(const MapPass& pass, int halves, int floats) : floats_(floats) {
  if (!pass.volumes().empty())
    windows_ = std::clamp(int(std::ceil(iterations(pass, halves) / kOneDispatch)), 1, 4096);
  defines_ = pass.defines();
  defines_.insert(defines_.end(), {{"STEP_HALVES", halves}, {"WINDOWED", windows_ > 1}});
}

gl::Defines OrderedMarch::defines() const { return defines_; }

Result<void> OrderedMarch::run(const Gpu& gpu, MapPass& pass, gl::Program& program) {
  if (windows_ == 1) return pass.dispatch(gpu, program);
  PILEUS_CHECK(states_.reserve(pass.threads() * std::size_t(floats_) * sizeof(float)));
  states_.bindStorage(BIND_MARCH_STATES);
  for (int w = 0; w < windows_; ++w) {
    program.set("window", ivec2(w, windows_));
    PILEUS_CHECK(pass.dispatch(gpu, program));
  }
  return {};
}

}  // namespace pileus::shadow
