#include "editor/parameters/point_edit.h"

namespace pileus::editor {
namespace {

constexpr std::size_t kMostKept = 16;

}  // namespace

const volume::DensityHistogram* histogramOf(DensityHistograms& histograms, const volume::InstanceList& list) {
  auto& jobs = histograms.jobs;
  const Key key = volume::contentKey(list);
  auto it = jobs.find(key);
  if (it == jobs.end()) {
    if (jobs.size() >= kMostKept) jobs.clear();
    const auto count = [list](JobControl& control) -> Result<volume::DensityHistogram> {
      auto histogram = volume::densityHistogram(list, control);
      if (!histogram) return fail(Code::Cancelled, "cancelled");
      return std::move(*histogram);
    };
    it = jobs.emplace(key, looseJob<volume::DensityHistogram>(count)).first;
  }
  return it->second->done() && it->second->result() ? &*it->second->result() : nullptr;
}

}  // namespace pileus::editor
