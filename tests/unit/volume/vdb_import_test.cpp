// VDB files through the import child: real files against OpenVDB's own samplers, and everything that must be
// refused.
#include "renderer/volume/vdb_import.h"

#include <gtest/gtest.h>
#include <openvdb/io/File.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Interpolation.h>

#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include "renderer/base/file.h"
#include "renderer/volume/brick_builder.h"
#include "renderer/volume/grid_guess.h"
#include "renderer/volume/vdb_child.h"
#include "tests/support/support.h"

namespace fs = std::filesystem;

namespace pileus::volume {
namespace {

Result<ImportedGrid> import(const fs::path& path, const std::string& grid = "",
                            const ImportLimits& limits = {}) {
  JobControl control;
  return importVdb(path, grid, control, limits);
}

void expectInputError(const fs::path& path, std::string_view word, const std::string& grid = "") {
  auto r = import(path, grid);
  ASSERT_FALSE(r) << path;
  EXPECT_EQ(r.error().code, Code::Input) << r.error().message;
  EXPECT_NE(r.error().message.find(path.filename().string()), std::string::npos) << r.error().message;
  EXPECT_NE(r.error().message.find(word), std::string::npos) << r.error().message;
  EXPECT_LE(r.error().message.size(), 1024u);
}

fs::path writeVdb(const openvdb::GridPtrVec& grids) {
  openvdb::initialize();
  const fs::path path = test::scratchFolder() / "made.vdb";
  openvdb::io::File(path.string()).write(grids);
  return path;
}

openvdb::FloatGrid::Ptr fog(const char* name) {
  openvdb::initialize();
  auto g = openvdb::FloatGrid::create(0.0f);
  g->setName(name);
  g->setGridClass(openvdb::GRID_FOG_VOLUME);
  return g;
}

template <class GridT>
void compareWithOpenVdb(const fs::path& path, const GridInfo& info, const openvdb::GridBase& base) {
  const auto& grid = static_cast<const GridT&>(base);
  auto imported = import(path, info.name);
  ASSERT_TRUE(imported) << imported.error().message;
  const BrickGrid& g = *imported->grid;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(0, 1);
  const auto quantumAt = [&](ivec3 p) {
    if (g.empty()) return 0.0;
    const ivec3 b = (p - g.origin) / kBrickSize;
    if (glm::any(glm::lessThan(p, g.origin)) || glm::any(glm::greaterThanEqual(b, g.levels[0].bricks)))
      return 0.0;
    return static_cast<double>(g.levels[0].at(b).scale) / 255;
  };
  const auto access = grid.getConstAccessor();
  const double float32 = 4e-7 * std::max(std::abs(info.minimum), std::abs(info.maximum));
  const dvec3 size(info.indexMax - info.indexMin + 1);
  for (int i = 0; i < 100000; ++i) {
    const ivec3 p = info.indexMin + ivec3(dvec3(u(random), u(random), u(random)) * size);
    const auto want = static_cast<double>(access.getValue(openvdb::Coord(p.x, p.y, p.z)));
    ASSERT_NEAR(static_cast<double>(voxelAt(g, p)), want, 0.5 * quantumAt(p) + float32)
        << info.name << " " << p.x << " " << p.y << " " << p.z;
  }
  for (int i = 0; i < 10000; ++i) {
    const dvec3 p = dvec3(info.indexMin) - 1.0 + dvec3(u(random), u(random), u(random)) * (size + 1.0);
    double want = 0;  // openvdb::tools::BoxSampler in double precision, and 0 outside the active bounds
    openvdb::Coord base0(int(std::floor(p.x)), int(std::floor(p.y)), int(std::floor(p.z)));
    bool inside = true;
    for (int c = 0; c < 8; ++c) {
      const openvdb::Coord q = base0.offsetBy(c & 1, (c >> 1) & 1, c >> 2);
      const dvec3 t = p - dvec3(base0.x(), base0.y(), base0.z());
      const ivec3 qi(q.x(), q.y(), q.z());
      const bool in = glm::all(glm::greaterThanEqual(qi, info.indexMin)) &&
                      glm::all(glm::lessThanEqual(qi, info.indexMax));
      inside = inside && in;
      if (in)
        want += (c & 1 ? t.x : 1 - t.x) * (c & 2 ? t.y : 1 - t.y) * (c & 4 ? t.z : 1 - t.z) *
                static_cast<double>(access.getValue(q));
    }
    const double bound = 0.5 * quantumAt(ivec3(base0.x(), base0.y(), base0.z())) + float32;
    const double have = sampleTrilinear(g, p);
    ASSERT_NEAR(have, want, bound) << info.name;
    if (!inside) continue;
    const auto sampled =
        static_cast<double>(openvdb::tools::BoxSampler::sample(grid.tree(), openvdb::Vec3R(p.x, p.y, p.z)));
    ASSERT_NEAR(have, sampled, bound + 2 * float32) << info.name;
  }
}

std::vector<fs::path> vdbFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& e : fs::directory_iterator(folder))
    if (e.path().extension() == ".vdb") files.push_back(e.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST(VdbImport, EveryFloatGridMatchesOpenVdb) {
  PILEUS_NEEDS_DATA();
  openvdb::initialize();
  auto files = vdbFiles(*test::dataFolder() / "vdb");
  files.push_back(*test::dataFolder() / "vdb/blender_adaptive_seq/fluid_data_0018.vdb");
  files.push_back(*test::dataFolder() / "vdb/embergen_fire/embergen_fire_a_21.vdb");
  int compared = 0;
  for (const fs::path& path : files) {
    SCOPED_TRACE(path.string());
    JobControl control;
    auto info = inspectVdb(path, control);
    ASSERT_TRUE(info) << info.error().message;
    openvdb::io::File file(path.string());
    file.open(false);
    for (const GridInfo& g : info->grids) {
      if (!g.drawable || g.gridClass == "level set" ||
          (g.valueType != "float" && g.valueType != "half" && g.valueType != "double"))
        continue;
      const auto base = file.readGrid(g.name);
      ++compared;
      if (g.valueType == "double")
        compareWithOpenVdb<openvdb::DoubleGrid>(path, g, *base);
      else
        compareWithOpenVdb<openvdb::FloatGrid>(path, g, *base);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GE(compared, 14);
}

TEST(VdbImport, BadFiles) {
  PILEUS_NEEDS_DATA();
  int seen = 0;
  for (const fs::path& path : vdbFiles(*test::dataFolder() / "vdb_bad")) {
    const std::string name = path.filename().string();
    ++seen;
    if (name.find("empty") != std::string::npos || name.find("inverted") != std::string::npos) {
      auto r = import(path);
      ASSERT_TRUE(r) << r.error().message;
      EXPECT_TRUE(r->grid->empty());
      EXPECT_EQ(r->warnings.size(), 1u);
    } else {
      expectInputError(path, name.starts_with("truncated") ? "truncated" : "damaged");
    }
  }
  EXPECT_EQ(seen, 14);
}

TEST(VdbImport, PointsAndVectorsAreEmptyWithAWarning) {
  PILEUS_NEEDS_DATA();
  for (const char* name : {"openvdb_sphere_points.vdb", "oiio_sphereCd.vdb"}) {
    auto r = import(*test::dataFolder() / "vdb" / name);
    ASSERT_TRUE(r) << r.error().message;
    EXPECT_TRUE(r->grid->empty());
    ASSERT_EQ(r->warnings.size(), 1u) << name;
  }
}

/// A sphere of the radius, in voxels of 0.1 m, with a band of three voxels on each side.
openvdb::FloatGrid::Ptr sphereLevelSet(double radius) {
  openvdb::initialize();
  constexpr double kVoxel = 0.1, kBand = 3 * kVoxel;
  auto g = openvdb::FloatGrid::create(static_cast<float>(kBand));
  g->setName("surface");
  g->setGridClass(openvdb::GRID_LEVEL_SET);
  g->setTransform(openvdb::math::Transform::createLinearTransform(kVoxel));
  const int reach = static_cast<int>(radius) + 4;
  auto access = g->getAccessor();
  for (int z = -reach; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x) {
        const double d = kVoxel * (std::sqrt(double(x * x + y * y + z * z)) - radius);
        if (std::abs(d) < kBand)
          access.setValue({x, y, z}, static_cast<float>(d));
        else if (d < 0)
          access.setValueOff({x, y, z}, static_cast<float>(-kBand));
      }
  return g;
}

TEST(VdbImport, ALevelSetIsFogInsideItsSurface) {
  const fs::path path = writeVdb({sphereLevelSet(20)});
  const auto r = import(path);
  ASSERT_TRUE(r) << r.error().message;
  EXPECT_TRUE(r->levelSet);
  EXPECT_TRUE(r->warnings.empty()) << r->warnings[0];
  const BrickGrid& g = *r->grid;
  for (int x = -24; x <= 24; ++x) {  // linear from the surface to the end of the band
    const double want = std::clamp((20 - std::abs(x)) / 3.0, 0.0, 1.0);
    EXPECT_NEAR(static_cast<double>(voxelAt(g, {x, 0, 0})), want, 0.003) << x;
  }
  EXPECT_EQ(g.indexBounds.min, dvec3(-20)) << "what is outside takes no room";
  JobControl control;
  const auto info = inspectVdb(path, control);
  ASSERT_TRUE(info) << info.error().message;
  EXPECT_EQ(info->chosen, 0);
  EXPECT_TRUE(info->grids[0].drawable);
  EXPECT_EQ(info->grids[0].indexMin, ivec3(-19));
  // From the cache.
  EXPECT_TRUE(import(path)->levelSet);
  const auto ignored = importVdb(path, "", control, {}, LevelSets::Ignore);
  ASSERT_TRUE(ignored) << ignored.error().message;
  EXPECT_TRUE(ignored->grid->empty());
  ASSERT_EQ(ignored->warnings.size(), 1u);
  EXPECT_NE(ignored->warnings[0].find("level set"), std::string::npos);
  EXPECT_EQ(guessGrid(info->grids).grid, "surface");
}

TEST(VdbImport, FogGoesBeforeALevelSet) {
  auto density = fog("unnamed thing");
  density->tree().setValue(openvdb::Coord(3), 1.0f);
  const fs::path path = writeVdb({sphereLevelSet(6), density});
  EXPECT_EQ(import(path)->grid->name, "unnamed thing");
  JobControl control;
  EXPECT_EQ(guessGrid(inspectVdb(path, control)->grids).grid, "unnamed thing");
}

/// The file with one of its types' names replaced by another of the same length.
fs::path withStranger(const fs::path& path, const std::string& type, const std::string& by) {
  std::string bytes = *readFile(path);
  EXPECT_EQ(type.size(), by.size());
  const std::size_t at = bytes.find(type);
  EXPECT_NE(at, std::string::npos);
  bytes.replace(at, type.size(), by);
  EXPECT_TRUE(writeFileAtomic(path, bytes));
  return path;
}

TEST(VdbImport, AGridOfAnUnknownTypeLosesNoOther) {
  auto density = fog("density");
  density->tree().setValue(openvdb::Coord(3), 1.0f);
  auto odd = openvdb::Int32Grid::create(0);
  odd->setName("odd");
  odd->tree().setValue(openvdb::Coord(1), 1);
  const fs::path path = withStranger(writeVdb({density, odd}), "Tree_int32_5_4_3", "Tree_quat4_5_4_3");
  const auto r = import(path);
  ASSERT_TRUE(r) << r.error().message;
  EXPECT_EQ(r->grid->name, "density");
  EXPECT_EQ(voxelAt(*r->grid, ivec3(3)), 1.0f);
  ASSERT_EQ(r->warnings.size(), 1u);
  EXPECT_EQ(r->warnings[0],
            "grid 'odd' is of the type Tree_quat4_5_4_3, which is not known here: it is left out");
  const auto alone = import(path, "odd");
  ASSERT_TRUE(alone) << alone.error().message;
  EXPECT_TRUE(alone->grid->empty());
  JobControl control;
  const auto info = inspectVdb(path, control);
  ASSERT_TRUE(info) << info.error().message;
  ASSERT_EQ(info->grids.size(), 2u);
  EXPECT_TRUE(info->grids[0].drawable);
  EXPECT_FALSE(info->grids[1].drawable);
  EXPECT_NE(info->grids[1].reason.find("Tree_quat4"), std::string::npos);
}

TEST(VdbImport, ANewerFormatIsNamed) {
  auto g = fog("density");
  g->tree().setValue(openvdb::Coord(3), 1.0f);
  const fs::path path = writeVdb({g});
  std::string bytes = *readFile(path);
  bytes[8] = static_cast<char>(0xF0);  // 240
  ASSERT_TRUE(writeFileAtomic(path, bytes.substr(0, bytes.size() - 40)));
  expectInputError(path, "file format 240, this Pileus knows formats up to 224");
  bytes[8] = static_cast<char>(0xE0);
  ASSERT_TRUE(writeFileAtomic(path, bytes.substr(0, bytes.size() - 40)));
  EXPECT_EQ(import(path).error().message.find("format"), std::string::npos) << "it is not the format";
}

TEST(VdbImport, WhatIsNothingDoesNotCount) {
  const auto smoke = [] {
    auto g = fog("density");
    for (int i = 0; i < 4000; ++i)
      g->tree().setValue(openvdb::Coord(i % 20, i / 20 % 20, i / 400), 0.5f + 0.5f * float(i % 7) / 7);
    return g;
  };
  const auto alone = import(writeVdb({smoke()}));
  ASSERT_TRUE(alone) << alone.error().message;
  for (const openvdb::Coord& at : {openvdb::Coord(70000, 0, 0), openvdb::Coord(5000, 5000, 5000)})
    for (const float value : {0.0f, 1e-6f}) {
      auto g = smoke();
      g->tree().setValue(at, value);
      const auto r = import(writeVdb({g}));
      ASSERT_TRUE(r) << r.error().message;
      EXPECT_EQ(r->grid->indexBounds.max, alone->grid->indexBounds.max) << value;
      EXPECT_EQ(r->grid->payloadCount, alone->grid->payloadCount);
      for (int i = 0; i < 4000; i += 37) {
        const ivec3 p(i % 20, i / 20 % 20, i / 400);
        ASSERT_EQ(voxelAt(*r->grid, p), voxelAt(*alone->grid, p));
      }
    }
}

TEST(VdbImport, ABackgroundIsNothingOrAConstantOrRefused) {
  const auto wide = [](float background, int reach) {
    openvdb::initialize();
    auto g = openvdb::FloatGrid::create(background);
    g->setName("density");
    g->setGridClass(openvdb::GRID_FOG_VOLUME);
    g->tree().setValue(openvdb::Coord(0), 1.0f);
    g->tree().setValue(openvdb::Coord(reach), 1.0f);
    return g;
  };
  // As small as nothing: no bricks but those of the two voxels.
  const auto nothing = import(writeVdb({wide(1e-6f, 1500)}));
  ASSERT_TRUE(nothing) << nothing.error().message;
  EXPECT_TRUE(nothing->warnings.empty()) << nothing->warnings[0];
  EXPECT_LE(nothing->grid->payloadCount, 64u);
  EXPECT_EQ(voxelAt(*nothing->grid, ivec3(1)), 0.0f);
  // A real one: a constant between them, as long as that is reasonable.
  const auto constant = import(writeVdb({wide(0.25f, 300)}));
  ASSERT_TRUE(constant) << constant.error().message;
  ASSERT_EQ(constant->warnings.size(), 1u);
  EXPECT_EQ(voxelAt(*constant->grid, ivec3(150)), 0.25f);
  expectInputError(writeVdb({wide(0.25f, 1500)}), "background is 0.25");
}

TEST(VdbImport, WithoutRoomForTheCacheTheGridIsHeldInMemory) {
  auto g = fog("density");
  for (int i = 0; i < 20000; ++i)
    g->tree().setValue(openvdb::Coord(i * 7 % 150, i * 3 % 140, i % 130), 1.0f + float(i % 100));
  const fs::path path = writeVdb({g});
  const auto kept = import(path);
  ASSERT_TRUE(kept) << kept.error().message;
  // Where the bricks should lie is no folder.
  const fs::path bricks = cacheFolder() / "bricks", aside = cacheFolder() / "aside";
  fs::rename(bricks, aside);
  std::ofstream(bricks) << "in the way";
  const auto r = import(path), again = import(path);
  fs::remove(bricks);
  fs::rename(aside, bricks);
  ASSERT_TRUE(r && again) << (r ? again : r).error().message;
  EXPECT_EQ(r->grid->content, kept->grid->content);
  EXPECT_GT(r->grid->payloadCount, 100u);
  ASSERT_EQ(r->warnings.size(), 1u);
  EXPECT_NE(r->warnings[0].find("without the cache"), std::string::npos) << r->warnings[0];
  EXPECT_NE(r->warnings[0].find("cannot be written (Not a directory)"), std::string::npos) << r->warnings[0];
  EXPECT_EQ(again->warnings, r->warnings) << "each time, as long as it is so";
}

TEST(VdbImport, NamesAreUtf8) {
  auto g = fog("Dichte \xe9\xfc");  // Latin-1
  g->tree().setValue(openvdb::Coord(3), 1.0f);
  auto long_ = fog("a");
  std::string name;
  while (name.size() < 300) name += "\xc3\xa9";
  long_->setName(name);
  long_->tree().setValue(openvdb::Coord(3), 1.0f);
  const fs::path path = writeVdb({g, long_});
  JobControl control;
  const auto info = inspectVdb(path, control);
  ASSERT_TRUE(info) << info.error().message;
  ASSERT_EQ(info->grids.size(), 2u);
  EXPECT_EQ(info->grids[0].name, "Dichte \xc3\xa9\xc3\xbc");
  EXPECT_EQ(info->grids[1].name, name.substr(0, 120) + "...") << "cut between characters";
  const auto r = import(path, info->grids[0].name);
  ASSERT_TRUE(r) << r.error().message;
  EXPECT_EQ(r->grid->name, "Dichte \xc3\xa9\xc3\xbc");
}

TEST(VdbImport, GridsOfOneNameAreNumbered) {
  PILEUS_NEEDS_DATA();
  const fs::path path = *test::dataFolder() / "vdb/arnold_grids.vdb";
  EXPECT_EQ(import(path, "density[1]")->grid->activeVoxels, 2222u);
  EXPECT_EQ(import(path, "density")->grid->activeVoxels, import(path, "density[0]")->grid->activeVoxels);
  expectInputError(path, "density[0], density[1], density[2]", "nope");
}

TEST(VdbImport, WhatIsNoVdbIsNamed) {
  const fs::path folder = test::scratchFolder();
  expectInputError(folder / "missing.vdb", "no such file");
  expectInputError(folder, "folder");
  const auto write = [&](const char* name, std::string_view content) {
    EXPECT_TRUE(writeFileAtomic(folder / name, content));
    return folder / name;
  };
  expectInputError(write("text.vdb", "Dear diary,\ntoday"), "is text");
  expectInputError(write("empty.vdb", ""), "empty");
  expectInputError(write("lfs.vdb", "version https://git-lfs.github.com/spec/v1\n"), "LFS");
  expectInputError(write("image.vdb", std::string("\x76\x2f\x31\x01\x02\x00\x00\x00", 8)), "OpenEXR");
  expectInputError(write("nano.nvdb", "NanoVDB0\x01\x02"), "not supported yet");
  expectInputError(write("random.vdb", std::string("\x01\x02\xff\x00\x9c", 5)), "01 02 ff");
  expectInputError(write("short.vdb", std::string(" BDV\0\0\0\0\xe0", 9)), "truncated");
  std::string long_ = std::string(" BDV\0\0\0\0", 8);
  std::mt19937 random(1);
  for (int i = 0; i < 4000; ++i) long_ += static_cast<char>(random());
  auto garbage = import(write("garbage.vdb", long_));
  ASSERT_FALSE(garbage);
  EXPECT_EQ(garbage.error().code, Code::Input) << garbage.error().message;
}

TEST(VdbImport, TruncatedAnywhereIsAnError) {
  PILEUS_NEEDS_DATA();
  const std::string whole = *readFile(*test::dataFolder() / "vdb/smoke1.vdb");
  const fs::path folder = test::scratchFolder();
  for (std::size_t size :
       {std::size_t(30), std::size_t(300), whole.size() / 10, whole.size() / 2, whole.size() - 1}) {
    const fs::path path = folder / fmt::format("cut{}.vdb", size);
    ASSERT_TRUE(writeFileAtomic(path, std::string_view(whole).substr(0, size)));
    expectInputError(path, "truncated");
  }
}

TEST(VdbImport, AStreamedFileIsReadAndItsTruncationNoticed) {
  auto g = fog("density");
  for (int i = 0; i < 500; ++i)
    g->tree().setValue(openvdb::Coord(i * 7 % 50, i * 3 % 40, i % 30), 1.0f + static_cast<float>(i));
  const fs::path path = test::scratchFolder() / "stream.vdb";
  {
    std::ofstream out(path, std::ios::binary);
    openvdb::io::Stream(out).write(openvdb::GridCPtrVec{g});
  }
  auto r = import(path);
  ASSERT_TRUE(r) << r.error().message;
  EXPECT_EQ(r->grid->activeVoxels, g->activeVoxelCount());
  fs::resize_file(path, fs::file_size(path) * 2 / 3);
  expectInputError(path, "truncated");
}

TEST(VdbImport, NonFiniteVoxelsAreZeroWithAWarning) {
  auto g = fog("density");
  auto access = g->getAccessor();
  for (int i = 0; i < 40; ++i) access.setValue(openvdb::Coord(i, i / 2, 3), 1.0f + static_cast<float>(i));
  access.setValue(openvdb::Coord(1, 0, 3), std::nanf(""));
  access.setValue(openvdb::Coord(2, 1, 3), -INFINITY);
  auto r = import(writeVdb({g}));
  ASSERT_TRUE(r) << r.error().message;
  ASSERT_EQ(r->warnings.size(), 1u);
  EXPECT_NE(r->warnings[0].find("2 voxels are not finite"), std::string::npos) << r->warnings[0];
  EXPECT_EQ(voxelAt(*r->grid, {1, 0, 3}), 0.0f);
  EXPECT_EQ(voxelAt(*r->grid, {2, 1, 3}), 0.0f);
  EXPECT_EQ(r->grid->maximum, 40.0f);
}

TEST(VdbImport, ChoosesByNameAndClass) {
  auto temperature = fog("a_temperature"), density = fog("Density");
  temperature->tree().setValue(openvdb::Coord(0), 300.0f);
  density->tree().setValue(openvdb::Coord(0), 1.0f);
  auto surface = fog("aa_surface");
  surface->setGridClass(openvdb::GRID_LEVEL_SET);
  surface->tree().setValue(openvdb::Coord(0), -1.0f);
  EXPECT_EQ(import(writeVdb({surface, temperature, density}))->grid->name, "Density");
  EXPECT_EQ(import(writeVdb({surface, temperature}))->grid->name, "a_temperature");
}

TEST(VdbImport, OtherScalarTypesAndActiveTiles) {
  openvdb::initialize();
  auto b = openvdb::BoolGrid::create(false);
  b->setName("mask");
  b->fill(openvdb::CoordBBox(openvdb::Coord(-40), openvdb::Coord(40)), true);  // tiles inside
  auto i = openvdb::Int32Grid::create(0);
  i->setName("index");
  i->tree().setValue(openvdb::Coord(5, 6, 7), -3);
  const fs::path path = writeVdb({b, i});
  auto mask = import(path, "mask");
  ASSERT_TRUE(mask) << mask.error().message;
  EXPECT_EQ(mask->grid->activeVoxels, 81u * 81u * 81u);
  EXPECT_EQ(voxelAt(*mask->grid, ivec3(0)), 1.0f);
  EXPECT_EQ(voxelAt(*mask->grid, ivec3(-40, 40, 40)), 1.0f);
  EXPECT_EQ(voxelAt(*mask->grid, ivec3(-41, 40, 40)), 0.0f);
  auto index = import(path, "index");
  ASSERT_TRUE(index) << index.error().message;
  EXPECT_EQ(voxelAt(*index->grid, {5, 6, 7}), -3.0f);
  EXPECT_EQ(index->warnings.size(), 1u);
}

TEST(VdbImport, TransformsAreHonouredOrRefused) {
  auto g = fog("density");
  g->tree().setValue(openvdb::Coord(1, 2, 3), 1.0f);
  // Sheared, mirrored and moved, in OpenVDB's row-vector convention.
  g->setTransform(openvdb::math::Transform::createLinearTransform(
      openvdb::math::Mat4d(-2., 0., 0., 0., 0.5, 1., 0., 0., 0., 0., 3., 0., 10., 20., 30., 1.)));
  auto r = import(writeVdb({g}));
  ASSERT_TRUE(r) << r.error().message;
  const openvdb::Vec3d want = g->transform().indexToWorld(openvdb::Coord(1, 2, 3));
  const dvec3 have = dvec3(r->grid->worldFromIndex * dvec4(1, 2, 3, 1));
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(have[a], want[a], 1e-12);
  EXPECT_NEAR(r->grid->voxelSize, std::sqrt(1.25), 1e-12);
  EXPECT_LT(glm::determinant(glm::dmat3(r->grid->worldFromIndex)), 0);

  g->setTransform(openvdb::math::Transform::createFrustumTransform(
      openvdb::BBoxd(openvdb::Vec3d(0), openvdb::Vec3d(100)), 0.3, 10.0));
  expectInputError(writeVdb({g}), "not affine");
}

TEST(VdbImport, AbsurdExtentsAreRefusedQuickly) {
  auto wide = fog("density");
  wide->tree().setValue(openvdb::Coord(0), 1.0f);
  wide->tree().setValue(openvdb::Coord(100000, 0, 0), 1.0f);
  expectInputError(writeVdb({wide}), "limit");
  auto bomb = fog("density");  // active tiles of 4096^3 voxels, a few hundred bytes in the file
  bomb->tree().addTile(3, openvdb::Coord(0), 1.0f, true);
  bomb->tree().addTile(3, openvdb::Coord(8192), 1.0f, true);
  expectInputError(writeVdb({bomb}), "limit");
}

TEST(VdbImport, ASecondImportNeedsNoChildAndADamagedCacheIsRepaired) {
  auto g = fog("density");
  g->tree().setValue(openvdb::Coord(1, 2, 3), 1.0f);
  const fs::path path = writeVdb({g});
  auto first = import(path);
  ASSERT_TRUE(first) << first.error().message;
  ImportLimits noChild;
  noChild.executable = "/nonexistent/pileus";
  auto second = import(path, "", noChild);
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_EQ(second->grid->content, first->grid->content);
  for (const auto& e : fs::directory_iterator(cacheFolder() / "bricks")) {
    std::string bytes = *readFile(e.path());
    bytes[bytes.size() - 100] = static_cast<char>(bytes[bytes.size() - 100] ^ 1);
    ASSERT_TRUE(writeFileAtomic(e.path(), bytes));
  }
  EXPECT_EQ(import(path, "", noChild).error().code, Code::Internal);  // needs its child again
  auto repaired = import(path);
  ASSERT_TRUE(repaired) << repaired.error().message;
  EXPECT_EQ(repaired->grid->content, first->grid->content);
}

TEST(VdbImport, CancelAndTimeLimitKillTheChild) {
  // A child that never answers.
  const fs::path script = test::scratchFolder() / "sleeper";
  {
    std::ofstream(script) << "#!/bin/sh\nexec sleep 30\n";
    fs::permissions(script, fs::perms::owner_all);
  }
  auto g = fog("density");
  g->tree().setValue(openvdb::Coord(4, 4, 4), 1.0f);
  const fs::path path = writeVdb({g});
  ImportLimits limits;
  limits.executable = script;
  limits.wallSeconds = 0.2;
  const auto begin = std::chrono::steady_clock::now();
  auto slow = import(path, "", limits);
  ASSERT_FALSE(slow);
  EXPECT_EQ(slow.error().code, Code::Input);
  EXPECT_NE(slow.error().message.find("longer than"), std::string::npos);
  EXPECT_TRUE(slow.error().passing) << "another time it may be read";
  limits.wallSeconds = 60;
  JobControl control;
  std::thread canceller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    control.cancel();
  });
  auto cancelled = importVdb(path, "", control, limits);
  canceller.join();
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().code, Code::Cancelled);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 5.0);
}

