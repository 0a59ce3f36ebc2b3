// Shadow nodes read as a spec and written back.
#include <gtest/gtest.h>

#include "nodes/file/serialize.h"
#include "nodes/shadows/shadow_spec_nodes.h"
#include "nodes/types/shadow_common.h"

namespace pileus::nodes {
namespace {

using shadow::ShadowSpec;
using Kind = ShadowSpec::Kind;

/// A sun through a shadow of `type` ("shadow.extinction" with a pseudometric) into a render node.
Graph lit(const std::string& type) {
  Graph g;
  const auto add = [&](const char* id, const char* name) { g = addNode(g, id, {0, 0}, name).value(); };
  const auto link = [&](const char* from, const char* out, const char* to, const char* in) {
    g = connect(g, {from, out, to, in}).value();
  };
  add("volume.box", "Box");
  add("light.sun", "Sun");
  add("render.volume", "Render");
  g = addNode(g, type, {0, 0}, "Shadow").value();
  if (type == "shadow.extinction") {
    add("shadow.pseudometric", "Metric");
    link("Sun", "light", "Metric", "light");
    link("Box", "volume", "Metric", "volumes");
    link("Metric", "metric", "Shadow", "metric");
  } else {
    link("Sun", "light", "Shadow", "light");
    link("Box", "volume", "Shadow", "volumes");
  }
  link("Shadow", "light", "Render", "lights");
  return g;
}

/// Something other than the default in every member that `kind` has.
ShadowSpec unusual(Kind kind) {
  ShadowSpec s;
  s.kind = kind;
  switch (kind) {
    case Kind::Extinction:
      s.metric = {shadow::Metric::Interval, 8,   6,   640, shadow::Storage::Half, shadow::Coverage::Boxes,
                  shadow::Weighting::Root,  6.0, true};
      s.extinction = {shadow::Basis::Piecewise,    20,  640, shadow::Storage::Float,
                      shadow::Accumulation::Splat, true};
      break;
    case Kind::FourierOpacity:
      s.coefficients = 11, s.range = true, s.damping = true, s.storage = shadow::Storage::Float,
      s.resolution = 256;
      break;
    case Kind::TransmittanceFunction:
      s.coefficients = 15, s.basis = shadow::Basis::Cosine, s.storage = shadow::Storage::Float,
      s.resolution = 256;
      break;
    case Kind::Deep:
      s.errorBound = 0.004, s.nodeBudget = 32, s.filter = 2, s.resolution = 256;
      break;
    case Kind::RayMarch:
      s.stepScale = 0.25;
      break;
  }
  return s;
}

const std::pair<Kind, const char*> kTypes[] = {{Kind::Extinction, "shadow.extinction"},
                                               {Kind::FourierOpacity, "shadow.fourier_opacity"},
                                               {Kind::TransmittanceFunction, "shadow.transmittance_function"},
                                               {Kind::Deep, "shadow.deep"},
                                               {Kind::RayMarch, "shadow.ray_march"}};

TEST(ShadowSpecNodes, EveryKindComesBackFromAFile) {
  for (const auto& [kind, type] : kTypes) {
    const Graph graph = lit(type);
    const auto before = shadowsOf(graph, "Render");
    ASSERT_EQ(before.size(), 1u) << type;
    EXPECT_EQ(before[0].node, "Shadow");
    EXPECT_EQ(before[0].metric, kind == Kind::Extinction ? "Metric" : "");
    EXPECT_EQ(before[0].spec.kind, kind);
    const ShadowSpec spec = unusual(kind);
    const auto written = writeShadow(graph, before[0], spec);
    ASSERT_TRUE(written) << type << ": " << written.error().message;
    const auto loaded = parseGraph(graphText(*written));
    ASSERT_TRUE(loaded);
    EXPECT_TRUE(loaded->faults.empty()) << type;
    const auto after = shadowsOf(loaded->graph, "Render");
    ASSERT_EQ(after.size(), 1u);
    EXPECT_EQ(after[0].spec, spec) << type << ": " << shadow::describe(after[0].spec);
    // Parameters alone: taking them back gives the graph as it was.
    const auto restored = writeShadow(loaded->graph, after[0], before[0].spec);
    ASSERT_TRUE(restored) << restored.error().message;
    EXPECT_EQ(graphText(*restored), graphText(graph)) << type;
  }
}

TEST(ShadowSpecNodes, ADefaultNodeIsADefaultSpec) {
  for (const auto& [kind, type] : kTypes) {
    ShadowSpec expected;
    expected.kind = kind;
    if (kind == Kind::Extinction) {  // the nodes come as the knee of docs/bench.md
      const auto fallback = [](const char* type_, const char* param) {
        return findNodeType(type_)->param(param)->fallback;
      };
      const auto metric = [&](const char* param) { return fallback("shadow.pseudometric", param); };
      expected.metric.weighting = *enumFromId<shadow::Weighting>(std::get<std::string>(metric("weighting")));
      expected.metric.horizon = std::get<double>(metric("horizon"));
      expected = shadow::withResolution(expected, std::get<int>(metric("resolution")));
      expected.resolution = ShadowSpec().resolution;
      expected.extinction.coefficients = std::get<int>(fallback(type, "coefficients"));
      expected.extinction.storage =
          *enumFromId<shadow::Storage>(std::get<std::string>(fallback(type, "storage")));
    }
    EXPECT_EQ(readShadow(lit(type), "Shadow")->spec, expected) << type;
  }
}

TEST(ShadowSpecNodes, AnExtinctionMapWithoutAMetricIsEuclidean) {
  Graph graph = lit("shadow.extinction");
  graph = removeNodes(graph, {"Metric"});
  const ShadowNodes found = readShadow(graph, "Shadow").value();
  EXPECT_EQ(found.metric, "");
  EXPECT_EQ(found.spec.metric.metric, shadow::Metric::None);
  EXPECT_EQ(found.spec.extinction.resolution, 1024);
  ShadowSpec spec = found.spec;
  spec.extinction.coefficients = 16;
  spec.extinction.resolution = 256;
  const Graph written = writeShadow(graph, found, spec).value();
  EXPECT_EQ(readShadow(written, "Shadow")->spec.extinction, spec.extinction);
  spec.metric.metric = shadow::Metric::Interval;
  EXPECT_FALSE(writeShadow(graph, found, spec));
  EXPECT_FALSE(writeShadow(lit("shadow.extinction"), {"Shadow", "Metric", {}}, found.spec));
}

TEST(ShadowSpecNodes, OnlyShadowsThatReachThePictureAreFound) {
  Graph graph = lit("shadow.extinction");
  EXPECT_TRUE(shadowsOf(setMuted(graph, {"Shadow", "light", "Render", "lights"}, true), "Render").empty());
  EXPECT_TRUE(shadowsOf(setBypass(graph, {"Shadow"}, true), "Render").empty());
  EXPECT_TRUE(shadowsOf(graph, "Nobody").empty());
  EXPECT_FALSE(readShadow(graph, "Sun"));
  EXPECT_FALSE(readShadow(graph, "Nobody"));
}

TEST(ShadowSpecNodes, RefusesAnotherKindAndValuesOutOfRange) {
  const Graph graph = lit("shadow.extinction");
  const ShadowNodes shadow = readShadow(graph, "Shadow").value();
  ShadowSpec spec = shadow.spec;
  spec.kind = Kind::Deep;
  EXPECT_FALSE(writeShadow(graph, shadow, spec));
  spec = shadow.spec;
  spec.extinction.coefficients = 33;
  const auto refused = writeShadow(graph, shadow, spec);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::Arguments);
  EXPECT_NE(refused.error().message.find("Shadow.coefficients"), std::string::npos)
      << refused.error().message;
}

TEST(ShadowSpecs, DraftsOfCoarseMapsAreCoarserStill) {
  EXPECT_EQ(draftTexelsOf(384, 128), 128);
  EXPECT_EQ(draftTexelsOf(1024, 128), 128) << "a finer map makes no finer draft";
  EXPECT_EQ(draftTexelsOf(128, 128), 42) << "in proportion";
  EXPECT_EQ(draftTexelsOf(128, 48), 24) << "but never so few that light has no direction";
  EXPECT_EQ(draftTexelsOf(16, 128), 16);
  EXPECT_EQ(draftTexelsOf(384, 12), 12);
}

}  // namespace
}  // namespace pileus::nodes
