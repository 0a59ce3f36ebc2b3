#include "tests/support/reference_compiler.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/support/support.h"

namespace fs = std::filesystem;

namespace pileus::test {
namespace {

constexpr const char* kCompiler = "glslangValidator";

/// Of a stage, as OpenGL 4.5 guarantees it; the compiler's own table allows for more.
const std::map<std::string, int> kGuaranteed = {
    {"MaxCombinedTextureImageUnits", 16},   {"MaxTextureImageUnits", 16},
    {"MaxVertexTextureImageUnits", 16},     {"MaxDrawBuffers", 8},
    {"MaxFragmentUniformComponents", 1024}, {"MaxVertexUniformComponents", 1024},
    {"MaxComputeUniformComponents", 512}};

std::string contentOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

fs::path limits() {
  static const fs::path path = [] {
    std::istringstream lines(run({kCompiler, "-c"}).out);
    const fs::path file = scratchFolder() / "guaranteed.conf";
    std::ofstream out(file);
    for (std::string name, value; lines >> name >> value;) {
      const auto known = kGuaranteed.find(name);
      out << name << ' ' << (known == kGuaranteed.end() ? value : std::to_string(known->second)) << '\n';
    }
    return file;
  }();
  return path;
}

/// "ERROR: 3:12: ..." with the name of the file, which the source's last lines tell ("// 3: lib/light.glsl").
std::string named(const std::string& messages, const std::string& source) {
  std::map<std::string, std::string> files;
  static const std::regex table(R"(// (\d+): (.+))"), place(R"(^(ERROR|WARNING): (\d+):(\d+): (.*))");
  std::istringstream lines(source);
  std::smatch m;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, m, table)) files[m[1]] = m[2];
  std::string out;
  std::istringstream said(messages);
  for (std::string line; std::getline(said, line);) {
    if (std::regex_match(line, m, place))
      out += m[1].str() + ": " + files[m[2]] + ":" + m[3].str() + ": " + m[4].str() + "\n";
    else if (!line.empty())
      out += line + "\n";
  }
  return out;
}

/// The defines it begins with.
std::string variant(const std::string& source) {
  std::string out;
  std::istringstream lines(source);
  std::string line;
  std::getline(lines, line);  // #version
  while (std::getline(lines, line) && line.starts_with("#define ")) out += " " + line.substr(8);
  return out;
}

/// What the compiler says of each stage, all in one call: most of a call's time is its start.
std::map<std::string, std::string> refusedStages(
    const std::map<std::string, std::vector<fs::path>>& programs) {
  std::vector<std::string> call{kCompiler, limits().string()};
  std::map<std::string, std::string> said;
  for (const auto& [name, stages] : programs)
    for (const fs::path& s : stages) {
      call.push_back(s.string());
      said[s.string()];
    }
  const RunResult r = run(call, 600);
  if (r.exitCode == 0) return {};
  // A line with the name of a stage, then what there is to say of it.
  std::istringstream lines(r.out);
  std::string* of = nullptr;
  for (std::string line; std::getline(lines, line);) {
    if (const auto it = said.find(line); it != said.end())
      of = &it->second;
    else if (of && !line.empty())
      *of += line + "\n";
  }
  std::erase_if(said, [](const auto& s) { return s.second.find("ERROR") == s.second.npos; });
  if (said.empty()) said[call.back()] = fmt::format("ERROR: code {}: {}{}\n", r.exitCode, r.out, r.err);
  return said;
}

/// What it says of the stages together.
std::string linkMessages(const std::vector<fs::path>& stages) {
  std::vector<std::string> call{kCompiler, "-l", limits().string()};
  for (const fs::path& stage : stages) call.push_back(stage.string());
  const RunResult r = run(call);
  return r.exitCode == 0 ? "" : "variant" + variant(contentOf(stages.back())) + "\n" + r.out;
}

}  // namespace

bool hasReferenceCompiler() {
  static const bool there = run({kCompiler, "--version"}).exitCode == 0;
  return there;
}

std::string refusedPrograms(const fs::path& folder) {
  // A program's name is the hash of its text.
  static const fs::path taken = fs::path(PILEUS_BINARY).parent_path() / "reference_compiler";
  std::map<std::string, std::vector<fs::path>> programs;
  for (const auto& file : fs::directory_iterator(folder))
    programs[file.path().stem().string()].push_back(file.path());
  std::erase_if(programs, [](const auto& p) {
    if (!fs::exists(taken / p.first)) return false;
    for (const fs::path& s : p.second) fs::remove(s);
    return true;
  });
  if (programs.empty()) return {};
  for (auto& [name, stages] : programs)
    std::sort(stages.rbegin(), stages.rend());  // a .vert before its .frag
  std::string out;
  fs::create_directories(taken);
  const std::map<std::string, std::string> refused = refusedStages(programs);
  for (const auto& [name, stages] : programs) {
    std::string said;
    for (const fs::path& s : stages)
      if (const auto it = refused.find(s.string()); it != refused.end()) {
        const std::string source = contentOf(s);
        said += "variant" + variant(source) + "\n" + named(it->second, source);
      }
    if (said.empty() && stages.size() > 1) said = linkMessages(stages);
    if (said.empty()) std::ofstream(taken / name);
    out += said;
    for (const fs::path& s : stages) fs::remove(s);
  }
  return out;
}

fs::path compiledPrograms() {
  static const fs::path folder = scratchFolder();
  return folder;
}

}  // namespace pileus::test
