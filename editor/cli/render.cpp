#include "editor/cli/render.h"

#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "editor/cli/graph_file.h"
#include "editor/cli/render_target.h"
#include "nodes/declare/value.h"
#include "nodes/evaluate/evaluator.h"
#include "nodes/evaluate/picture_layers.h"
#include "nodes/file/still_metadata.h"
#include "nodes/graph/graph_change.h"
#include "renderer/base/file.h"
#include "renderer/base/profile.h"
#include "renderer/gl/context.h"
#include "renderer/image/color.h"
#include "renderer/image/exr.h"
#include "renderer/image/png.h"
#include "renderer/view/picture.h"
#include "renderer/view/renderer.h"

namespace fs = std::filesystem;

namespace pileus::cli {
namespace {

using nodes::Graph;

volatile sig_atomic_t interrupted = 0;
void onInterrupt(int) { interrupted = 1; }

int report(const Error& e) {
  std::fprintf(stderr, "pileus: %s\n", e.message.c_str());
  return static_cast<int>(e.code);
}

/// The graph with --set and --size applied. Faults of the file are printed; any error among them ends it.
Result<Graph> prepared(const RenderOptions& o) {
  PILEUS_TRY(Graph graph, o.text.empty() ? loadFaultless(o.file, "rendered")
                                         : withoutFaults(nodes::parseGraph(o.text), o.file, "rendered"));
  for (const std::string& text : o.set) {
    const std::size_t equals = text.find('='), dot = text.rfind('.', equals);
    if (equals == text.npos || dot == text.npos)
      return fail(Code::Arguments, "--set: '{}' is not Node.param=value", text);
    const std::string node = text.substr(0, dot), param = text.substr(dot + 1, equals - dot - 1);
    const nodes::Node* found = nodes::findNode(graph, node);
    if (!found) return fail(Code::Arguments, "--set: {} has no node named '{}'", o.file.string(), node);
    const nodes::NodeType* type = nodes::findNodeType(found->type);
    const nodes::ParamSpec* spec = type ? type->param(param) : nullptr;
    if (!spec) return fail(Code::Arguments, "--set: {} ({}) has no parameter '{}'", node, found->type, param);
    for (const nodes::Link& link : graph.links)
      if (!link.muted && link.toNode == node && link.toSocket == param)
        return fail(Code::Arguments,
                    "--set: {}.{} is given by the link {}: set what it comes from, or mute it", node, param,
                    nodes::linkText(link));
    auto value = nodes::parseParam(*spec, std::string_view(text).substr(equals + 1));
    if (!value) return fail(Code::Arguments, "--set: {}.{}: {}", node, param, value.error().message);
    auto edited = nodes::setParam(graph, node, param, *value);
    if (!edited) return fail(Code::Arguments, "--set: {}", edited.error().message);
    graph = std::move(edited).value();
  }
  if (o.size) graph.settings.size = *o.size;
  return graph;
}

class Progress {
 public:
  Progress(int frame, int done, int frames)
      : frame_(frame), done_(done), frames_(frames), terminal_(::isatty(2) != 0) {}
  void show(double fraction) {
    if (!terminal_ || clock_.ms() - last_ < 200) return;
    last_ = clock_.ms();
    const double left = fraction > 0.02 ? clock_.ms() * (1 - fraction) / fraction * 1e-3 : 0;
    std::fprintf(stderr, "\rframe %d (%d of %d)  %3.0f %%  %s\033[K", frame_, done_ + 1, frames_,
                 100 * fraction, left > 0 ? fmt::format("{:.0f} s left", left).c_str() : "");
  }
  void finish(const std::string& path) {
    std::fprintf(stderr, "%sframe %d: %s (%.1f s)\n", terminal_ ? "\r\033[K" : "", frame_, path.c_str(),
                 clock_.ms() * 1e-3);
  }

