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
    {"renderer/transport", {"renderer/base"}},
    {"renderer/gl", {"renderer/base", "renderer/scene"}},
    {"renderer/residency",
     {"renderer/base", "renderer/scene", "renderer/volume", "renderer/image", "renderer/gl",
      "renderer/shaders"}},
    {"renderer/shadow",
     {"renderer/base", "renderer/scene", "renderer/volume", "renderer/image", "renderer/gl",
      "renderer/shaders", "renderer/residency"}},
    {"renderer/view",
     {"renderer/base", "renderer/scene", "renderer/volume", "renderer/image", "renderer/gl",
      "renderer/shaders", "renderer/residency", "renderer/shadow", "renderer/transport"}},
    {"renderer/truth",
     {"renderer/base", "renderer/scene", "renderer/volume", "renderer/image", "renderer/gl",
      "renderer/shaders", "renderer/residency", "renderer/shadow", "renderer/transport", "renderer/view"}},
    // The rooms of nodes/ may use all of renderer/ besides.
    {"nodes/declare", {}},
    {"nodes/graph", {"nodes/declare"}},
    {"nodes/file", {"nodes/declare", "nodes/graph"}},
    {"nodes/evaluate", {"nodes/declare", "nodes/graph"}},
    {"nodes/shadows", {"nodes/declare", "nodes/graph"}},
    {"nodes/types", {"nodes/declare", "nodes/shadows"}},
};

/// Rooms of the editor that show something: none sees another.
const std::set<std::string> kRooms = {"editor/graph_view",    "editor/viewport", "editor/parameters",
                                      "editor/timeline_view", "editor/lab",      "editor/lights",
                                      "editor/status",        "editor/start"};
/// What the rooms stand on, from the ground up; each with what it may use of the others.
const std::map<std::string, std::set<std::string>> kGround = {
    {"editor/exchange", {}},
    {"editor/preferences", {"editor/exchange"}},
    {"editor/toolkit", {"editor/exchange", "editor/preferences"}},
    {"editor/document", {"editor/exchange", "editor/preferences"}},
    {"editor/time", {"editor/exchange", "editor/preferences", "editor/document"}},
    {"editor/picture", {"editor/exchange", "editor/preferences", "editor/document", "editor/time"}},
};

std::string layerOf(const std::string& path) {
  if (path == "editor/editor.h") return "editor";  // names parts and includes none of them
  if (path == "editor/editor.cpp") return "editor/app";
  for (const char* top : {"renderer/", "nodes/", "editor/"})
    if (path.rfind(top, 0) == 0) return path.substr(0, path.find('/', std::string(top).size()));
  return path.substr(0, path.find('/'));
}

/// May a file of one room of the editor include one of another?
bool allowedInEditor(const std::string& from, const std::string& to) {
  if (from == "editor/app") return true;
  if (to == "editor/app" || to == "editor/cli") return false;
  if (from == "editor") return false;
  if (const auto it = kGround.find(from); it != kGround.end()) return it->second.contains(to);
  if (kRooms.contains(from)) return kGround.contains(to);
  if (from == "editor/commands") return to != "editor/dialogs";
  return from == "editor/dialogs";
}

bool allowed(const std::string& from, const std::string& to) {
  if (from == to) return true;
  if (to == "nodes/types") return false;  // seen by the list of types alone
  if (from.rfind("nodes/", 0) == 0 && to.rfind("renderer/", 0) == 0) return true;
  if (const auto it = kMayUse.find(from); it != kMayUse.end()) return it->second.contains(to);
  if (from.rfind("editor", 0) != 0) return false;
  if (from == "editor/cli") return to.rfind("nodes/", 0) == 0 || to.rfind("renderer/", 0) == 0;
  if (to.rfind("editor", 0) == 0) return allowedInEditor(from, to);
  // The toolkit and what is below it know no document.
  if (from == "editor/exchange" || from == "editor/toolkit") return to == "renderer/base";
  if (from == "editor/preferences") return to == "renderer/base" || to == "renderer/scene";
  return true;
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
    if (path.rfind("build", 0) == 0 || path.rfind("cmake", 0) == 0 ||
        (entry.path().extension() != ".h" && entry.path().extension() != ".cpp"))
      continue;
    const std::string layer = layerOf(path);
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) {
      if (line.rfind("#include <", 0) != 0) continue;
      const auto has = [&](const char* text) { return line.find(text) != line.npos; };
      // What is true of the editor is tested without a window.
      if (has("<imgui") || has("GLFW/")) {
        EXPECT_TRUE((layer.rfind("editor/", 0) == 0 && layer != "editor/cli" &&
                     (layer == "editor/toolkit" || !kGround.contains(layer))) ||
                    layer == "tests")
            << path << ": " << line;
      }
      if (has("<openvdb/")) {
        EXPECT_TRUE((layer == "renderer/volume" && entry.path().extension() == ".cpp") || layer == "tests")
            << path << ": " << line;
      }
      if (has("<nlohmann/json.hpp>")) {
        EXPECT_TRUE(layer == "nodes/file" || layer.rfind("editor", 0) == 0 || layer == "tests")
            << path << ": " << line;
      }
      if (has("<CLI/")) {
        EXPECT_EQ(path, "editor/cli/cli.cpp");
      }
    }
  }
}

/// A stranger finds a thing by the name of its file: a header and its source are one, and a folder holds
/// about 25 of them. nodes/types, a file for each node type, is a list.
TEST(Layers, AFolderHoldsAboutTwentyFiveThings) {
  std::map<std::string, std::set<std::string>> things;
  for (const char* top : {"renderer", "nodes", "editor"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(PILEUS_SOURCE_DIR) / top))
      if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
        things[fs::relative(entry.path().parent_path(), PILEUS_SOURCE_DIR).generic_string()].insert(
            entry.path().stem().string());
  EXPECT_GT(things.size(), 30u);
  for (const auto& [folder, names] : things)
    if (folder != "nodes/types") {
      EXPECT_LE(names.size(), 26u) << folder;
    }
}

}  // namespace
