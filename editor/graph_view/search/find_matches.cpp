#include "editor/graph_view/search/find_matches.h"

#include <algorithm>

namespace pileus::editor {
namespace {

std::string lowered(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

std::vector<std::string> wordsOf(std::string_view query) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : lowered(query) + " ") {
    if (c != ' ') {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::exchange(word, {}));
    }
  }
  return words;
}

struct Found {
  int score = 0;
  std::string where;
};

/// How well one word is found in one text: its beginning, the beginning of a word, anywhere; 0: not at all.
int quality(const std::string& text, const std::string& word) {
  const std::size_t at = lowered(text).find(word);
  if (at == std::string::npos) return 0;
  return at == 0 ? 3 : text[at - 1] == ' ' || text[at - 1] == '.' ? 2 : 1;
}

/// The best place of a word in a node.
Found look(const std::string& name, const nodes::Node& node, const std::string& word, double frame) {
  Found best;
  const auto offer = [&](const std::string& text, int weight, const std::string& where) {
    if (const int q = quality(text, word); q > 0 && weight + q > best.score) best = {weight + q, where};
  };
  offer(name, 100, name);
  offer(node.label, 90, node.label);
  const nodes::NodeType* type = nodes::findNodeType(node.type);
  if (type) offer(type->label, 60, type->label);
  offer(node.type, 50, node.type);
  if (!type) return best;
  for (const nodes::ParamSpec& spec : type->params) {
    const bool own = node.params.contains(spec.id) || node.animated.contains(spec.id);
    const std::string value = nodes::formatParam(spec, nodes::paramValue(node, spec, frame));
    const std::string shown = spec.label + " " + value + (spec.unit.empty() ? "" : " " + spec.unit);
    // What was set by hand is more telling than a default.
    offer(spec.label, own ? 30 : 20, shown);
    offer(spec.id, own ? 30 : 20, shown);
    offer(value, own ? 28 : 8, shown);
  }
  return best;
}

void search(const nodes::Graph& graph, const std::vector<std::string>& words, std::vector<std::string>& scope,
            double frame, std::vector<FindMatch>& out) {
  for (const auto& [name, node] : graph.nodes) {
    FindMatch match{scope, name, {}, 0};
    int least = 1000;
    bool all = true;
    for (const std::string& word : words) {
      const Found found = look(name, *node, word, frame);
      all = all && found.score > 0;
      if (found.score < least) least = found.score, match.where = found.where;
      match.score += found.score;
    }
    if (all) out.push_back(std::move(match));
    if (node->group && scope.size() < 32) {
      scope.push_back(name);
      search(*node->group, words, scope, frame, out);
      scope.pop_back();
    }
  }
}

}  // namespace

std::vector<FindMatch> findMatches(const nodes::Graph& graph, std::string_view query, double frame) {
  std::vector<FindMatch> out;
  const std::vector<std::string> words = wordsOf(query);
  if (words.empty()) return out;
  std::vector<std::string> scope;
  search(graph, words, scope, frame, out);
  std::stable_sort(out.begin(), out.end(),
                   [](const FindMatch& a, const FindMatch& b) { return a.score > b.score; });
  return out;
}

}  // namespace pileus::editor
