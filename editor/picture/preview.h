#pragma once
// Keeps the viewport's picture up to date: after each change a draft, then, when nothing is dragged, the
// final picture within a time budget per frame. The last good picture stays until the new one has something
// to show. GL thread.
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/picture/draft_pace.h"
#include "editor/picture/light_switches.h"
#include "nodes/evaluate/evaluator.h"
#include "renderer/base/profile.h"

namespace pileus::editor {

/// What the viewport wants to see.
struct PreviewRequest {
  nodes::Graph graph;
  std::uint64_t generation = 0;  ///< of the session: which document it is
  std::uint64_t revision = 0;    ///< of the document: equal revisions are equal graphs
  std::string view;              ///< an output node or one with an Image output; "" = none
  ivec2 size{0};
  std::optional<scene::Camera> freeCamera;
  std::filesystem::path folder;
  int frame = 1;
  view::PictureLayer layer;
  view::PictureRegion region;
  double draftMs = 60;     ///< what a draft may take
  bool lights = false;     ///< a layer for each light besides, in the final picture
  LightSwitches switches;  ///< of lights that the graph has none of
};

class Preview {
 public:
  explicit Preview(view::Renderer* renderer);
  Preview(const Preview&) = delete;  // its evaluator knows where it is
  Preview& operator=(const Preview&) = delete;

  /// Something is being dragged: drafts until it has rested for a moment.
  void touch() { rest_.restart(), touched_ = true; }
  /// One frame's work. Cheap when nothing is to be done.
  void step(const PreviewRequest& wanted);
  void pause(bool on) { paused_ = on; }
  /// The final picture rests while something else goes first; what changes is followed all the same.
  void hold(bool on) { held_ = on; }
  /// Looks, at most once a second, whether files that the picture was made from have changed: then it is made
  /// anew.
  void watchFiles();
  /// Seconds until that is due; -1: there are none.
  double filesDueIn() const;

  bool paused() const { return paused_; }
  bool complete() const { return complete_; }
  bool settled() const { return complete_ && !currentIsDraft_; }    ///< nothing more will come
  bool refining() const { return !complete_ && !currentIsDraft_; }  ///< the final picture is on its way
  bool draft() const { return draftShown_; }                        ///< the picture shown is a draft
  bool wantsFrame() const;                                          ///< call step() again at once
  bool waiting() const {
    return !complete_ && report_.waitingForJobs;
  }  ///< for a background job: a wake-up will come
  double fraction() const { return report_.fraction; }
  /// "Baking cloud": what a pending node says; "" = nothing pends.
  std::string waitingFor() const;
  /// Why there is no new picture; "" = nothing failed. The node is the one that caused it.
  const std::string& error() const { return error_; }
  /// Of the picture last begun, and how many requests have been answered, drafts included.
  int frame() const { return current_.frame; }
  /// Something is being dragged, or was a moment ago.
  bool interacting() const { return touched_ && rest_.ms() < 150; }
  std::uint64_t answered() const { return answered_; }
  double lastStepMs() const { return lastStepMs_; }
  /// Of the last whole draft; total 0: there was none.
  const DraftTimes& draftTimes() const { return draftTimes_; }
  const DraftPace& pace() const { return pace_; }

  /// The last good picture, or the mix of its layers; null until there is one.
  const std::shared_ptr<const view::Picture>& picture() const { return mix_ ? mix_ : picture_; }
  /// The picture as it was rendered.
  const std::shared_ptr<const view::Picture>& rendered() const { return picture_; }
  /// Stands for the picture as long as that is the one it was made of; null: nothing does.
  void showMix(std::shared_ptr<const view::Picture> mix) { mix_ = std::move(mix); }
  const std::shared_ptr<const view::Picture>& mix() const { return mix_; }
  nodes::Evaluator& evaluator() { return evaluator_; }
  const nodes::Evaluator& evaluator() const { return evaluator_; }
  /// Another document is open: what belonged to the old one is no change of it.
  void newDocument() { forgetPicture(), frame_.reset(), evaluator_.forgetNames(); }
  void forgetPicture() { picture_.reset(), mix_.reset(), whole_.reset(); }

 private:
  void begin(const PreviewRequest& wanted, bool draft);
  void takePicture(bool draft);
  std::shared_ptr<const view::Picture> seed() const;
  bool letGo();
  void learnPace();

  nodes::Evaluator evaluator_;
  PreviewRequest current_;
  nodes::EvalReport report_;
  std::shared_ptr<const view::Picture> picture_, mix_;
  std::shared_ptr<const view::Picture> whole_;  ///< the last one that was no draft and no part
  std::uint64_t wholes_ = 0;                    ///< how many there were
  Key around_;                                  ///< of what stands around the region that is made
  std::string error_;
  Stopwatch rest_, filesAge_;
  DraftPace pace_;
  DraftTimes draftTimes_;
  int draftPixels_ = 0, draftTexels_ = 0;  ///< of the current draft
  double stepsMs_ = 0;                     ///< of all its steps
  bool waited_ = false;                    ///< one of them, for a job or for programs to be compiled
  std::map<std::string, std::uint64_t> evaluations_;  ///< of each node when it began
  std::optional<int> frame_;  ///< wanted last: another one is like something that is dragged
  bool touched_ = false, paused_ = false, held_ = false, complete_ = false, draftShown_ = false;
  bool currentIsDraft_ = false, fresh_ = true;
  bool fast_ = false;          ///< the last final picture took less than one budget: no drafts are needed
  bool skippedDraft_ = false;  ///< therefore the current one began without
  bool ours_ = false;          ///< the picture shown is of what is wanted, perhaps its draft
  double lastStepMs_ = 0;
  std::uint64_t answered_ = 0;
};

}  // namespace pileus::editor
