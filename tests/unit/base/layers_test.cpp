// The layer table of docs/architecture.md, checked against every #include.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

/// What a folder's files may include (besides themselves).
const std::map<std::string, std::set<std::string>> kMayUse = {
    {"renderer/base", {}},
    {"renderer/shaders", {"renderer/base"}},
    {"renderer/scene", {"renderer/base"}},
    {"renderer/volume", {"renderer/base", "renderer/scene"}},
    {"renderer/image", {"renderer/base", "renderer/scene"}},
    {"renderer/gl", {"renderer/base", "renderer/scene"}},
    {"renderer/residency",
     {"renderer/base", "renderer/scene", "renderer/volume", "renderer/image", "renderer/gl",
      "renderer/shaders"}},
    {"renderer/shadow",
     {"renderer/base", "renderer/scene", "renderer/volume", "renderer/image", "renderer/gl",
      "renderer/shaders", "renderer/residency"}},
    {"renderer/view",
     {"renderer/base", "renderer/scene", "renderer/volume", "renderer/image", "renderer/gl",
      "renderer/shaders", "renderer/residency", "renderer/shadow"}},
    {"renderer/truth",
     {"renderer/base", "renderer/scene", "renderer/volume", "renderer/image", "renderer/gl",
      "renderer/shaders", "renderer/residency", "renderer/shadow", "renderer/view"}},
};

std::string layerOf(const std::string& path) {
  if (path.rfind("renderer/", 0) == 0) return path.substr(0, path.find('/', 9));
  if (path.rfind("editor/cli/", 0) == 0) return "editor/cli";
  return path.substr(0, path.find('/'));
}

bool allowed(const std::string& from, const std::string& to) {
  if (from == to) return true;
  if (const auto it = kMayUse.find(from); it != kMayUse.end()) return it->second.contains(to);
  if (from == "nodes") return to.rfind("renderer/", 0) == 0;
  if (from == "editor/cli") return to == "nodes" || to.rfind("renderer/", 0) == 0;
  return true;  // the editor may use everything
}

TEST(Layers, EveryIncludeFollowsTheTable) {
  int checked = 0;
  for (const char* top : {"renderer", "nodes", "editor"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(PILEUS_SOURCE_DIR) / top)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      const std::string from = layerOf(fs::relative(entry.path(), PILEUS_SOURCE_DIR).generic_string());
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        if (line.rfind("#include \"", 0) != 0) continue;
        const std::string target = line.substr(10, line.find('"', 10) - 10);
        if (target.find('/') == target.npos) continue;  // generated headers
        ++checked;
        EXPECT_TRUE(allowed(from, layerOf(target))) << entry.path() << " includes " << target;
      }
    }
  EXPECT_GT(checked, 300);
}

TEST(Layers, LibrariesStayInTheirPlace) {
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(PILEUS_SOURCE_DIR))) {
    const std::string path = fs::relative(entry.path(), PILEUS_SOURCE_DIR).generic_string();
    if (path.rfind("build", 0) == 0 ||
        (entry.path().extension() != ".h" && entry.path().extension() != ".cpp"))
      continue;
    const std::string layer = layerOf(path);
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) {
      if (line.rfind("#include <", 0) != 0) continue;
      const auto has = [&](const char* text) { return line.find(text) != line.npos; };
      if (has("<imgui") || has("GLFW/")) {
        EXPECT_TRUE(layer == "editor" || layer == "tests") << path << ": " << line;
      }
      if (has("<openvdb/")) {
        EXPECT_TRUE((layer == "renderer/volume" && entry.path().extension() == ".cpp") || layer == "tests")
            << path << ": " << line;
      }
      if (has("<nlohmann/json.hpp>")) {
        EXPECT_TRUE(layer == "nodes" || layer.rfind("editor", 0) == 0 || layer == "tests")
            << path << ": " << line;
      }
      if (has("<CLI/")) {
        EXPECT_EQ(path, "editor/cli/cli.cpp");
      }
    }
  }
}

}  // namespace
