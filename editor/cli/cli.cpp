#include "editor/cli/cli.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "editor/cli/bench.h"
#include "editor/cli/check.h"
#include "editor/cli/compare.h"
#include "editor/cli/info.h"
#include "editor/cli/judge.h"
#include "editor/cli/library/presets.h"
#include "editor/cli/nodes.h"
#include "editor/cli/render.h"
#include "editor/cli/shootout.h"
#include "editor/cli/tune.h"
#include "renderer/base/log.h"

namespace pileus::cli {
namespace {

constexpr int kBadArguments = static_cast<int>(Code::Arguments);

/// "1280x720" -> size; an empty text is accepted as absent.
std::string parseSize(const std::string& text, std::optional<ivec2>& out) {
  int w = 0, h = 0, used = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &w, &h, &used) != 2 || used != int(text.size()))
    return "--size: '" + text + "' is not WIDTHxHEIGHT, such as 1280x720";
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

PresetSources presetSources(const EditorSide& editor) {
  PresetSources out;
  if (editor.shippedPresets) out.shipped = editor.shippedPresets();
  if (editor.presetFolders) out.folders = editor.presetFolders();
  return out;
}

int usageError(const std::string& message) {
  std::fprintf(stderr, "pileus: %s\n", message.c_str());
  return kBadArguments;
}

/// Letters to be added, left out, changed or swapped with their neighbour until one word is the other.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

/// What is wrong with a first word that is neither a command nor a file; empty: nothing.
std::string misspelt(const CLI::App& app, int argc, char** argv) {
  if (argc < 2) return {};
  const std::string word = argv[1];
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  std::error_code ec;
  if (word.empty() || word[0] == '-' || word.find_first_of("./") != word.npos ||
      std::filesystem::exists(word, ec))
    return {};
  std::string nearest;
  std::size_t least = 3;  // more letters than that are another word
  for (const CLI::App* command : commands) {
    const std::size_t n = distance(word, command->get_name());
    if (n == 0) return {};
    if (n < least && n < word.size()) least = n, nearest = command->get_name();
  }
  if (nearest.empty()) return "there is no command '" + word + "' and no such file; see pileus --help";
  return "there is no command '" + word + "'; did you mean " + nearest + "?";
}

}  // namespace