 private:
  int frame_, done_, frames_;
  bool terminal_;
  double last_ = -1000;
  Stopwatch clock_;
};

/// Evaluates until `target` is complete. Warnings of nodes are printed once each.
Result<void> evaluateFrame(nodes::Evaluator& evaluator, const Graph& graph, const std::string& target,
                           nodes::EvalSettings settings, Progress& progress, std::set<std::string>& printed) {
  settings.budgetMs = 250;
  nodes::EvalReport r;
  do {
    if (interrupted) return fail(Code::Cancelled, "cancelled");
    r = evaluator.evaluate(graph, {target}, settings);
    progress.show(r.fraction);
    if (r.waitingForJobs) std::this_thread::sleep_for(std::chrono::milliseconds(3));
  } while (!r.complete);
  std::optional<Error> error;
  for (const auto& [name, node] : graph.nodes) {
    const nodes::NodeStatus& s = evaluator.status(name);
    for (const std::string& w : s.warnings)
      if (printed.insert(name + w).second)
        std::fprintf(stderr, "pileus: warning: %s: %s\n", name.c_str(), w.c_str());
    if (s.state != nodes::NodeState::Failed) continue;
    if (error) std::fprintf(stderr, "pileus: %s\n", error->message.c_str());
    error = s.error;
  }
  if (error) return *error;
  return {};
}

/// Display-referred PNG beside the EXR, through the view node's (or the default) display transform.
Result<void> writePreview(const fs::path& path, const image::Image& picture, const Graph& graph,
                          const std::string& target, const fs::path& folder) {
  PILEUS_TRY(const auto config, colorConfigOf(graph, folder));
  const DisplayChoice choice = displayOf(graph, target);
  std::vector<float> rgba = picture.layers.front().pixels;
  const float gain = float(std::exp2(choice.exposure));
  for (std::size_t i = 0; i < rgba.size(); ++i)
    if (i % 4 != 3) rgba[i] *= gain;
  PILEUS_CHECK(config->applyCpu(choice.display, choice.view, rgba.data(), rgba.size() / 4, choice.look));
  for (std::size_t i = 0; choice.gamma != 1 && i < rgba.size(); ++i)
    if (i % 4 != 3) rgba[i] = std::pow(std::max(rgba[i], 0.0f), float(1 / choice.gamma));
  return image::writePng(path, picture.size, rgba.data());
}

image::ExrOptions exrOptions(const Graph& graph, const std::string& target) {
  image::ExrOptions options;
  const nodes::Node& node = *nodes::findNode(graph, target);
  if (node.type != "output.exr") return options;
  const nodes::NodeType& type = *nodes::findNodeType(node.type);
  options.type =
      enumFromId<image::PixelType>(std::get<std::string>(nodes::paramValue(node, *type.param("type"))))
          .value_or(options.type);
  options.compression = enumFromId<image::Compression>(
                            std::get<std::string>(nodes::paramValue(node, *type.param("compression"))))
                            .value_or(options.compression);
  return options;
}

/// Memory of this process; 0: not told.
std::size_t residentBytes() {
  std::size_t all = 0, resident = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "re")) {
    if (std::fscanf(file, "%zu %zu", &all, &resident) != 2) resident = 0;
    std::fclose(file);
  }
  return resident * std::size_t(::sysconf(_SC_PAGESIZE));
}

nlohmann::json statistics(const nodes::Evaluator& evaluator, const Graph& graph, int frame, double seconds) {
  nlohmann::json out{{"frame", frame},
                     {"seconds", seconds},
                     {"residentBytes", residentBytes()},
                     {"nodes", nlohmann::json::object()}};
  for (const auto& [name, node] : graph.nodes) {
    const nodes::NodeStatus& s = evaluator.status(name);
    out["nodes"][name] = {
        {"type", node->type},           {"cpuMs", s.cpuMs}, {"gpuMs", s.gpuMs},      {"bytes", s.bytes},
        {"evaluations", s.evaluations}, {"notes", s.notes}, {"warnings", s.warnings}};
  }
  return out;
}

/// Where a picture goes, frame by frame.
struct Target {
  FramePattern name;
  TargetKind kind = TargetKind::Exr;
  bool stream = false;  ///< no file: there is nothing to be kept, replaced or put beside it

  std::string shown(int frame) const {
    return kind == TargetKind::StandardOutput ? "standard output" : name.path(frame);
  }
};

/// Of `-o`, or of the EXR output itself. Everything that stands in the way is found before any work is done.
Result<Target> targetOf(const RenderOptions& o, const Graph& graph, const std::string& node,
                        const fs::path& folder, const ivec3& frames, int count) {
  std::string out = o.out.string();
  const bool given = !out.empty();
  if (!given && nodes::findNode(graph, node)->type == "output.exr") {
    out = std::get<std::string>(
        nodes::paramValue(*nodes::findNode(graph, node), *nodes::findNodeType("output.exr")->param("file")));
    if (!out.empty() && fs::path(out).is_relative()) out = (folder / out).string();
  }
  if (out.empty()) return fail(Code::Arguments, "no target: give -o OUT.exr");
  // What a graph file says wrongly is its fault, not that of the command line.
  const auto blamed = [&](const Error& e) {
    return given ? e : Error{Code::Input, fmt::format("{}.file: {}", node, e.message)};
  };
  Target target;
  const auto kind = targetKind(out);
  if (!kind) return blamed(kind.error());
  const auto name = framePattern(out);
  if (!name) return blamed(name.error());
  target.kind = *kind;
  target.name = *name;
  target.stream = *kind == TargetKind::StandardOutput || isStream(out);
  if (o.png && target.stream)
    return fail(Code::Arguments, "--png: {} is no file that a PNG could lie beside", target.shown(0));
  if (*kind == TargetKind::StandardOutput) {
    if (count > 1)
      return fail(Code::Arguments,
                  "standard output takes one picture, but {} frames are asked for: give "
                  "--frames FRAME",
                  count);
    return target;
  }
  PILEUS_CHECK(checkTarget(target.name.path(frames.x)));
  if (count > 1 && !target.name.hasFrame() && !target.stream)
    return fail(Code::Arguments, "{} frames need a frame token in the target: such as {}.####{}", count,
                fs::path(out).replace_extension().string(), fs::path(out).extension().string());
  std::error_code ec;
  if (count == 1 && !o.overwrite && !target.stream && fs::exists(target.name.path(frames.x), ec))
    return fail(Code::Input, "{}: exists; add --overwrite to replace it", target.name.path(frames.x));
  return target;
}

