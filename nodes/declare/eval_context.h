#pragma once
// What evaluate() may see and say. One lives per node evaluation, on the GL thread.
#include <any>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nodes/declare/eval_settings.h"
#include "nodes/declare/uses.h"
#include "renderer/base/hash.h"
#include "renderer/base/profile.h"

namespace pileus::view {
class Renderer;  // renderer/view/renderer.h: the GPU services (pools, programs, stores)
}

namespace pileus::nodes {

class EvalContext {
 public:
  /// `uses`: what the type declares.
  EvalContext(const EvalSettings& settings, view::Renderer* renderer, std::any& state, const Key& key,
              const Stopwatch& clock, unsigned uses = UsesNothing, std::any* lasting = nullptr)
      : settings_(&settings),
        renderer_(renderer),
        state_(&state),
        lasting_(lasting ? lasting : &own_),
        key_(key),
        clock_(&clock),
        uses_(uses) {}
  EvalContext(const EvalContext&) = delete;
  EvalContext& operator=(const EvalContext&) = delete;

  // Parts of the context: only where the type declares them. To read another is noted as a fault of the type,
  // whose results would be kept for longer than they are true.
  int frame() const { return settings(UsesFrame).frame; }
  double fps() const { return settings(UsesRate).fps; }
  const std::string& ocio() const { return settings(UsesColors).ocio; }
  ivec2 size() const { return settings(UsesSize).size; }
  Quality quality() const { return settings(UsesQuality).quality; }
  const std::optional<scene::Camera>& freeCamera() const { return settings(UsesFreeCamera).freeCamera; }
  /// For types that use the size.
  int draftPixels() const { return settings(UsesQuality | UsesSize).draftPixels; }
  /// For those that do not.
  int draftTexels() const { return settings(UsesQuality).draftTexels; }
  const view::PictureLayer& layer() const { return settings(UsesLayers).layer; }
  const view::ExtraLayers& extra() const { return settings(UsesLayers).extra; }
  const view::PictureRegion& region() const { return settings(UsesLayers).region; }
  /// No part of any key, so that all may read it.
  const std::shared_ptr<const view::Picture>& seed() const { return settings_->seed; }

  /// Null in evaluations without a GPU (tests of the model); types that need it fail with Code::Gpu.
  view::Renderer* renderer() const { return renderer_; }
  /// This evaluation's content key.
  const Key& key() const { return key_; }

  /// This node's state object, kept between calls for one content key until the node is complete (then
  /// dropped) or the key is no longer wanted.
  template <class State>
  State& state() {
    if (!state_->has_value()) *state_ = std::make_shared<State>();
    return *std::any_cast<std::shared_ptr<State>&>(*state_);
  }

  /// What this node keeps from one content key to the next, as long as it is in the graph: what its results
  /// share that took long, with whatever tells for which parameters it is true.
  template <class State>
  State& lasting() {
    if (!std::any_cast<std::shared_ptr<State>>(lasting_)) *lasting_ = std::make_shared<State>();
    return **std::any_cast<std::shared_ptr<State>>(lasting_);
  }

  /// Milliseconds left of the budget; the first step of a call is always done, so that progress is made.
  double msLeft() const { return settings_->budgetMs - clock_->ms(); }

  /// The returned value is usable but not final: show it and call again. `revision` enters the key of
  /// everything downstream, so it changes only where downstream nodes shall run again on the better value.
  /// `waitsForJob`: this thread has nothing to do for it until a job reports. With an infinite budget partial
  /// values do not flow on: downstream waits for the final one.
  void partial(double fraction, std::uint64_t revision = 0, bool waitsForJob = false) {
    incomplete_ = true, usable_ = true, fraction_ = fraction, revision_ = revision, waits_ = waitsForJob;
  }
  /// Nothing usable yet (the returned value is ignored): downstream waits, the last good picture stays.
  /// Taken to wait for a job, unless GPU time was reported.
  void pending(double fraction, std::string what) {
    incomplete_ = true, usable_ = false, fraction_ = fraction, what_ = std::move(what), waits_ = true;
  }
  /// Shown on the node; the result is valid.
  void warn(std::string text) { warnings_.push_back(std::move(text)); }
  /// Shown on the node: what it chose or guessed ("density, 111 x 222 x 112").
  void note(std::string text) { notes_.push_back(std::move(text)); }
  /// GPU time and memory this call used, for the node's statistics.
  void reportGpu(double ms, std::size_t bytes) { gpuMs_ += ms, bytes_ = bytes; }

  // Read by the evaluator.
  bool incomplete() const { return incomplete_; }
  bool usable() const { return usable_; }
  double fraction() const { return fraction_; }
  std::uint64_t revision() const { return revision_; }
  const std::string& what() const { return what_; }
  bool waitsForJob() const { return waits_ && gpuMs_ <= 0; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  const std::vector<std::string>& notes() const { return notes_; }
  double gpuMs() const { return gpuMs_; }
  std::size_t bytes() const { return bytes_; }
  unsigned undeclared() const { return undeclared_; }  ///< Uses bits of what was read against the declaration

 private:
  const EvalSettings& settings(unsigned needed) const {
    undeclared_ |= needed & ~uses_;
    return *settings_;
  }

  const EvalSettings* settings_;
  view::Renderer* renderer_;
  std::any* state_;
  std::any own_, *lasting_;
  Key key_;
  const Stopwatch* clock_;
  unsigned uses_;
  mutable unsigned undeclared_ = 0;
  bool incomplete_ = false, usable_ = true, waits_ = false;
  double fraction_ = 1;
  std::uint64_t revision_ = 0;
  std::string what_;
  std::vector<std::string> warnings_, notes_;
  double gpuMs_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace pileus::nodes
