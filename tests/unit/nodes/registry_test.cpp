// The declarations themselves: complete, consistent, and unchanged unless somebody meant it.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "nodes/declare/describe.h"
#include "nodes/file/docs_export.h"
#include "nodes/graph/animation.h"

namespace pileus::nodes {
namespace {

std::string fileText(const std::string& path) {
  std::ifstream in(std::string(PILEUS_SOURCE_DIR) + "/" + path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(Registry, EveryDeclarationIsCompleteAndUnique) {
  ASSERT_GE(allNodeTypes().size(), 9u);
  std::set<std::string> ids;
  for (const NodeType& type : allNodeTypes()) {
    SCOPED_TRACE(type.id);
    EXPECT_TRUE(ids.insert(type.id).second);
    EXPECT_EQ(findNodeType(type.id), &type);
    EXPECT_FALSE(type.label.empty());
    EXPECT_FALSE(type.category.empty());
    EXPECT_FALSE(type.help.empty());
    EXPECT_TRUE(type.evaluate);
    EXPECT_GE(type.version, 1);
    std::set<std::string> names;
    for (const SocketSpec& s : type.inputs) {
      EXPECT_TRUE(names.insert(s.id).second) << s.id;
      EXPECT_FALSE(s.label.empty() || s.help.empty()) << s.id;
      EXPECT_TRUE(s.assign) << s.id;
    }
    for (const ParamSpec& p : type.params) {
      EXPECT_TRUE(names.insert(p.id).second) << p.id;
      EXPECT_FALSE(p.label.empty() || p.help.empty()) << p.id;
      EXPECT_LE(p.hardMin, p.hardMax) << p.id;
      EXPECT_LE(p.softMin, p.softMax) << p.id;
      EXPECT_GE(p.softMin, p.hardMin) << p.id;
      EXPECT_LE(p.softMax, p.hardMax) << p.id;
      const auto checked = checkedParam(p, p.fallback);
      ASSERT_TRUE(checked) << p.id << ": " << checked.error().message;
      EXPECT_EQ(*checked, p.fallback) << p.id;
      const auto parsed = parseParam(p, formatParam(p, p.fallback));
      ASSERT_TRUE(parsed) << p.id << ": " << parsed.error().message;
      EXPECT_EQ(*parsed, p.fallback) << p.id;
    }
    names.clear();
    for (const SocketSpec& s : type.outputs) {
      EXPECT_TRUE(names.insert(s.id).second) << s.id;
      EXPECT_FALSE(s.label.empty() || s.help.empty()) << s.id;
      EXPECT_TRUE(s.read) << s.id;
    }
  }
  EXPECT_EQ(findNodeType("no.such"), nullptr);
}

TEST(Registry, DefaultsAreThoseOfTheStoredList) {
  // A changed default changes pictures of files that do not write it: it needs a migration and a new format
  // version, then a new list.
  std::string list;
  for (const NodeType& type : allNodeTypes())
    for (const ParamSpec& p : type.params)
      list += type.id + "." + p.id + " = " + formatParam(p, p.fallback) + "\n";
  EXPECT_EQ(fileText("tests/unit/nodes/defaults.txt"), list);
}

TEST(Registry, TheNodeReferenceIsCurrent) {
  EXPECT_EQ(fileText("docs/nodes.md"), nodesMarkdown()) << "run: pileus nodes --markdown > docs/nodes.md";
}

TEST(Registry, EveryParameterIsInEveryListing) {
  const std::string text = nodesText(), markdown = nodesMarkdown(), json = nodesJson();
  for (const NodeType& type : allNodeTypes()) {
    for (const std::string* listing : {&text, &markdown, &json})
      EXPECT_NE(listing->find(type.id), std::string::npos) << type.id;
    for (const ParamSpec& p : type.params) {
      EXPECT_NE(text.find(p.id), std::string::npos) << p.id;
      EXPECT_NE(markdown.find("`" + p.id + "`"), std::string::npos) << p.id;
      EXPECT_NE(json.find("\"id\": \"" + p.id + "\""), std::string::npos) << p.id;
    }
  }
}

ParamSpec spec(ParamType type, double low = -10, double high = 10) {
  ParamSpec s;
  s.id = "p";
  s.type = type;
  s.hardMin = low, s.hardMax = high;
  if (type == ParamType::Enum) s.choices = {{"one", "One", ""}, {"two", "Two", ""}};
  return s;
}

std::string problem(ParamType type, const ParamValue& value) {
  const auto checked = checkedParam(spec(type), value);
  return checked ? "" : checked.error().message;
}

TEST(CheckedParam, ConvertsWhatIsMeantAndRefusesTheRestInWords) {
  EXPECT_EQ(*checkedParam(spec(ParamType::Float), 3), ParamValue(3.0));
  EXPECT_EQ(*checkedParam(spec(ParamType::Int), 3.0), ParamValue(3));
  EXPECT_EQ(*checkedParam(spec(ParamType::Color), 0.5), ParamValue(dvec3(0.5)));
  EXPECT_EQ(problem(ParamType::Float, 120.0), "120 is outside -10..10");
  EXPECT_EQ(problem(ParamType::Int, -11), "-11 is outside -10..10");
  EXPECT_EQ(problem(ParamType::Int, 2.5), "2.5 is not a whole number");
  EXPECT_EQ(problem(ParamType::Int, 1e20), "1e+20 is not a whole number");
  EXPECT_EQ(problem(ParamType::Vector, dvec3(0, 11, 0)), "y = 11 is outside -10..10");
  EXPECT_EQ(problem(ParamType::Color, dvec3(0, 11, 0)), "g = 11 is outside -10..10");
  EXPECT_EQ(problem(ParamType::Enum, std::string("three")), "'three' is not one of one, two");
  EXPECT_EQ(problem(ParamType::Bool, 1), "1 is not true or false");
  EXPECT_EQ(problem(ParamType::Text, 1.5), "1.5 is not a text");
  EXPECT_NE(problem(ParamType::Float, std::nan("")), "");
  EXPECT_NE(problem(ParamType::Vector, dvec3(0, HUGE_VAL, 0)), "");
  EXPECT_NE(problem(ParamType::Text, std::string("a\0b", 3)), "");
}

TEST(ParseParam, ReadsCommandLineText) {
  EXPECT_EQ(*parseParam(spec(ParamType::Float), " +0.5 "), ParamValue(0.5));
  EXPECT_EQ(*parseParam(spec(ParamType::Float), "1e-3"), ParamValue(0.001));
  for (const auto text : {"1 2 3", "1,2,3", "[1, 2, 3]", "( 1;2 ;3 )"})
    EXPECT_EQ(*parseParam(spec(ParamType::Vector), text), ParamValue(dvec3(1, 2, 3))) << text;
  EXPECT_EQ(*parseParam(spec(ParamType::Vector), "2"), ParamValue(dvec3(2)));
  EXPECT_EQ(*parseParam(spec(ParamType::Bool), "on"), ParamValue(true));
  EXPECT_EQ(*parseParam(spec(ParamType::Enum), "two"), ParamValue(std::string("two")));
  EXPECT_EQ(*parseParam(spec(ParamType::File), "a b.vdb"), ParamValue(std::string("a b.vdb")));
  for (const auto text : {"", "abc", "1.5x", "nan", "inf", "1e999", "0x10", "1 2"})
    EXPECT_FALSE(parseParam(spec(ParamType::Float), text)) << text;
  for (const auto text : {"", "1 2", "1 2 3 4", "a b c"})
    EXPECT_FALSE(parseParam(spec(ParamType::Vector), text)) << text;
  EXPECT_FALSE(parseParam(spec(ParamType::Bool), "maybe"));
  EXPECT_FALSE(parseParam(spec(ParamType::Int), "1.5"));
}

TEST(FormatNumber, IsShortestAndReadsBack) {
  EXPECT_EQ(formatNumber(0.1), "0.1");
  EXPECT_EQ(formatNumber(25), "25");
  EXPECT_EQ(formatNumber(-0.0), "0");
  EXPECT_EQ(labelFromId("step_scale"), "Step scale");
}

TEST(Animation, FollowsItsKeys) {
  using I = Interpolation;
  const Animation a{
      {{10, 1.0, I::Linear}, {20, 3.0, I::Smooth}, {30, 5.0, I::Constant}, {40, 9.0, I::Linear}}};
  EXPECT_EQ(valueAt(a, 0), ParamValue(1.0));
  EXPECT_EQ(valueAt(a, 15), ParamValue(2.0));
  EXPECT_EQ(valueAt(a, 20), ParamValue(3.0));
  EXPECT_DOUBLE_EQ(std::get<double>(valueAt(a, 22.5)), 3.0 + 2.0 * 0.15625);
  EXPECT_EQ(valueAt(a, 39), ParamValue(5.0));
  EXPECT_EQ(valueAt(a, 99), ParamValue(9.0));
  EXPECT_EQ(valueAt(Animation{{{0, 0, I::Linear}, {10, 5, I::Linear}}}, 5), ParamValue(3));
  EXPECT_EQ(valueAt(Animation{{{0, std::string("a"), I::Linear}, {9, std::string("b"), I::Linear}}}, 8),
            ParamValue(std::string("a")));
}

}  // namespace
}  // namespace pileus::nodes
