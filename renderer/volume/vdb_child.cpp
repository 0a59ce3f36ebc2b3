#include "renderer/volume/vdb_child.h"

#include "renderer/base/byte_stream.h"
#include "renderer/volume/brick_store.h"
#include "renderer/volume/vdb_file.h"

namespace pileus::volume {
namespace {

int work(int argc, char** argv, ImportVoice& speaker, JobControl& control) {
  const std::string_view verb = argv[2];
  auto file = VdbFile::open(argv[3]);
  if (!file) return speaker.fail(file.error());
  if (verb == "inspect" && argc == 6) {
    auto info = (*file)->info(control);
    if (!info) return speaker.fail(info.error());
    speaker.say(MessageKind::Info, encodeInfo(*info));
    return 0;
  }
  auto imported = (*file)->import(argv[4], enumFromId<LevelSets>(argv[6]).value_or(LevelSets::Fog), control);
  if (!imported) return speaker.fail(imported.error());
  std::vector<std::string> notes = imported->warnings;
  for (const std::string& name : imported->others) notes.push_back(std::string(kOtherGrid) + name);
  if (imported->levelSet) notes.emplace_back(kWasLevelSet);
  const auto written = writeStore(argv[5], *imported->grid, notes);
  if (!written) {  // a full disk is no reason to see nothing: the parent keeps it in memory
    writeStoreTo(*imported->grid, notes, [&](std::string_view bytes) {
      speaker.sayStore(bytes);
      return true;
    });
  }
  speaker.say(MessageKind::Done, written ? "" : written.error().message);
  return 0;
}

}  // namespace

int importChildMain(int argc, char** argv) {
  const std::string_view verb = argc > 2 ? argv[2] : "";
  if (!(verb == "inspect" && argc == 6) && !(verb == "grid" && argc == 9)) return refuseImportByHand();
  return runAsImportChild(argv[argc - 2], argv[argc - 1], [&](ImportVoice& voice, JobControl& control) {
    return work(argc, argv, voice, control);
  });
}

}  // namespace pileus::volume
