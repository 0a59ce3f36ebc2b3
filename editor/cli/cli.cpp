#include "editor/cli/cli.h"

#include <CLI/CLI.hpp>

#include <cstdio>

#include "editor/cli/bench.h"
#include "editor/cli/check.h"
#include "editor/cli/compare.h"
#include "editor/cli/info.h"
#include "editor/cli/nodes.h"
#include "editor/cli/render.h"
#include "renderer/base/log.h"

namespace pileus::cli {
namespace {

constexpr int kBadArguments = static_cast<int>(Code::Arguments);

/// "1280x720" -> size; an empty text is accepted as absent.
std::string parseSize(const std::string& text, std::optional<ivec2>& out) {
  int w = 0, h = 0, used = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &w, &h, &used) != 2 || used != int(text.size())) return "--size: '" + text + "' is not WIDTHxHEIGHT, such as 1280x720";
  if (w < 1 || h < 1 || w > 16384 || h > 16384) return "--size: " + text + " is outside 1x1..16384x16384";
  out = ivec2(w, h);
  return {};
}

/// "A", "A-B", "A-BxS".
std::string parseFrames(const std::string& text, ivec3& out) {
  int a = 0, b = 0, s = 1, used = 0;
  const auto whole = [&] { return used == int(text.size()); };
  if (std::sscanf(text.c_str(), "%d-%dx%d%n", &a, &b, &s, &used) == 3 && whole()) {
  } else if (s = 1, used = 0; std::sscanf(text.c_str(), "%d-%d%n", &a, &b, &used) == 2 && whole()) {
  } else if (used = 0; std::sscanf(text.c_str(), "%d%n", &a, &used) == 1 && whole()) {
    b = a;
  } else {
    return "--frames: '" + text + "' is not A, A-B or A-BxSTEP";
  }
  if (b < a || s < 1) return "--frames: '" + text + "' is an empty range";
  out = ivec3(a, b, s);
  return {};
}

int usageError(const std::string& message) {
  std::fprintf(stderr, "pileus: %s\n", message.c_str());
  return kBadArguments;
}

}  // namespace

int run(int argc, char** argv, const std::function<int(const std::filesystem::path&)>& openEditor) {
  CLI::App app("Pileus: a node-graph volumetric lighting editor.\n`pileus [FILE]` opens the editor.", "pileus");
  app.footer("Exit codes: 0 done, 1 internal error, 2 bad arguments, 3 bad input or unwritable output,\n"
             "4 no usable GPU or out of GPU memory, 5 cancelled, 6 a given error bound was exceeded.");
  app.set_version_flag("--version", "pileus " PILEUS_VERSION);
  bool verbose = false;
  app.add_flag("-v,--verbose", verbose, "Print what is being done.");
  std::string editorFile;

  RenderOptions render;
  std::string size, frames;
  CLI::App* renderCommand = app.add_subcommand("render", "Render a graph to OpenEXR files, without a window.");
  renderCommand->add_option("file", render.file, "Graph file (.json).")->required();
  renderCommand->add_option("-o,--out", render.out, "Target; '#', '####', '%04d' or '$F' is the frame.");
  renderCommand->add_option("--size", size, "Picture size, WIDTHxHEIGHT; the file's by default.");
  renderCommand->add_option("--frames", frames, "Frames A, A-B or A-BxSTEP; the file's by default.");
  renderCommand->add_option("--set", render.set, "Override a parameter: \"Node.param=value\". May be repeated.")->allow_extra_args(false);
  renderCommand->add_option("--output", render.output, "Name of the output node to render, where there are several.");
  renderCommand->add_option("--gpu-memory", render.gpuMemoryMiB, "MiB of GPU memory for bricks and shadow maps.")->check(CLI::Range(1, 1 << 20));
  renderCommand->add_flag("--overwrite", render.overwrite, "Replace existing files.");
  renderCommand->add_flag("--png", render.png, "Also write a PNG through the view's display transform.");
  renderCommand->add_option("--stats", render.stats, "Write times and memory per node to this JSON file.");

  std::vector<std::string> checkFiles;
  CLI::App* checkCommand = app.add_subcommand("check", "Report every fault of graph files by node and key.");
  checkCommand->add_option("files", checkFiles, "Graph files.")->required();

  InfoOptions info;
  CLI::App* infoCommand = app.add_subcommand("info", "List the grids of a volume file.");
  infoCommand->add_option("volume", info.file, "A .vdb file.")->required();
  infoCommand->add_flag("--json", info.json, "Machine-readable.");

  bool markdown = false, json = false;
  CLI::App* nodesCommand = app.add_subcommand("nodes", "List every node type and parameter.");
  CLI::Option* markdownFlag = nodesCommand->add_flag("--markdown", markdown, "As docs/nodes.md.");
  nodesCommand->add_flag("--json", json, "Machine-readable.")->excludes(markdownFlag);

  CompareOptions compare;
  double maxRelMse = 0;
  CLI::App* compareCommand = app.add_subcommand("compare", "Measure the difference of two EXR files.");
  compareCommand->add_option("a", compare.a, "Picture.")->required();
  compareCommand->add_option("b", compare.b, "Reference.")->required();
  CLI::Option* bound = compareCommand->add_option("--max-relmse", maxRelMse, "Exit with 6 where relMSE is larger.")->check(CLI::NonNegativeNumber);

  BenchOptions bench;
  CLI::App* benchCommand = app.add_subcommand("bench", "Measure and print the tables of docs/bench.md.");
  benchCommand->add_option("--data", bench.data, "Folder with test volumes; $PILEUS_TEST_DATA by default.");
  benchCommand->add_option("--only", bench.only, "Run only the tables whose name contains this.");

  for (CLI::App* c : app.get_subcommands({})) c->fallthrough();
  app.require_subcommand(0, 1);
  app.add_option("graph", editorFile, "Graph file to open in the editor.");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    return usageError(std::string(e.what()) + "; see pileus --help");
  }
  if (verbose) log::setPrintLevel(log::Level::Info);

  if (*renderCommand) {
    if (renderCommand->count("--size"))
      if (const std::string e = parseSize(size, render.size); !e.empty()) return usageError(e);
    if (renderCommand->count("--frames")) {
      if (const std::string e = parseFrames(frames, render.frames); !e.empty()) return usageError(e);
      render.framesGiven = true;
    }
    return renderMain(render);
  }
  if (*checkCommand) return checkMain(checkFiles);
  if (*infoCommand) return infoMain(info);
  if (*nodesCommand) return nodesMain(markdown ? NodesFormat::Markdown : json ? NodesFormat::Json : NodesFormat::Text);
  if (*compareCommand) {
    if (bound->count()) compare.maxRelMse = maxRelMse;
    return compareMain(compare);
  }
  if (*benchCommand) return benchMain(bench);
  return openEditor(editorFile);
}

}  // namespace pileus::cli
