// The genera of clouds as functions: pure, the same brick by brick, equal in the mean at every level of
// detail, inside their box.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "renderer/volume/cloud/cloud_field.h"

namespace pileus::volume {
namespace {

constexpr std::array kGenera = {Genus::Cumulus, Genus::Stratocumulus, Genus::Stratus, Genus::Cirrus};

CloudParams params(Genus genus, int resolution = 64) {
  CloudParams p;
  p.genus = genus;
  p.resolution = resolution;
  return p;
}

/// Calls `body(parameters)` for every genus, and for cumulus with anvils.
template <class Body>
void forGenera(const Body& body) {
  for (const Genus genus : kGenera) {
    SCOPED_TRACE(std::string(enumId(genus)));
    body(params(genus));
  }
  SCOPED_TRACE("anvil");
  CloudParams p = params(Genus::Cumulus);
  p.size = {3000, 1500, 3000};
  p.breadth = 0.7;
  p.anvil = 1.3;
  body(p);
}

std::unique_ptr<const CloudField> field(const CloudParams& p) {
  JobControl control;
  return cloudField(p, control);
}

GridPtr bake(const CloudParams& p) {
  JobControl control;
  auto r = bakeCloud(p, control);
  EXPECT_TRUE(r) << (r ? "" : r.error().message);
  return r ? *r : nullptr;
}

/// Metres cubed times density.
double mass(const BrickGrid& g) {
  double sum = 0;
  if (g.empty()) return 0;
  const ivec3 lo(g.indexBounds.min), hi(g.indexBounds.max);
  for (int z = lo.z; z <= hi.z; ++z)
    for (int y = lo.y; y <= hi.y; ++y)
      for (int x = lo.x; x <= hi.x; ++x) sum += static_cast<double>(voxelAt(g, {x, y, z}));
  return sum * std::pow(g.voxelSize, 3);
}

using Voxels = std::array<float, kBrickSize * kBrickSize * kBrickSize>;

TEST(CloudField, BricksAreTheFunctionOfAPosition) {
  forGenera([](CloudParams p) {
    p.time = 90;
    const auto f = field(p), again = field(p);
    const vec3 size(p.size);
    int filled = 0;
    for (const float voxel : {3.1f, 12.0f, 45.0f})
      for (int i = 0; i < 40; ++i) {
        const vec3 first = size * vec3(0.37f + 0.013f * static_cast<float>(i), 0.021f * static_cast<float>(i),
                                       0.9f - 0.021f * static_cast<float>(i));
        Voxels voxels;
        const bool any = f->brick(first, voxel, voxels.data());
        filled += any;
        for (int at = 0; at < kBrickSize * kBrickSize * kBrickSize; at += 31) {
          const ivec3 v(at % kBrickSize, at / kBrickSize % kBrickSize, at / kBrickSize / kBrickSize);
          const vec3 position = first + voxel * vec3(v);
          const float here = any ? voxels[static_cast<std::size_t>(at)] : 0.0f;
          ASSERT_EQ(here, again->density(position, voxel)) << position.x << " " << position.y << " " << voxel;
        }
      }
    EXPECT_GT(filled, 6);
  });
}

TEST(CloudField, EqualParametersGiveEqualVoxelsAndAnyOtherGivesOthers) {
  forGenera([](CloudParams p) {
    p.resolution = 48;
    const auto content = bake(p)->content;
    EXPECT_EQ(bake(p)->content, content);
    const auto differs = [&](auto change) {
      CloudParams other = p;
      change(other);
      return bake(other)->content != content;
    };
    EXPECT_TRUE(differs([](CloudParams& o) { o.seed = 2; }));
    EXPECT_TRUE(differs([](CloudParams& o) { o.base = 0.3; }));
    EXPECT_TRUE(differs([](CloudParams& o) { o.top = 0.7; }));
    EXPECT_TRUE(differs([](CloudParams& o) { o.coverage = 0.6; }));
    EXPECT_TRUE(differs([](CloudParams& o) { o.breadth = 1.1; }));
    EXPECT_TRUE(differs([](CloudParams& o) { o.wisp = 0; }));
    EXPECT_TRUE(differs([](CloudParams& o) { o.billow = 0.2; }));
    EXPECT_TRUE(differs([](CloudParams& o) { o.age = 0.9; }));
    EXPECT_TRUE(differs([](CloudParams& o) { o.shear = 0.5; }));
    EXPECT_TRUE(differs([](CloudParams& o) { o.time = 120; }));
  });
}

/// Heaps of 480 m in voxels of 8 to 25 m; layers of 480 m and cirrus likewise.
TEST(CloudField, LevelsOfDetailHoldTheSameMass) {
  forGenera([](CloudParams p) {
    p.resolution = 192;
    const double fine = mass(*bake(p));
    ASSERT_GT(fine, 0);
    p.resolution = 96;
    EXPECT_NEAR(mass(*bake(p)) / fine, 1.0, 0.01);
    p.resolution = 64;
    EXPECT_NEAR(mass(*bake(p)) / fine, 1.0, 0.02);
  });
}

TEST(CloudField, NothingIsOutsideTheBox) {
  forGenera([](CloudParams p) {
    for (const double coverage : {0.4, 1.0})
      for (const double shear : {-10.0, 0.2, 10.0}) {
        p.coverage = coverage;
        p.shear = shear;
        p.base = 0;
        p.top = 1;
        p.time = 333;
        const auto f = field(p);
        const vec3 size(p.size);
        for (int i = 0; i < 4000; ++i) {
          const float u = static_cast<float>(i) / 4000.0f, v = 0.618034f * static_cast<float>(i);
          const float w = v - std::floor(v);
          for (const vec3 at :
               {vec3(0, u, w), vec3(1, u, w), vec3(u, 0, w), vec3(u, 1, w), vec3(u, w, 0), vec3(u, w, 1)}) {
            ASSERT_EQ(f->density(at * size + (at - 0.5f) * 0.01f, 10), 0);
            ASSERT_EQ(f->density(at * size + (at - 0.5f) * size, 10), 0);
          }
        }
      }
  });
}

TEST(CloudField, BasesAreLevelAndTopsWhereTheyAreSaid) {
  CloudParams p = params(Genus::Cumulus, 128);
  p.base = 0.3;
  const auto g = bake(p);
  const Box3 world = transformed(g->indexBounds, g->worldFromIndex);
  EXPECT_NEAR(world.min.y, 0.3 * 600, 2.5 * g->voxelSize);
  EXPECT_LT(world.max.y, 0.9 * 600 + 40);
  EXPECT_GT(world.max.y, 0.9 * 600 - 140);
}

TEST(CloudField, CoverageIsTheCoveredPartOfTheGround) {
  for (const Genus genus : kGenera) {
    SCOPED_TRACE(std::string(enumId(genus)));
    double last = -1;
    for (const double coverage : {0.0, 0.1, 0.3, 0.6, 0.9}) {
      CloudParams p = params(genus, 96);
      p.coverage = coverage;
      p.size = {4000, 600, 4000};
      const auto f = field(p);
      int under = 0;
      for (int z = 0; z < 60; ++z)
        for (int x = 0; x < 60; ++x) {
          double column = 0;  // optical depth
          for (int y = 0; y < 30; ++y)
            column += 20.0 * static_cast<double>(f->density({20.0f + 66.0f * static_cast<float>(x),
                                                             10.0f + 20.0f * static_cast<float>(y),
                                                             20.0f + 66.0f * static_cast<float>(z)},
                                                            20.0f));
          under += column > 0.6;
        }
      const double covered = under / 3600.0;
      if (genus != Genus::Cirrus) {
        EXPECT_NEAR(covered, coverage, 0.08 + 0.2 * coverage);  // they keep off the walls
      }
      EXPECT_GE(covered, last);
      last = covered;
    }
    EXPECT_GT(last, 0.3);
  }
}

TEST(CloudField, TheEndsOfAllParametersWork) {
  forGenera([](CloudParams p) {
    p.resolution = 24;
    for (const double end : {0.0, 1.0})
      for (const dvec3 size : {dvec3(1), dvec3(1e5, 2000, 1e5), dvec3(10, 5000, 10), dvec3(1e6, 1e-3, 1),
                               dvec3(1e6, 1, 1e6), dvec3(1e-3)}) {
        CloudParams q = p;
        q.size = size;
        q.age = q.wisp = q.detail = q.coverage = end;
        q.billow = 1 - end;
        q.breadth = end > 0 ? 100 : 0.05;
        q.anvil = 2 * end;
        q.shear = end > 0 ? 10 : -10;
        q.wind = 200;
        q.time = end > 0 ? 1e6 : -1e6;
        const auto g = bake(q);
        EXPECT_TRUE(std::isfinite(g->maximum));
        EXPECT_GE(g->minimum, 0);
      }
    // A metre and a hundred kilometres: at their usual parameters there is a cloud.
    for (const dvec3 size : {dvec3(1, 0.4, 1), dvec3(1e5, 3000, 1e5)}) {
      CloudParams q = p;
      q.size = size;
      q.resolution = 96;
      EXPECT_FALSE(bake(q)->empty()) << size.x;
    }
  });
}

TEST(CloudField, AgeThinsAndTheWindCarries) {
  CloudParams p = params(Genus::Cumulus);
  const double grown = mass(*bake(p));
  p.age = 1;
  EXPECT_LT(mass(*bake(p)), 0.8 * grown);
  p.age = 0;
  EXPECT_LT(mass(*bake(p)), 0.8 * grown);
  p = params(Genus::Stratocumulus);
  p.coverage = 0.7;
  const auto still = field(p);
  p.wind = 10;
  p.time = 1;
  const auto carried = field(p);
  const vec3 at(700, 250, 800);  // bubbles turn over in minutes
  EXPECT_NEAR(carried->density(at + vec3(10, 0, 0), 10), still->density(at, 10), 0.004f);
}

TEST(CloudField, ATopBelowTheBaseIsNamed) {
  JobControl control;
  CloudParams p = params(Genus::Cumulus);
  p.top = 0.05;
  const auto r = bakeCloud(p, control);
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().code, Code::Arguments);
  EXPECT_NE(r.error().message.find("top is 0.05"), std::string::npos) << r.error().message;
}

/// As they were before there were genera.
TEST(CloudField, ClassicCloudsKeepTheirVoxels) {
  CloudParams p = params(Genus::Classic);
  EXPECT_EQ(bake(p)->content.hex(), "d2441312966f44e38c33b6ab00e4a5c0");
  p.resolution = 48;
  p.seed = 7;
  p.coverage = 0.6;
  p.detail = 0.8;
  p.billow = 0.3;
  p.shear = -0.4;
  p.size = dvec3(3200, 640, 2000);
  EXPECT_EQ(bake(p)->content.hex(), "d9aca0f40a4138d2fb502bf298316410");
}

TEST(CloudField, CancelStopsSoonWhateverTheGenus) {
  forGenera([](CloudParams p) {
    p.resolution = 1024;
    p.coverage = 1;
    JobControl control;
    control.cancel();
    const auto r = bakeCloud(p, control);
    ASSERT_FALSE(r);
    EXPECT_EQ(r.error().code, Code::Cancelled);
  });
}

}  // namespace
}  // namespace pileus::volume