/// How many frames a range holds.
Result<int> countOf(const ivec3& frames) {
  constexpr std::int64_t kMost = 1000000;
  const std::int64_t count = (std::int64_t(frames.y) - frames.x) / frames.z + 1;
  if (count > kMost)
    return fail(Code::Arguments, "{} frames, from {} to {}: at most {} are rendered in one run", count,
                frames.x, frames.y, kMost);
  return static_cast<int>(count);
}

/// Is the frame there, whole?
bool isDone(const Target& target, const fs::path& path) {
  std::error_code ec;
  if (target.stream || !fs::exists(path, ec)) return false;
  if (target.kind == TargetKind::Exr) return bool(image::readExr(path));
  const auto bytes = readFile(path);
  return bytes && image::decodePng(*bytes);
}

Result<void> writePicture(const Target& target, const fs::path& path, const image::Image& picture,
                          const Graph& graph, const std::string& node, const fs::path& folder, bool preview) {
  if (target.kind == TargetKind::Png) return writePreview(path, picture, graph, node, folder);
  std::vector<std::string> warnings;
  if (target.kind == TargetKind::StandardOutput) {
    PILEUS_TRY(const std::string bytes, image::encodeExr(picture, exrOptions(graph, node), warnings));
    PILEUS_CHECK(writeStandardOutput(bytes));
  } else {
    PILEUS_CHECK(image::writeExr(path, picture, exrOptions(graph, node), &warnings));
  }
  for (const std::string& warning : warnings) std::fprintf(stderr, "pileus: warning: %s\n", warning.c_str());
  if (preview) return writePreview(fs::path(path).replace_extension(".png"), picture, graph, node, folder);
  return {};
}

Result<void> renderAll(const RenderOptions& o) {
  PILEUS_TRY(const Graph graph, prepared(o));
  PILEUS_TRY(const std::string target, outputNode(graph, o.file, o.output));
  const fs::path folder = fs::absolute(o.file).parent_path();
  const ivec3 frames = o.framesGiven ? o.frames : ivec3(graph.settings.frames, 1);
  PILEUS_TRY(const int count, countOf(frames));
  PILEUS_TRY(const Target to, targetOf(o, graph, target, folder, frames, count));

  PILEUS_TRY(const auto context, gl::HeadlessContext::create());
  view::RendererOptions rendererOptions;
  rendererOptions.gpuMemory = std::size_t(o.gpuMemoryMiB) << 20;
  PILEUS_TRY(const auto renderer, view::Renderer::create(rendererOptions));
  nodes::Evaluator evaluator(renderer.get());
  evaluator.setCacheLimit(0);  // a frame goes before the next one is made
  nlohmann::json stats{{"device", renderer->device().renderer}, {"frames", nlohmann::json::array()}};
  std::set<std::string> printed;
  for (int done = 0; done < count; ++done) {
    const int frame = frames.x + done * frames.z;
    const fs::path path = to.shown(frame);
    if (!o.overwrite && count > 1 && isDone(to, path)) {
      std::fprintf(stderr, "frame %d: %s is there already, skipped (--overwrite renders it again)\n", frame,
                   path.c_str());
      continue;
    }
    nodes::EvalSettings settings;
    settings.frame = frame;
    settings.size = graph.settings.size;
    settings.folder = folder;
    if (to.kind != TargetKind::Png) settings.extra = nodes::wantedLayers(graph, target);
    Progress progress(frame, done, count);
    const Stopwatch clock;
    if (const auto r = evaluateFrame(evaluator, graph, target, settings, progress, printed); !r)
      return count == 1 ? r.error() : fail(r.error().code, "frame {}: {}", frame, r.error().message);
    const nodes::SocketValue* value = evaluator.input(target, "image");
    const auto* image = value ? std::get_if<nodes::ImageValue>(value) : nullptr;
    if (!image || !image->picture) return fail(Code::Input, "{}.image: no picture arrives", target);
    PILEUS_TRY(image::Image picture, view::readBack(*image->picture));
    nodes::nameLightLayers(picture, evaluator, graph, target);
    picture.metadata.merge(nodes::stillMetadata(graph, to.stream ? o.file : path, folder));
    PILEUS_CHECK(writePicture(to, path, picture, graph, target, folder, o.png));
    progress.finish(path.string());
    stats["frames"].push_back(statistics(evaluator, graph, frame, clock.ms() * 1e-3));
  }
  if (!o.stats.empty()) PILEUS_CHECK(writeFileAtomic(o.stats, stats.dump(2) + "\n"));
  return {};
}

}  // namespace

int renderMain(const RenderOptions& options) {
  interrupted = 0;
  ::signal(SIGINT, onInterrupt);
  ::signal(SIGTERM, onInterrupt);
  ::signal(SIGPIPE, SIG_IGN);  // a reader that has gone is an error with a name
  const Result<void> r = renderAll(options);
  return r ? 0 : report(r.error());
}

}  // namespace pileus::cli
