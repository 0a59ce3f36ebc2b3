// Files of older formats: they keep every value they had, also those that were defaults and are not written.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "nodes/file/serialize.h"
#include "nodes/graph/graph_groups.h"
#include "renderer/base/file.h"
#include "tests/support/support.h"

namespace pileus::nodes {
namespace {

using Json = nlohmann::json;

/// A default that changed after a format.
struct Changed {
  std::string type, param, before, now;
  std::string name() const { return type + "." + param; }
};

/// All of them: the list of that format against the registry. A parameter that is new since has no line
/// there, unless files of that format were read as one of its values has it now.
std::vector<Changed> changedDefaults(int format) {
  const std::string name = "/tests/unit/nodes/fixtures/defaults" + std::to_string(format) + ".txt";
  std::istringstream list(readFile(std::string(PILEUS_SOURCE_DIR) + name).value());
  std::vector<Changed> out;
  for (std::string line; std::getline(list, line);) {
    const std::size_t equals = line.find(" = "), dot = line.rfind('.', equals);
    Changed c{line.substr(0, dot), line.substr(dot + 1, equals - dot - 1), line.substr(equals + 3), ""};
    const NodeType* type = findNodeType(c.type);
    const ParamSpec* spec = type ? type->param(c.param) : nullptr;
    EXPECT_TRUE(spec) << line;
    if (!spec) continue;
    c.now = formatParam(*spec, spec->fallback);
    if (c.now != c.before) out.push_back(c);
  }
  return out;
}

/// As files have it: a number, true or false, else a text.
Json valueJson(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  return json.is_discarded() ? Json(text) : json;
}

Json fileOf(const Json& nodes, int format) {
  return {{"pileus", format}, {"nodes", nodes}, {"links", Json::array()}};
}

Graph parsed(const Json& file) {
  const auto loaded = parseGraph(file.dump());
  EXPECT_TRUE(loaded) << loaded.error().message;
  for (const Fault& fault : loaded->faults) ADD_FAILURE() << faultText(fault) << "\n" << file.dump(1);
  return loaded->graph;
}

std::string valueOf(const Graph& graph, const Changed& c, double frame = 1) {
  const Node* node = findNode(graph, "N");
  const ParamSpec& spec = *findNodeType(c.type)->param(c.param);
  return node ? formatParam(spec, paramValue(*node, spec, frame)) : "no node";
}

/// Calls `body(format, changed default)` for all formats of before.
template <class Body>
void forChangedDefaults(const Body& body) {
  for (int format = 1; format < kFormatVersion; ++format) {
    const std::vector<Changed> all = changedDefaults(format);
    EXPECT_FALSE(all.empty()) << format;
    for (const Changed& c : all) {
      SCOPED_TRACE(std::to_string(format) + " " + c.name());
      body(format, c);
    }
  }
}

TEST(Migration, OldFormatsKeepWhatWasADefault) {
  forChangedDefaults([](int format, const Changed& c) {
    for (const Json& node : {Json{{"type", c.type}}, Json{{"type", c.type}, {"params", Json::object()}}}) {
      const Graph old = parsed(fileOf({{"N", node}}, format));
      EXPECT_EQ(valueOf(old, c), c.before);
      EXPECT_EQ(valueOf(parsed(Json::parse(graphText(old))), c), c.before) << "and saved as the newest";
      EXPECT_EQ(valueOf(parsed(fileOf({{"N", node}}, kFormatVersion)), c), c.now)
          << "which means the new one";
    }
  });
}

TEST(Migration, KeepsItInGroupsWithinGroups) {
  forChangedDefaults([](int format, const Changed& c) {
    const auto group = [](const Json& nodes) -> Json {
      return {{"Group", {{"type", "group"}, {"graph", {{"nodes", nodes}, {"links", Json::array()}}}}}};
    };
    const Graph old = parsed(fileOf(group(group({{"N", {{"type", c.type}}}})), format));
    const std::vector<std::string> scope{"Group", "Group"};
    ASSERT_TRUE(graphAt(old, scope));
    EXPECT_EQ(valueOf(*graphAt(old, scope), c), c.before);
  });
}

TEST(Migration, LeavesWhatAFileSays) {
  forChangedDefaults([](int format, const Changed& c) {
    const auto with = [&](const Json& value) {
      return parsed(fileOf({{"N", {{"type", c.type}, {"params", {{c.param, value}}}}}}, format));
    };
    EXPECT_EQ(valueOf(with(valueJson(c.now)), c), c.now);
    const Json keys = {{"keys", {{1, valueJson(c.now), "constant"}, {2, valueJson(c.before), "constant"}}}};
    const Graph animated = with(keys);
    EXPECT_EQ(valueOf(animated, c, 1), c.now);
    EXPECT_EQ(valueOf(animated, c, 2), c.before);
    EXPECT_TRUE(findNode(animated, "N")->params.empty() ||
                !findNode(animated, "N")->params.contains(c.param));
  });
}

/// What a link brings counts, and what stands below it counts again once the link is muted.
TEST(Migration, KeepsTheDefaultBelowALink) {
  const Changed radius{"light.point", "radius", "0.01", "0"};
  for (const char* list : {"links", "muted"}) {
    Json file = fileOf({{"N", {{"type", "light.point"}, {"expose", {"radius"}}}},
                        {"Number", {{"type", "value.number"}, {"params", {{"value", 0.5}}}}}},
                       1);
    file[list] = {"Number.value -> N.radius"};
    const Graph old = parsed(file);
    ASSERT_EQ(old.links.size(), 1u);
    EXPECT_EQ(old.links[0].muted, list == std::string("muted"));
    EXPECT_EQ(findNode(old, "N")->expose, std::vector<std::string>{"radius"});
    EXPECT_EQ(valueOf(old, radius), "0.01");
  }
}

TEST(Migration, LeavesWhatIsNoGraphToTheReader) {
  const auto faults = [](const Json& file) {
    std::string all;
    const auto loaded = parseGraph(file.dump());
    EXPECT_TRUE(loaded);
    for (const Fault& fault : loaded->faults) all += faultText(fault) + "\n";
    return all;
  };
  EXPECT_EQ(faults(fileOf({{"N", {{"type", "light.point"}, {"params", 3}}}}, 1)),
            "error: N.params: is not an object\n");
  EXPECT_EQ(faults(fileOf({{"N", {{"type", 3}}}}, 1)), "error: N.type: is missing or not a text\n");
  EXPECT_EQ(faults(fileOf({{"N", 3}}, 1)), "error: N: is not an object\n");
  EXPECT_EQ(faults(fileOf(3, 1)), "error: nodes: is not an object\n");
  EXPECT_EQ(faults(fileOf({{"G", {{"type", "group"}, {"graph", 3}}}}, 1)),
            "error: G.graph: is not an object\n");
}

}  // namespace
}  // namespace pileus::nodes
