#include "editor/cli/check.h"

#include <algorithm>
#include <cstdio>

#include "nodes/evaluate/flatten.h"
#include "nodes/graph/graph_animation.h"

namespace pileus::cli {
namespace {

using nodes::Fault;
using nodes::Graph;

/// Why a file cannot be read, or nothing.
std::string unreadable(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) return "there is no such file";
  if (error) return error.message();
  if (std::filesystem::is_directory(status)) return "is a folder";
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file) return "cannot be opened for reading";
  std::fclose(file);
  return "";
}

void checkFiles(const std::string& name, const nodes::Node& node, const nodes::NodeType& type, bool needed,
                const std::filesystem::path& folder, std::vector<Fault>& faults) {
  for (const nodes::ParamSpec& spec : type.params) {
    if (spec.type != nodes::ParamType::File || spec.writes) continue;
    std::vector<nodes::HeldValue> values = nodes::heldValues(node, spec.id);
    if (values.empty()) values.push_back({spec.fallback, std::nullopt});
    for (const auto& [value, frame] : values) {
      const auto* text = std::get_if<std::string>(&value);
      const std::string at = frame ? fmt::format(" (key of frame {})", *frame) : "";
      if (!text || text->empty()) {
        faults.push_back({needed, name + "." + spec.id, "no file chosen" + at});
        continue;
      }
      const auto path = (folder / *text).lexically_normal();
      if (const std::string reason = unreadable(path); !reason.empty())
        faults.push_back({true, name + "." + spec.id, path.string() + ": " + reason + at});
    }
  }
}

/// One file; returns whether it has errors.
bool checkFile(const std::string& file) {
  const auto loaded = nodes::loadGraph(file);
  if (!loaded) {
    std::string_view message = loaded.error().message;
    if (message.starts_with(file + ": ")) message.remove_prefix(file.size() + 2);
    fmt::print(stderr, "{}: error: {}\n", file, message);
    fmt::print("{}: cannot be loaded\n", file);
    return true;
  }
  std::vector<Fault> faults = loaded->faults;
  std::error_code ignored;
  const auto folder = std::filesystem::absolute(file, ignored).parent_path();
  for (Fault& fault : checkNeeds(loaded->graph, folder)) faults.push_back(std::move(fault));
  for (const Fault& fault : faults) fmt::print(stderr, "{}: {}\n", file, nodes::faultText(fault));
  const auto errors =
      std::count_if(faults.begin(), faults.end(), [](const Fault& fault) { return fault.error; });
  const auto warnings = std::ssize(faults) - errors;
  const auto counted = [](std::ptrdiff_t n, const char* what) {
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
  };
  fmt::print("{}: {}\n", file,
             faults.empty() ? "ok" : counted(errors, "error") + ", " + counted(warnings, "warning"));
  return errors > 0;
}

}  // namespace

std::vector<Fault> checkNeeds(const Graph& whole, const std::filesystem::path& folder) {
  std::vector<Fault> faults;
  const Graph graph = nodes::flatten(whole).graph;
  const auto outputs = nodes::outputNodes(graph);
  if (outputs.empty()) faults.push_back({false, "", "there is no output node: nothing can be rendered"});
  const auto upstream = nodes::upstreamOrder(graph, outputs).order;
  const std::set<std::string> needed(upstream.begin(), upstream.end());
  for (const auto& [name, node] : graph.nodes) {
    const nodes::NodeType* type = nodes::findNodeType(node->type);
    if (!type || node->bypass) continue;
    checkFiles(name, *node, *type, needed.contains(name), folder, faults);
    for (const nodes::SocketSpec& input : type->inputs) {
      const auto arrives = [&](const nodes::Link& link) {
        return !link.muted && link.toNode == name && link.toSocket == input.id;
      };
      if (input.required && std::none_of(graph.links.begin(), graph.links.end(), arrives))
        faults.push_back({needed.contains(name), name + "." + input.id, "nothing is linked"});
    }
  }
  return faults;
}

int checkMain(const std::vector<std::string>& files) {
  bool errors = false;
  for (const std::string& file : files) errors = checkFile(file) || errors;
  std::fflush(stdout);
  return errors ? static_cast<int>(Code::Input) : 0;
}

}  // namespace pileus::cli
