#include "renderer/residency/region_run.h"

#include <algorithm>
#include <utility>

#include "renderer/base/profile.h"

namespace pileus::residency {

Result<void> RegionRun::bind(const BrickPool& bricks, gl::Program& program) {
  program.use();
  set_.bind(bricks, table_, program);
  tiles_.bind(program);
  return table_.bind(program);
}

Result<bool> RegionRun::dispatch(gl::Program& program, ivec2 from, ivec2 to, MarchBudget* budget) {
  const ivec2 size = to - from, groups = (size + 7) / 8;
  const bool resumes = budget && budget->resumes();
  program.set("regionOrigin", from);
  program.set("regionEnd", to);
  if (resumes) PILEUS_CHECK(budget->bind(program, size.x * size.y));
  const Stopwatch clock;
  timer_.begin();
  glDispatchCompute(GLuint(groups.x), GLuint(groups.y), 1);
  timer_.end();
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                  GL_TEXTURE_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                  GL_BUFFER_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
  glFinish();
  const double ms = clock.ms();
  longestMs_ = std::max(longestMs_, ms);
  gpuMs_ += timer_.takeMs();
  ++dispatches_;
  if (!resumes) return true;
  budget->took(ms);
  return budget->unfinished() == 0;
}

gl::Defines RegionRun::defines() const {
  return {{"SHAPES", shapes()},
          {"DENSE", set_.dense()},
          {"PHASE_LOBES", set_.phaseLobes()},
          {"ACTIVE", std::clamp(longestList(), 1, kInRegisters)},
          {"OVERFLOW", longestList() > kInRegisters}};
}

double RegionRun::takeGpuMs() { return std::exchange(gpuMs_, 0.0) + timer_.takeMs(); }

}  // namespace pileus::residency
