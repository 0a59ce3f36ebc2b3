#pragma once
// Writes the active picture to an EXR in the background of the session: rendered progressively at the
// document's size, frame by frame within a budget, then written by a job. GL thread.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "nodes/evaluate/evaluator.h"
#include "renderer/base/jobs.h"

namespace pileus::editor {

struct ExportRequest {
  nodes::Graph graph;
  std::string view;                      ///< the output node whose image is written
  std::filesystem::path target, folder;  ///< folder: base of relative file parameters
  std::optional<scene::Camera> freeCamera;
  int frame = 1;
};

class Exporter {
 public:
  explicit Exporter(view::Renderer* renderer) : renderer_(renderer) {}
  ~Exporter();

  void start(ExportRequest request);
  void cancel();
  bool active() const { return request_.has_value(); }
  bool wantsFrame() const { return active() && !writing_ && !waitingForJobs_; }
  double fraction() const { return fraction_; }
  const std::filesystem::path& target() const { return request_->target; }

  /// One frame's work. Returns the outcome on the frame it ends: the path written, or why not.
  std::optional<Result<std::filesystem::path>> step();

 private:
  std::optional<Result<std::filesystem::path>> finish(Result<std::filesystem::path> result);
  view::Renderer* renderer_;
  std::optional<ExportRequest> request_;
  std::unique_ptr<nodes::Evaluator> evaluator_;
  std::unique_ptr<Job<bool>> writing_;
  double fraction_ = 0;
  bool waitingForJobs_ = false;
};

}  // namespace pileus::editor
