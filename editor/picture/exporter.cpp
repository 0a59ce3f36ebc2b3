#include "editor/picture/exporter.h"

#include "editor/picture/viewed_node.h"
#include "nodes/declare/value.h"
#include "nodes/evaluate/picture_layers.h"
#include "nodes/file/still_metadata.h"
#include "renderer/image/exr.h"
#include "renderer/view/picture.h"

namespace pileus::editor {

Exporter::~Exporter() = default;

void Exporter::start(ExportRequest request) {
  cancel();
  request_ = std::move(request);
  // Its own evaluator: the window's keeps the results of the picture on the screen.
  evaluator_ = std::make_unique<nodes::Evaluator>(renderer_);
}

void Exporter::cancel() {
  writing_.reset();
  evaluator_.reset();
  request_.reset();
  fraction_ = 0;
  waitingForJobs_ = false;
}

std::optional<Result<std::filesystem::path>> Exporter::finish(Result<std::filesystem::path> result) {
  cancel();
  return result;
}

std::optional<Result<std::filesystem::path>> Exporter::step() {
  if (!request_) return std::nullopt;
  if (writing_) {
    if (!writing_->done()) return std::nullopt;
    const Result<bool>& written = writing_->result();
    if (!written) return finish(written.error());
    return finish(request_->target);
  }
  nodes::EvalSettings settings;
  settings.size = request_->graph.settings.size;
  settings.freeCamera = request_->freeCamera;
  settings.folder = request_->folder;
  settings.frame = request_->frame;
  settings.extra = nodes::wantedLayers(request_->graph, request_->view);
  const nodes::EvalReport report = evaluator_->evaluate(request_->graph, {request_->view}, settings);
  fraction_ = report.fraction;
  waitingForJobs_ = report.waitingForJobs;
  if (!report.complete) return std::nullopt;
  const nodes::NodeStatus& status = evaluator_->status(request_->view);
  if (status.state == nodes::NodeState::Failed || status.state == nodes::NodeState::Skipped)
    return finish(status.error);
  const nodes::SocketValue* value = shownImage(*evaluator_, request_->graph, request_->view);
  const auto* picture = value ? std::get_if<nodes::ImageValue>(value) : nullptr;
  if (!picture || !picture->picture)
    return finish(fail(Code::Input, "{}: no image is linked", request_->view));
  Result<image::Image> image = view::readBack(*picture->picture);
  if (!image) return finish(image.error());
  nodes::nameLightLayers(*image, *evaluator_, request_->graph, request_->view);
  image->metadata.merge(nodes::stillMetadata(request_->graph, request_->target, request_->folder));
  evaluator_.reset();  // frees its GPU memory while the file is written
  writing_ = std::make_unique<Job<bool>>(
      [target = request_->target, pixels = std::move(*image)](JobControl&) -> Result<bool> {
        PILEUS_CHECK(image::writeExr(target, pixels));
        return true;
      });
  return std::nullopt;
}

}  // namespace pileus::editor