int run(int argc, char** argv, const EditorSide& editor) {
  CLI::App app("Pileus: a node-graph volumetric lighting editor.\n`pileus [FILE]` opens the editor.",
               "pileus");
  app.footer(
      "Exit codes: 0 done, 1 internal error, 2 bad arguments, 3 bad input or unwritable output,\n"
      "4 no usable GPU or out of GPU memory, 5 cancelled, 6 a given error bound was exceeded.");
  app.set_version_flag("--version", "pileus " PILEUS_VERSION);
  bool verbose = false;
  app.add_flag("-v,--verbose", verbose, "Print what is being done.");
  std::string editorFile;

  RenderOptions render;
  std::string size, frames;
  CLI::App* renderCommand =
      app.add_subcommand("render", "Render a graph to OpenEXR files, without a window.");
  renderCommand->add_option("file", render.file, "Graph file (.json), or the name of a preset.")->required();
  renderCommand->add_option("-o,--out", render.out,
                            "Target: .exr, or .png for the view's picture alone; '#', '####', '%04d' or "
                            "'$F' is the frame. '-' is the EXR on standard output.");
  renderCommand->add_option("--size", size, "Picture size, WIDTHxHEIGHT; the file's by default.");
  renderCommand->add_option("--frames", frames, "Frames A, A-B or A-BxSTEP; the file's by default.");
  renderCommand
      ->add_option("--set", render.set, "Override a parameter: \"Node.param=value\". May be repeated.")
      ->allow_extra_args(false);
  renderCommand->add_option("--output", render.output,
                            "Name of the output node to render, where there are several.");
  renderCommand
      ->add_option("--gpu-memory", render.gpuMemoryMiB, "MiB of GPU memory for bricks and shadow maps.")
      ->check(CLI::Range(1, 1 << 20));
  renderCommand->add_flag("--overwrite", render.overwrite, "Replace existing files.");
  renderCommand->add_flag("--png", render.png, "Also write a PNG through the view's display transform.");
  renderCommand->add_option("--stats", render.stats, "Write times and memory per node to this JSON file.");

  std::vector<std::string> checkFiles;
  CLI::App* checkCommand = app.add_subcommand("check", "Report every fault of graph files by node and key.");
  checkCommand->add_option("files", checkFiles, "Graph files.")->required();

  InfoOptions info;
  CLI::App* infoCommand = app.add_subcommand("info", "List the grids of volume files.");
  infoCommand->add_option("volumes", info.files, "One or more .vdb files.")->required();
  infoCommand->add_flag("--json", info.json, "Machine-readable.");

  bool markdown = false, json = false;
  CLI::App* nodesCommand = app.add_subcommand("nodes", "List every node type and parameter.");
  CLI::Option* markdownFlag = nodesCommand->add_flag("--markdown", markdown, "As docs/nodes.md.");
  nodesCommand->add_flag("--json", json, "Machine-readable.")->excludes(markdownFlag);

  bool presetsJson = false;
  CLI::App* presetsCommand =
      app.add_subcommand("presets", "List the presets of the program and those of your folders.");
  presetsCommand->add_flag("--json", presetsJson, "Machine-readable.");

  bool keysMarkdown = false;
  CLI::App* keysCommand = app.add_subcommand("keys", "List the keys and gestures of the editor.");
  keysCommand->add_flag("--markdown", keysMarkdown, "As docs/keyboard.md.");

  CompareOptions compare;
  double maxRelMse = 0, maxScaledRelMse = 0;
  CLI::App* compareCommand = app.add_subcommand("compare", "Measure the difference of two EXR files.");
  compareCommand->add_option("a", compare.a, "Picture.")->required();
  compareCommand->add_option("b", compare.b, "Reference.")->required();
  compareCommand->add_option("b2", compare.b2,
                             "Other half of a noisy reference, independent of the first: scaled relMSE is "
                             "without their noise then. B alone counts as both halves.");
  CLI::Option* bound = compareCommand
                           ->add_option("--max-relmse", maxRelMse,
                                        "Exit with 6 where relMSE is larger, or a pixel is not finite.")
                           ->check(CLI::NonNegativeNumber);
  CLI::Option* scaledBound =
      compareCommand
          ->add_option("--max-scaled-relmse", maxScaledRelMse,
                       "Exit with 6 where scaled relMSE is larger, a pixel of it is not finite, or the "
                       "standard error of two halves is above a quarter of this.")
          ->check(CLI::NonNegativeNumber);

  JudgeArguments judge;
  std::string judgeSize;
  int judgeBounces = 0;
  double judgeBound = 0;
  CLI::App* judgeCommand =
      app.add_subcommand("judge", "Measure a graph's picture against an unbiased path tracer.");
  judgeCommand->add_option("file", judge.file, "Graph file (.json); its first frame is rendered.")
      ->required();
  judgeCommand->add_option("--output", judge.output,
                           "Name of the output node whose picture is judged, where there are several.");
  judgeCommand->add_option("--size", judgeSize, "Picture size, WIDTHxHEIGHT; the file's by default.");
  CLI::Option* bouncesGiven =
      judgeCommand
          ->add_option("--bounces", judgeBounces,
                       "How often light scatters behind the first time, 0: single scattering, -1: without "
                       "limit. By default what the picture claims: 0, of a path-traced one its own.")
          ->check(CLI::Range(-1, 100000));
  judgeCommand->add_option("--samples", judge.samples, "Paths a pixel of the judge, and of each order.")
      ->check(CLI::Range(2, 1 << 20))
      ->capture_default_str();
  judgeCommand
      ->add_option("--seconds", judge.seconds,
                   "Ends the paths behind whole samples: half of it is the judge's, half the orders'. 0: no "
                   "limit. The figures differ each time then.")
      ->check(CLI::NonNegativeNumber);
  CLI::Option* judgeBoundGiven =
      judgeCommand
          ->add_option(
              "--max-relmse", judgeBound,
              "Exit with 6 where scaled relMSE is larger, or its standard error is above a quarter of "
              "this.")
          ->check(CLI::NonNegativeNumber);
  judgeCommand->add_option("-o,--out", judge.out,
                           "EXR of the picture with layers: judge, difference (picture less judge), variance "
                           "(of the judge's pixels), and by order of scattering order1, order2, order3_4, "
                           "order5_8, order_more.");
  judgeCommand->add_flag("--json", judge.json, "Machine-readable.");
  judgeCommand->add_flag("--overwrite", judge.overwrite, "Replace an existing file.");

  ShootoutArguments shootout;
  std::string shootoutSize;
  CLI::App* shootoutCommand =
      app.add_subcommand("shootout", "Compare every shadow representation on the lights of a graph.");
  shootoutCommand->add_option("file", shootout.file, "Graph file (.json).")->required();
  shootoutCommand->add_option("-o,--out", shootout.out,
                              "Folder for shootout.csv and contact-sheet.png; FILE-shootout by default.");
  shootoutCommand->add_option("--size", shootoutSize,
                              "Size of the pictures, WIDTHxHEIGHT; 320x180 by default.");
  shootoutCommand->add_option("--samples", shootout.samples, "Samples a pixel.")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  shootoutCommand->add_option("--resolution", shootout.resolution, "Texels along the edge of a map.")
      ->check(CLI::Range(64, 4096))
      ->capture_default_str();
  shootoutCommand->add_option("--points", shootout.points, "Points a light is judged at.")
      ->check(CLI::Range(1000, 10000000))
      ->capture_default_str();
  shootoutCommand->add_option("--render", shootout.render,
                              "Name of the render node, where there are several.");
  bool shootoutByJudge = false;
  shootoutCommand->add_flag(
      "--judge", shootoutByJudge,
      "Compare pictures with unbiased paths of as many bounces as the picture claims to "
      "hold, not with marched shadows.");
  shootoutCommand->add_flag("--overwrite", shootout.overwrite, "Write into a folder that is not empty.");

  TuneArguments tune;
  CLI::App* tuneCommand =
      app.add_subcommand("tune", "Find the cheapest shadow parameters that keep a bound, and write them.");
  tuneCommand->add_option("file", tune.file, "Graph file (.json).")->required();
  tuneCommand->add_option("-o,--out", tune.out, "Graph file to write.")->required();
  CLI::Option_group* goals = tuneCommand->add_option_group("bound", "Exactly one of");
  goals->add_option("--p95", "95th percentile of |dT| on the worst light: least memory is sought.")
      ->check(CLI::PositiveNumber)
      ->each([&](const std::string& v) {
        tune.goal = {truth::TuneBound::P95, std::stod(v)};
      });
  goals
      ->add_option("--ms",
                   "Milliseconds to build all maps and look them up a million times: least error is sought.")
      ->check(CLI::PositiveNumber)
      ->each([&](const std::string& v) {
        tune.goal = {truth::TuneBound::Milliseconds, std::stod(v)};
      });
  goals->add_option("--mib", "MiB of all maps: least error is sought.")
      ->check(CLI::PositiveNumber)
      ->each([&](const std::string& v) {
        tune.goal = {truth::TuneBound::Mebibytes, std::stod(v)};
      });
  goals->require_option(1);
  tuneCommand->add_option("--points", tune.points, "Points a light is judged at.")
      ->check(CLI::Range(1000, 10000000))
      ->capture_default_str();
  tuneCommand->add_option("--max-resolution", tune.maxResolution, "Most texels along the edge of a map.")
      ->check(CLI::Range(64, 4096))
      ->capture_default_str();
  tuneCommand->add_option("--render", tune.render, "Name of the render node, where there are several.");
  tuneCommand->add_flag("--overwrite", tune.overwrite, "Replace an existing file.");

  BenchOptions bench;
  CLI::App* benchCommand = app.add_subcommand("bench", "Measure and print the tables of docs/bench.md.");
  benchCommand->add_option("--data", bench.data, "Folder with test volumes; $PILEUS_TEST_DATA by default.");
  benchCommand->add_option("--plot", bench.plot, "SVG file that the table 'curve' is also drawn to.");
  benchCommand->add_option("--only", bench.only, "Run only the tables whose name contains this.");

  for (CLI::App* c : app.get_subcommands({})) c->fallthrough();
  app.require_subcommand(0, 1);
  app.add_option("graph", editorFile, "Graph file to open in the editor.");

  if (const std::string wrong = misspelt(app, argc, argv); !wrong.empty()) return usageError(wrong);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    return usageError(std::string(e.what()) + "; see pileus --help");
  }
  if (verbose) log::setPrintLevel(log::Level::Info);
  if (const auto used = app.get_subcommands(); !used.empty() && !editorFile.empty())
    return usageError(used.front()->get_name() + ": '" + editorFile + "' is one file too many; see pileus " +
                      used.front()->get_name() + " --help");

  if (*renderCommand) {
    if (renderCommand->count("--size"))
      if (const std::string e = parseSize(size, render.size); !e.empty()) return usageError(e);
    if (renderCommand->count("--frames")) {
      if (const std::string e = parseFrames(frames, render.frames); !e.empty()) return usageError(e);
      render.framesGiven = true;
    }
    if (isPresetName(render.file)) {
      Result<NamedScene> scene = namedScene(presetSources(editor), render.file.string());
      if (!scene) return usageError(scene.error().message), static_cast<int>(scene.error().code);
      render.file = std::move(scene->file);
      render.text = std::move(scene->text);
    }
    return renderMain(render);
  }
  if (*checkCommand) return checkMain(checkFiles);
  if (*infoCommand) return infoMain(info);
  if (*nodesCommand)
    return nodesMain(markdown ? NodesFormat::Markdown : json ? NodesFormat::Json : NodesFormat::Text);
  if (*presetsCommand) return presetsMain(presetSources(editor), presetsJson);
  if (*keysCommand) {
    const std::string text = editor.keys(keysMarkdown);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return 0;
  }
  if (*compareCommand) {
    if (bound->count()) compare.maxRelMse = maxRelMse;
    if (scaledBound->count()) compare.maxScaledRelMse = maxScaledRelMse;
    return compareMain(compare);
  }
  if (*judgeCommand) {
    if (judgeCommand->count("--size"))
      if (const std::string e = parseSize(judgeSize, judge.size); !e.empty()) return usageError(e);
    if (bouncesGiven->count()) judge.bounces = judgeBounces;
    if (judgeBoundGiven->count()) judge.maxRelMse = judgeBound;
    return judgeMain(judge);
  }
  if (*shootoutCommand) {
    std::optional<ivec2> given;
    if (shootoutCommand->count("--size")) {
      if (const std::string e = parseSize(shootoutSize, given); !e.empty()) return usageError(e);
      shootout.size = *given;
    }
    if (shootoutByJudge) shootout.truth = truth::TruthKind::Judge;
    return shootoutMain(shootout);
  }
  if (*tuneCommand) return tuneMain(tune);
  if (*benchCommand) return benchMain(bench, editor.measure);
  return editor.open(editorFile);
}

}  // namespace pileus::cli