TEST(VdbImport, AKilledReaderLeavesNoHalfStoreBehind) {
  const fs::path folder = test::scratchFolder(), script = folder / "half";
  // import grid FILE NAME STORE MEMORY CPU: begins the store and says where.
  std::ofstream(script) << "#!/bin/sh\necho half > \"$5.tmp$$-0\"\necho \"$5.tmp$$-0\" > "
                        << (folder / "said").string() << "\nexec sleep 30\n";
  fs::permissions(script, fs::perms::owner_all);
  auto g = fog("density");
  g->tree().setValue(openvdb::Coord(5, 4, 4), 1.0f);
  ImportLimits limits;
  limits.executable = script;
  JobControl control;
  std::thread canceller([&] {
    std::error_code ec;
    while (fs::file_size(folder / "said", ec) == 0 || ec)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    control.cancel();
  });
  const auto cancelled = importVdb(writeVdb({g}), "", control, limits);
  canceller.join();
  ASSERT_FALSE(cancelled);
  std::string half;
  std::getline(std::ifstream(folder / "said") >> std::ws, half);
  ASSERT_NE(half.find(".tmp"), std::string::npos) << half;
  EXPECT_FALSE(fs::exists(half)) << half;
}

TEST(VdbImport, TooLittleMemoryIsAnErrorOfTheInput) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the address space of a sanitised child is not limited";
#endif
  PILEUS_NEEDS_DATA();
  ImportLimits limits;
  limits.memoryBytes = 100u << 20;
  auto g = fog("density");
  g->denseFill(openvdb::CoordBBox(openvdb::Coord(0), openvdb::Coord(299)), 1.0f, true);
  int n = 0;
  for (auto leaf = g->tree().beginLeaf(); leaf; ++leaf)
    for (openvdb::Index i = 0; i < 512; ++i) leaf->setValueOnly(i, static_cast<float>(++n % 977));
  auto r = import(writeVdb({g}), "", limits);
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().code, Code::Input) << r.error().message;
}

}  // namespace
}  // namespace pileus::volume
