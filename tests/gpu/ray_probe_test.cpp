// The ray probe: exact where there is an exact answer, the map's own texel on the CPU as on the GPU, and its
// flags in words.
#include "renderer/truth/ray_probe.h"

#include <algorithm>
#include <cmath>

#include "renderer/shadow/metric.h"
#include "renderer/shadow/reference.h"
#include "renderer/shadow/shadow_pass.h"
#include "renderer/view/visible_point.h"
#include "tests/support/gpu.h"

namespace pileus {
namespace {

using shadow::ShadowSpec;

/// Two boxes above each other, the sun straight above: x runs down.
volume::InstanceList twoBoxes() {
  return {test::box(dvec3(0, 2, 0), dvec3(2, 1, 2), 0.8), test::box(dvec3(0, -2, 0), dvec3(2, 0.5, 2), 3)};
}

const scene::Light& noon() {
  static const scene::Light sun = test::sunFrom(dvec3(0, 1, 0));
  return sun;
}

truth::RayProbe probeOf(const ShadowSpec& spec, const volume::InstanceList& volumes, const dvec3& point,
                        const scene::Light& light = noon()) {
  const auto map = shadow::buildShadow(test::renderer().gpu(), spec, light, volumes);
  EXPECT_TRUE(map) << map.error().message;
  auto probe = truth::probeRay(test::renderer().gpu(), {light, *map}, point);
  EXPECT_TRUE(probe) << probe.error().message;
  return *probe;
}

ShadowSpec improved(int intervals, int coefficients, int resolution = 64) {
  ShadowSpec spec;
  spec.metric.intervals = intervals;
  spec.metric.resolution = spec.extinction.resolution = resolution;
  spec.extinction.coefficients = coefficients;
  return spec;
}

bool flagged(const truth::RayProbe& probe, const std::string& part) {
  for (const truth::RayFlag& f : truth::rayFlags(probe))
    if (f.text.find(part) != std::string::npos) return true;
  return false;
}

std::string allFlags(const truth::RayProbe& probe) {
  std::string out;
  for (const truth::RayFlag& f : truth::rayFlags(probe)) out += f.text + " ";
  return out;
}

TEST(RayProbe, TwoBoxesAreExact) {
  const truth::RayProbe p = probeOf(improved(4, 8), twoBoxes(), dvec3(0.1, -2, 0.2));
  ASSERT_EQ(p.parts.size(), 2u);
  ASSERT_EQ(p.covered.size(), 2u);
  EXPECT_EQ(p.parts[0].name, "Box 1");
  EXPECT_EQ(p.parts[1].name, "Box 2");
  const double top = p.from.y;
  // Parts are in the order of the shadow's volumes, which is that of their content.
  std::vector<truth::RayPart> parts = p.parts;
  std::sort(parts.begin(), parts.end(), [](const auto& l, const auto& r) { return l.from < r.from; });
  EXPECT_NEAR(p.metres(parts[0].from), top - 2.5, 1e-9);
  EXPECT_NEAR(p.metres(parts[0].to), top - 1.5, 1e-9);
  EXPECT_NEAR(p.metres(parts[1].from), top + 1.75, 1e-9);
  EXPECT_NEAR(p.metres(parts[1].to), top + 2.25, 1e-9);
  EXPECT_NEAR(p.metres(p.pointX), top + 2, 1e-9);
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    const double y = top - p.metres(p.x[i]);
    const double tau = 0.8 * std::clamp(2.5 - y, 0.0, 1.0) + 3 * std::clamp(-1.75 - y, 0.0, 0.5);
    ASSERT_NEAR(p.exact[i], std::exp(-tau), 1e-9) << "at y " << y;
    // g: 1 of 1.5 metres in the upper box, a plateau over the gap.
    const double g = (std::clamp(2.5 - y, 0.0, 1.0) + std::clamp(-1.75 - y, 0.0, 0.5)) / 1.5;
    ASSERT_NEAR(p.u[i], g, 1e-4) << "at y " << y;
  }
  EXPECT_LT(p.maxError, 0.2);
  EXPECT_GT(p.meanError, 0);
  EXPECT_FALSE(flagged(p, "merged")) << allFlags(p);
  EXPECT_FALSE(flagged(p, "horizon"));
}

/// Closed form of technique: two boxes of lengths 1 and 0.5, c_0 = s1 L1 + s2 L2, c_k = 2 (s1 - s2)(L1 + L2)
/// sin(pi k q)/(pi k).
TEST(RayProbe, CoefficientsAndTheirMutingFollowTheSeries) {
  const truth::RayProbe p = probeOf(improved(4, 8), twoBoxes(), dvec3(0.1, -2, 0.2));
  ASSERT_EQ(p.taps.taps.size(), 1u);
  const std::vector<double>& c = p.taps.taps[0].coefficients;
  ASSERT_EQ(c.size(), 8u);
  const double q = 1 / 1.5;
  std::vector<double> expected{0.8 + 1.5};
  for (int k = 1; k < 8; ++k) expected.push_back(2 * (0.8 - 3) * 1.5 * std::sin(kPi * k * q) / (kPi * k));
  for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(c[k], expected[k], 2e-3) << "c" << k;
  for (const std::size_t mute : {std::size_t(1), std::size_t(4)}) {
    std::vector<char> muted(8, 0);
    muted[mute] = 1;
    const std::vector<double> T = truth::mutedTransmittance(p, muted);
    for (std::size_t i = 0; i < p.x.size(); ++i) {
      double tau = c[0] * p.u[i];
      for (std::size_t k = 1; k < 8; ++k)
        if (k != mute) tau += c[k] * std::sin(kPi * double(k) * p.u[i]) / (kPi * double(k));
      ASSERT_NEAR(T[i], std::exp(-std::clamp(tau, 0.0, c[0])), 1e-9)
          << "without c" << mute << " at " << p.x[i];
    }
    const truth::ExtinctionOverU over = truth::extinctionOverU(p, muted);
    for (std::size_t i = 0; i < over.u.size(); ++i) {
      double sigma = c[0];
      for (std::size_t k = 1; k < 8; ++k)
        if (k != mute) sigma += c[k] * std::cos(kPi * double(k) * over.u[i]);
      ASSERT_NEAR(over.mapped[i], sigma, 1e-9);
    }
  }
  // Exact extinction over g: two plateaus, 0.8 and 3 per metre over 1.5 metres.
  const truth::ExtinctionOverU over = truth::extinctionOverU(p);
  EXPECT_NEAR(over.exact[64], 0.8 * 1.5, 0.05);
  EXPECT_NEAR(over.exact[210], 3 * 1.5, 0.15);
}

/// The CPU's evaluation of the texels is the shader's, for every kind of map and at texel centres and between
/// them.
TEST(RayProbe, TheTexelsSayWhatTheLookupSays) {
  std::vector<ShadowSpec> specs{improved(4, 8), improved(1, 8), improved(8, 16)};
  specs[1].metric.storage = specs[1].extinction.storage = shadow::Storage::Half;
  specs[2].metric.weighting = shadow::Weighting::Root;
  specs[2].metric.horizon = 1.2;
  for (const shadow::Metric metric :
       {shadow::Metric::Cosine, shadow::Metric::Fourier, shadow::Metric::None}) {
    specs.push_back(improved(4, 9));
    specs.back().metric.metric = metric;
    specs.back().extinction.basis =
        metric == shadow::Metric::None ? shadow::Basis::Fourier : shadow::Basis::Slab;
  }
  specs.push_back(improved(4, 12));
  specs.back().extinction.basis = shadow::Basis::Piecewise;
  specs.push_back(improved(2, 8));
  specs.back().extinction.basis = shadow::Basis::Piecewise;
  specs.back().metric.compact = true;
  for (const auto kind : {ShadowSpec::Kind::FourierOpacity, ShadowSpec::Kind::TransmittanceFunction}) {
    ShadowSpec spec;
    spec.kind = kind;
    spec.resolution = 64;
    spec.range = kind == ShadowSpec::Kind::FourierOpacity;
    specs.push_back(spec);
  }
  volume::InstanceList volumes = twoBoxes();
  volumes.push_back(test::ball(dvec3(0.8, 0.2, 0.1), 0.5, 2));
  for (const ShadowSpec& spec : specs)
    for (const dvec3& point : {dvec3(0.1, -2, 0.2), dvec3(0.83, -1.9, -0.13), dvec3(0.313, -2, 0.1)}) {
      const truth::RayProbe p = probeOf(spec, volumes, point);
      double worst = 0;
      for (std::size_t i = 0; i < p.x.size(); ++i)
        if (p.x[i] > 1e-3)
          worst = std::max(worst, std::abs(p.mapped[i] - shadow::tapsTransmittance(*p.map, p.taps, p.x[i])));
      // llvmpipe blends texels of 8 bits in 8 bits: the ends of compact metrics may be off by half a 255th.
      EXPECT_LT(worst, spec.metric.compact ? 5e-3 : 1e-4)
          << shadow::describe(spec) << ", taps " << p.taps.taps.size();
    }
}

/// Integrated over u the series' extinction is its optical depth, whatever the basis.
TEST(RayProbe, ExtinctionOverUIntegratesToTheOpticalDepth) {
  for (const shadow::Basis basis :
       {shadow::Basis::Cosine, shadow::Basis::Fourier, shadow::Basis::Slab, shadow::Basis::Piecewise}) {
    ShadowSpec spec = improved(4, 8);
    spec.extinction.basis = basis;
    const truth::RayProbe p = probeOf(spec, twoBoxes(), dvec3(0.1, -2, 0.2));
    const truth::ExtinctionOverU e = truth::extinctionOverU(p, {}, 4096);
    double mapped = 0, exact = 0;
    for (std::size_t i = 0; i < e.u.size(); ++i) mapped += e.mapped[i] / 4096, exact += e.exact[i] / 4096;
    EXPECT_NEAR(exact, 0.8 + 1.5, 1e-6);
    EXPECT_NEAR(mapped, 0.8 + 1.5, 2e-3) << shadow::describe(spec);
  }
}

TEST(RayProbe, FlagsSayWhatIsWrong) {
  // Euclidean Fourier: rises in the gap, negative extinction.
  ShadowSpec fourier;
  fourier.kind = ShadowSpec::Kind::FourierOpacity;
  fourier.coefficients = 7;
  fourier.resolution = 64;
  const truth::RayProbe f = probeOf(fourier, twoBoxes(), dvec3(0.1, -2, 0.2));
  double low = 2, rise = 0;
  for (const double t : f.mapped) low = std::min(low, t), rise = std::max(rise, t - low);
  std::printf("Fourier opacity 7: %s\n", allFlags(f).c_str());
  EXPECT_TRUE(flagged(f, fmt::format("Transmittance rises by {:.2g} between", rise))) << allFlags(f);
  EXPECT_TRUE(flagged(f, "Extinction is negative on")) << allFlags(f);
  EXPECT_FALSE(flagged(f, "merged"));

  // Five boxes in four intervals.
  volume::InstanceList five;
  for (int i = 0; i < 5; ++i) five.push_back(test::box(dvec3(0, 4 - 2 * i, 0), dvec3(1, 0.5, 1), 1));
  const truth::RayProbe m = probeOf(improved(4, 8), five, dvec3(0.1, -4, 0.1));
  EXPECT_TRUE(flagged(m, "5 intervals are merged into 4.")) << allFlags(m);
  EXPECT_FALSE(flagged(probeOf(improved(8, 8), five, dvec3(0.1, -4, 0.1)), "merged"));

  // A horizon in the second of three dense boxes.
  volume::InstanceList dense;
  for (int i = 0; i < 3; ++i) dense.push_back(test::box(dvec3(0, 3 - 3 * i, 0), dvec3(1, 1, 1), 4));
  ShadowSpec spec = improved(4, 8);
  spec.metric.horizon = 6;
  const truth::RayProbe h = probeOf(spec, dense, dvec3(0.1, -3, 0.1));
  std::printf("dense: %s\n", allFlags(h).c_str());
  EXPECT_TRUE(flagged(h, "The horizon hides an optical depth of")) << allFlags(h);

  ShadowSpec march;
  march.kind = ShadowSpec::Kind::RayMarch;
  const truth::RayProbe r = probeOf(march, twoBoxes(), dvec3(0.1, -2, 0.2));
  EXPECT_TRUE(r.mapped.empty());
  EXPECT_TRUE(flagged(r, "Marched in steps of 0.5 voxels")) << allFlags(r);
}

TEST(RayProbe, DeepMapsShowTheirVertices) {
  ShadowSpec deep;
  deep.kind = ShadowSpec::Kind::Deep;
  deep.resolution = 64;
  const truth::RayProbe p = probeOf(deep, twoBoxes(), dvec3(0.1, -2, 0.2));
  ASSERT_GE(p.taps.vertices.size(), 4u);
  EXPECT_TRUE(p.taps.taps.empty());
  for (std::size_t i = 1; i < p.taps.vertices.size(); ++i)
    EXPECT_GT(p.taps.vertices[i].x, p.taps.vertices[i - 1].x);
  EXPECT_LT(p.maxError, deep.errorBound + 1e-3);
  EXPECT_TRUE(flagged(p, fmt::format("{} vertices keep V within 0.01", p.taps.vertices.size())))
      << allFlags(p);
}

TEST(RayProbe, PointLightsBeginAtTheirNearDistance) {
  scene::Light lamp;
  lamp.kind = scene::LightKind::Point;
  lamp.position = dvec3(0, 5, 0);
  lamp.emitted = vec3(100);
  const truth::RayProbe p = probeOf(improved(4, 8), twoBoxes(), dvec3(0.1, -2, 0.2), lamp);
  const double distance = glm::length(dvec3(0.1, -2, 0.2) - lamp.position);
  EXPECT_NEAR(p.metres(p.pointX), distance, 1e-6);
  EXPECT_NEAR(truth::mutedTransmittance(p, {}).front(), 1, 1e-6);
  double at = 0;
  for (std::size_t i = 0; i < p.x.size(); ++i)
    if (p.x[i] <= p.pointX) at = p.exact[i];
  EXPECT_NEAR(at, std::exp(-shadow::opticalDepthToLight(twoBoxes(), lamp, dvec3(0.1, -2, 0.2))), 0.02);
  EXPECT_LT(p.maxError, 0.2);
}

TEST(RayProbe, AnUnshadowedLightIsRefused) {
  const auto probe = truth::probeRay(test::renderer().gpu(), {noon(), nullptr}, dvec3(0));
  ASSERT_FALSE(probe);
  EXPECT_NE(probe.error().message.find("no shadow"), std::string::npos);
}

TEST(VisiblePoint, HalfOfWhatIsSeenLiesInFront) {
  view::RenderScene scene;
  scene.options.size = {100, 100};
  scene.options.camera = {dvec3(0, 0, 5), dvec3(0), dvec3(0, 1, 0), 40};
  scene.volumes = {test::box(dvec3(0, 0, 0), dvec3(2, 2, 2), 1.5)};
  const auto p = view::visiblePoint(scene, dvec2(0.5));
  ASSERT_TRUE(p);
  // (1 - exp(-1.5 s)) = (1 - exp(-3)) / 2
  const double s = -std::log(1 - 0.5 * (1 - std::exp(-3.0))) / 1.5;
  EXPECT_NEAR(p->z, 1 - s, 3e-3);
  const auto uv = view::pictureUv(scene.options, *p);
  ASSERT_TRUE(uv);
  EXPECT_NEAR(uv->x, 0.5, 1e-9);
  EXPECT_NEAR(uv->y, 0.5, 1e-9);
  EXPECT_FALSE(view::visiblePoint(scene, dvec2(0.02))) << "nothing is seen at the corner";
  // A solid behind thin haze is what one sees.
  scene.volumes[0].medium.extinction = 0.1;
  scene.solids = {
      {scene::SolidShape::Box, composeTransform(dvec3(0, 0, -3), dvec3(0), dvec3(2)), vec3(0.5f)}};
  const auto solid = view::visiblePoint(scene, dvec2(0.5));
  ASSERT_TRUE(solid);
  EXPECT_NEAR(solid->z, -2, 1e-9);
}

}  // namespace
}  // namespace pileus
