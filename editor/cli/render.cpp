#include "editor/cli/render.h"

#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <thread>

#include <fmt/ranges.h>

#include "editor/cli/graph_file.h"
#include "nodes/declare/value.h"
#include "nodes/evaluate/evaluator.h"
#include "nodes/evaluate/picture_layers.h"
#include "nodes/file/still_metadata.h"
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
  PILEUS_TRY(Graph graph, loadFaultless(o.file, "rendered"));
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
    auto value = nodes::parseParam(*spec, std::string_view(text).substr(equals + 1));
    if (!value) return fail(Code::Arguments, "--set: {}.{}: {}", node, param, value.error().message);
    auto edited = nodes::setParam(graph, node, param, *value);
    if (!edited) return fail(Code::Arguments, "--set: {}", edited.error().message);
    graph = std::move(edited).value();
  }
  if (o.size) graph.settings.size = *o.size;
  return graph;
}

/// The node that `-o` stands for: an EXR output before a view.
Result<std::string> outputNode(const Graph& graph, const RenderOptions& o) {
  const std::vector<std::string> all = nodes::outputNodes(graph);
  if (!o.output.empty()) {
    if (std::find(all.begin(), all.end(), o.output) != all.end()) return o.output;
    return fail(Code::Arguments, "--output: {} has no output node named '{}'{}", o.file.string(), o.output,
                all.empty() ? "" : "; it has " + fmt::format("{}", fmt::join(all, ", ")));
  }
  if (all.empty())
    return fail(Code::Input, "{}: has no output node (output.exr or output.view)", o.file.string());
  std::vector<std::string> files;
  for (const std::string& n : all)
    if (nodes::findNode(graph, n)->type == "output.exr") files.push_back(n);
  const std::vector<std::string>& candidates = files.empty() ? all : files;
  if (candidates.size() == 1) return candidates.front();
  return fail(Code::Arguments, "{}: has several output nodes ({}); choose one with --output", o.file.string(),
              fmt::join(candidates, ", "));
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

/// May the target be written? Asked before any work is done.
Result<void> checkTarget(const fs::path& path) {
  std::error_code ec;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ec))
    return fail(Code::Input, "{}: cannot be written (folder {} does not exist)", path.string(),
                folder.string());
  if (fs::is_directory(path, ec))
    return fail(Code::Input, "{}: cannot be written (is a folder)", path.string());
  if (::access(folder.c_str(), W_OK) != 0)
    return fail(Code::Input, "{}: cannot be written (folder {} is not writable)", path.string(),
                folder.string());
  return {};
}

Result<void> renderAll(const RenderOptions& o) {
  PILEUS_TRY(const Graph graph, prepared(o));
  PILEUS_TRY(const std::string target, outputNode(graph, o));
  const fs::path folder = fs::absolute(o.file).parent_path();
  std::string out = o.out.string();
  if (out.empty() && nodes::findNode(graph, target)->type == "output.exr") {
    out = std::get<std::string>(nodes::paramValue(*nodes::findNode(graph, target),
                                                  *nodes::findNodeType("output.exr")->param("file")));
    if (!out.empty() && fs::path(out).is_relative()) out = (folder / out).string();
  }
  if (out.empty()) return fail(Code::Arguments, "no target: give -o OUT.exr");
  const ivec3 frames = o.framesGiven ? o.frames : ivec3(graph.settings.frames, 1);
  const int count = (frames.y - frames.x) / frames.z + 1;
  bool hasToken = false;
  PILEUS_CHECK(checkTarget(framePath(out, frames.x, &hasToken)));
  if (count > 1 && !hasToken)
    return fail(Code::Arguments, "{} frames need a frame token in the target: such as {}.####.exr", count,
                fs::path(out).replace_extension().string());
  std::error_code ec;
  if (count == 1 && !o.overwrite && fs::exists(framePath(out, frames.x), ec))
    return fail(Code::Input, "{}: exists; add --overwrite to replace it", framePath(out, frames.x));

  PILEUS_TRY(const auto context, gl::HeadlessContext::create());
  view::RendererOptions rendererOptions;
  rendererOptions.gpuMemory = std::size_t(o.gpuMemoryMiB) << 20;
  PILEUS_TRY(const auto renderer, view::Renderer::create(rendererOptions));
  nodes::Evaluator evaluator(renderer.get());
  evaluator.setCacheLimit(0);  // a frame goes before the next one is made
  nlohmann::json stats{{"device", renderer->device().renderer}, {"frames", nlohmann::json::array()}};
  std::set<std::string> printed;
  for (int frame = frames.x, done = 0; frame <= frames.y; frame += frames.z, ++done) {
    const fs::path path = framePath(out, frame);
    if (!o.overwrite && count > 1 && fs::exists(path, ec) && image::readExr(path)) {
      std::fprintf(stderr, "frame %d: %s is there already, skipped (--overwrite renders it again)\n", frame,
                   path.c_str());
      continue;
    }
    nodes::EvalSettings settings;
    settings.frame = frame;
    settings.size = graph.settings.size;
    settings.folder = folder;
    settings.extra = nodes::wantedLayers(graph, target);
    Progress progress(frame, done, count);
    const Stopwatch clock;
    PILEUS_CHECK(evaluateFrame(evaluator, graph, target, settings, progress, printed));
    const nodes::SocketValue* value = evaluator.input(target, "image");
    const auto* image = value ? std::get_if<nodes::ImageValue>(value) : nullptr;
    if (!image || !image->picture) return fail(Code::Input, "{}.image: no picture arrives", target);
    PILEUS_TRY(image::Image picture, view::readBack(*image->picture));
    picture.metadata.merge(nodes::stillMetadata(graph, path, folder));
    PILEUS_CHECK(image::writeExr(path, picture, exrOptions(graph, target)));
    if (o.png)
      PILEUS_CHECK(writePreview(fs::path(path).replace_extension(".png"), picture, graph, target, folder));
    progress.finish(path.string());
    stats["frames"].push_back(statistics(evaluator, graph, frame, clock.ms() * 1e-3));
  }
  if (!o.stats.empty()) PILEUS_CHECK(writeFileAtomic(o.stats, stats.dump(2) + "\n"));
  return {};
}

}  // namespace

std::string framePath(const std::string& out, int frame, bool* hasToken) {
  static const std::regex token(R"(#+|%0?(\d*)d|\$F(\d*))");
  // Only the file name: a folder called "shot#2" is not a token.
  const std::size_t slash = out.rfind('/');
  const std::string folder = slash == out.npos ? "" : out.substr(0, slash + 1),
                    name = out.substr(folder.size());
  std::smatch m;
  const bool found = std::regex_search(name, m, token);
  if (hasToken) *hasToken = found;
  if (!found) return out;
  const std::string text = m.str();
  int width = 1;
  if (text[0] == '#')
    width = int(text.size());
  else if (m[1].matched && m[1].length() > 0)
    width = std::stoi(m[1]);
  else if (m[2].matched && m[2].length() > 0)
    width = std::stoi(m[2]);
  return folder + m.prefix().str() + fmt::format("{:0{}d}", frame, std::min(width, 12)) + m.suffix().str();
}

int renderMain(const RenderOptions& options) {
  interrupted = 0;
  ::signal(SIGINT, onInterrupt);
  ::signal(SIGTERM, onInterrupt);
  const Result<void> r = renderAll(options);
  return r ? 0 : report(r.error());
}

}  // namespace pileus::cli
