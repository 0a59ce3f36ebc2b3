#include "renderer/residency/march_budget.h"

#include <algorithm>
#include <bit>

#include "renderer/gl/region_cursor.h"
#include "renderer/shaders/shared/records.h"
#include "renderer/shaders/shared/resume.h"

namespace pileus::residency {

static_assert(8 * (MarchBudget::kLane + MARCH_MOST_STEPS / MARCH_UNROLL) < 65535 - 4000,
              "8 lanes, each in the longest march of its own");
// A storage block that every device has.
constexpr std::size_t kGuaranteed = std::size_t(128) << 20;
constexpr std::size_t kMostPixels =
    std::size_t(gl::RegionCursor::kMostTiles) * gl::RegionCursor::kTile * gl::RegionCursor::kTile;
static_assert(16 + kMostPixels * MARCH_STATE_BYTES(std::bit_ceil(std::size_t(MAX_LIGHTS))) <= kGuaranteed,
              "the states of the largest region");

void MarchBudget::plan(const MarchCost& cost, const gl::DeviceInfo& device, int lane) {
  cost_ = cost;
  dispatched_ = 0;
  const int lanes = lane == kNever ? 0 : lane > 0 ? lane : cost.pixel > kOneDispatch ? kLane : 0;
  pace_ = {lanes, lanes, lanes};
  if (lanes > 0 && lane == 0 && !device.software) pace_.least = kLeastLane, pace_.most = kMostLane;
}

Result<void> MarchBudget::bind(gl::Program& program, int pixels) {
  PILEUS_CHECK(states_.reserve(16 + std::size_t(pixels) * std::size_t(MARCH_STATE_BYTES(cost_.reached))));
  const int none = 0;
  glNamedBufferSubData(states_.id(), 0, sizeof none, &none);
  states_.bindStorage(BIND_MARCH_STATES);
  program.set("dispatchIndex", dispatched_++);
  // Every dispatch gets at least one piece of work done, whatever its lists cost.
  program.set("budget", std::max(pace_.now, 2 * (cost_.stretch + cost_.step + cost_.sample) + 1));
  program.set("stretchCost", cost_.stretch);
  program.set("stepCost", cost_.step);
  program.set("sampleCost", cost_.sample);
  return {};
}

int MarchBudget::unfinished() {
  int count = 0;
  glGetNamedBufferSubData(states_.id(), 0, sizeof count, &count);
  if (count == 0) dispatched_ = 0;
  return count;
}

}  // namespace pileus::residency
