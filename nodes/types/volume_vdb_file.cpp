// volume.vdb_file: one grid of an OpenVDB file, read by a job.
#include "nodes/declare/describe.h"
#include "renderer/base/jobs.h"
#include "renderer/volume/autofit.h"
#include "renderer/volume/grid_guess.h"
#include "renderer/volume/vdb_import.h"

namespace pileus::nodes {
namespace {

struct In {
  FilePath file;
  std::string grid;
  volume::LevelSets level_set = volume::LevelSets::Fog;
};

struct Out {
  VolumeValue volume;
};

void describe(Describe<In, Out>& d) {
  d.name("VDB File").category("Volume").keywords("openvdb read import load smoke cloud file");
  d.help(
      "Reads one grid of an OpenVDB file. The file's own transform places it; a fog volume's values become "
      "density.");
  d.in("file", &In::file).file({"vdb"}).help("The .vdb file. Relative paths start at the graph's folder.");
  d.in("grid", &In::grid)
      .help("Name of the grid, or name[i] where several share it. Empty: chosen by name and class.");
  d.in("level_set", &In::level_set)
      .label("Level sets")
      .help("What becomes of a grid that holds distances to a surface instead of densities.");
  d.out("volume", &Out::volume).help("The grid as one volume with the default medium.");
}

struct Read {
  volume::ImportedGrid imported;
  volume::Autofit fit;
  std::string stray;  ///< what lies far from all else; empty: nothing does
};

/// A voxel that was set by mistake makes a grid large, and a reader wonder.
std::string strayOf(const volume::BrickGrid& grid) {
  const Box3 whole = grid.indexBounds, bulk = volume::bulkBounds(grid);
  for (int a = 0; a < 3; ++a)
    for (const bool low : {true, false}) {
      const double far = low ? whole.min[a] : whole.max[a], near = low ? bulk.min[a] : bulk.max[a];
      if (std::abs(far - near) > bulk.size()[a])
        return fmt::format(
            "something lies far from the rest, at {} {:.0f} where all else is within {:.0f} to {:.0f}: it is "
            "drawn, but shadows and cameras are fitted to the rest",
            "XYZ"[a], low ? far + 1 : far - 1, bulk.min[a], bulk.max[a]);
    }
  return {};
}

struct Import {
  LooseJob<Read> job;
};

/// What was guessed and why, and what of the file is not used.
void explain(const In& in, const Read& read, EvalContext& ctx) {
  if (in.grid.empty())
    ctx.note(fmt::format("{}: {}", read.imported.grid->name, volume::whyByName(read.imported.grid->name)));
  using volume::GridRole;
  const GridRole role = volume::roleOfGrid(read.imported.grid->name);
  if (!in.grid.empty() && (role == GridRole::Temperature || role == GridRole::Flame))
    ctx.note("A Black Body behind it shows it glow");
  else if (read.fit.opticalDepth > 0)
    ctx.note(fmt::format("Extinction {:.3g} 1/m gives an optical depth of {:.0f} through the middle (likely)",
                         read.fit.extinction, read.fit.opticalDepth));
  for (std::string& note : volume::notesOnOthers(read.imported.others)) ctx.note(std::move(note));
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  if (in.file.path.empty()) return fail(Code::Input, "file: no file chosen");
  auto& job = ctx.state<Import>().job;
  if (!job)
    job = looseJob<Read>([path = std::filesystem::path(in.file.path), grid = in.grid,
                          surfaces = in.level_set](JobControl& control) -> Result<Read> {
      Read read;
      PILEUS_TRY(read.imported, volume::importVdb(path, grid, control, {}, surfaces));
      read.fit = volume::autofit(*read.imported.grid);
      read.stray = strayOf(*read.imported.grid);
      return read;
    });
  if (!job->done()) {
    ctx.pending(job->progress(), "Reading " + std::filesystem::path(in.file.path).filename().string());
    return Out{};
  }
  if (!job->result()) {
    Error error = job->result().error();
    error.message.insert(0, "file: ");
    return error;
  }
  const volume::ImportedGrid& imported = job->result()->imported;
  for (const std::string& warning : imported.warnings) ctx.warn(warning);
  if (const std::string& stray = job->result()->stray; !stray.empty())
    ctx.warn(fmt::format("grid '{}': {}", imported.grid->name, stray));
  Out out;
  volume::Instance instance;
  instance.shape = volume::Shape::Grid;
  instance.grid = imported.grid;
  instance.worldFromLocal = imported.grid->worldFromIndex;
  if (imported.grid->empty()) {
    ctx.note(imported.grid->name.empty() ? "empty" : imported.grid->name + ", empty");
  } else {
    const dvec3 extent =
        imported.grid->indexBounds.size() - dvec3(1.0);  // bounds reach one voxel beyond the active ones
    ctx.note(fmt::format("{}, {:.0f} x {:.0f} x {:.0f}, {} active voxels", imported.grid->name, extent.x,
                         extent.y, extent.z, imported.grid->activeVoxels));
    if (imported.levelSet)
      ctx.note("A level set, drawn as fog: 0 at its surface, 1 where its band ends inside");
    explain(in, *job->result(), ctx);
    ctx.reportGpu(0, std::size_t(imported.grid->payloadCount) * volume::kStoredVoxels);
  }
  out.volume.items.push_back(std::move(instance));
  return out;
}

}  // namespace

NodeType node_volume_vdb_file() { return makeNode<In, Out>("volume.vdb_file", 1, describe, evaluate); }

}  // namespace pileus::nodes
