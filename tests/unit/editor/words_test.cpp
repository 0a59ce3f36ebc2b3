// One thing has one name: the labels of nodes, parameters, commands and panels against the table of words.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>

#include "editor/commands/actions.h"
#include "editor/commands/menu.h"
#include "editor/preferences/panel_list.h"
#include "editor/start/start_view.h"
#include "nodes/declare/node_type.h"
#include "tests/support/support.h"

namespace pileus::editor {
namespace {

namespace fs = std::filesystem;

struct Word {
  std::string say, instead;
};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// The table under "## Words", a row for each word that is not said.
std::vector<Word> words() {
  std::ifstream in(fs::path(PILEUS_SOURCE_DIR) / "docs" / "contributing.md");
  std::vector<Word> out;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("## ")) inside = line == "## Words";
    const std::size_t bar = line.find(" | ");
    if (!inside || !line.starts_with("| ") || bar == std::string::npos || line.starts_with("| say")) continue;
    std::string not_ = line.substr(bar + 3, line.size() - bar - 5);
    for (std::size_t at = 0; at < not_.size();) {
      const std::size_t comma = std::min(not_.find(", ", at), not_.size());
      out.push_back({line.substr(2, bar - 2), not_.substr(at, comma - at)});
      at = comma + 2;
    }
  }
  return out;
}

/// Whole words, whatever their case.
bool has(const std::string& label, const std::string& word) {
  const std::string text = lower(label), wanted = lower(word);
  const auto letter = [&](std::size_t i) {
    return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i]));
  };
  for (std::size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted, at + 1))
    if (!(at > 0 && letter(at - 1)) && !letter(at + wanted.size())) return true;
  return false;
}

std::vector<std::pair<std::string, std::string>> labels() {
  std::vector<std::pair<std::string, std::string>> out;
  for (const nodes::NodeType& type : nodes::allNodeTypes()) {
    out.emplace_back(type.id, type.label);
    out.emplace_back(type.id, type.category);
    for (const nodes::ParamSpec& p : type.params) {
      out.emplace_back(type.id + "." + p.id, p.label);
      for (const nodes::Choice& c : p.choices) out.emplace_back(type.id + "." + p.id, c.label);
    }
    for (const auto* sockets : {&type.inputs, &type.outputs})
      for (const nodes::SocketSpec& s : *sockets) out.emplace_back(type.id + "." + s.id, s.label);
  }
  for (const auto& item : nodes::enumInfo(static_cast<nodes::SocketType*>(nullptr)))
    out.emplace_back("socket", std::string(item.label));
  for (const Action& action : allActions()) {
    out.emplace_back(action.id, action.label);
    out.emplace_back(action.id, action.menu);
  }
  for (const PanelInfo& panel : allPanels()) out.emplace_back(std::string("panel ") + panel.id, panel.title);
  for (const PresetText& preset : galleryTexts()) out.emplace_back(preset.file, preset.name);
  return out;
}

TEST(Words, LabelsSayWhatTheTableSays) {
  const std::vector<Word> table = words();
  ASSERT_GT(table.size(), 15u) << "the table is not where it was";
  EXPECT_TRUE(has("Border Color", "color"));
  EXPECT_FALSE(has("Colorful", "color"));
  for (const auto& [where, label] : labels())
    for (const Word& word : table)
      EXPECT_FALSE(has(label, word.instead))
          << where << ": \"" << label << "\" says " << word.instead << ", not " << word.say;
}

TEST(Words, PresetsAreCalledWhatTheGalleryCallsThem) {
  int presets = 0;
  for (const auto& file : fs::directory_iterator(fs::path(PILEUS_SOURCE_DIR) / "presets")) {
    if (file.path().extension() != ".json") continue;
    const std::string name = file.path().filename().string();
    ++presets;
    bool known = false;
    for (const PresetText& text : galleryTexts()) {
      if (name != text.file) continue;
      known = true;
      EXPECT_EQ(presetLabel(name), text.name);
    }
    EXPECT_TRUE(known) << name << " is not in the gallery";
  }
  EXPECT_GT(presets, 5);
}

}  // namespace
}  // namespace pileus::editor
