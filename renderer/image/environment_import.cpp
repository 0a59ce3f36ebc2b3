#include "renderer/image/environment_import.h"

#include <cmath>
#include <cstring>

#include "renderer/base/byte_stream.h"

namespace fs = std::filesystem;

namespace pileus::image {
namespace {

std::string encode(const EnvironmentFile& file) {
  ByteWriter w;
  w.put(file.map.size.x).put(file.map.size.y).put(static_cast<unsigned char>(file.primaries.has_value()));
  if (file.primaries)
    for (const vec2& v :
         {file.primaries->red, file.primaries->green, file.primaries->blue, file.primaries->white})
      w.put(v.x).put(v.y);
  w.put(static_cast<std::uint32_t>(file.warnings.size()));
  for (const std::string& warning : file.warnings) w.put(warning);
  return w.bytes();
}

/// Nothing: what the child said is malformed. Its pixels are checked as any others.
std::optional<EnvironmentFile> decode(std::string_view info, std::string_view pixels) {
  ByteReader r(info);
  EnvironmentFile out;
  out.map.size.x = r.take<int>();
  out.map.size.y = r.take<int>();
  if (r.take<unsigned char>()) {
    Chromaticities c;
    for (vec2* v : {&c.red, &c.green, &c.blue, &c.white}) {
      v->x = r.take<float>();
      v->y = r.take<float>();
    }
    out.primaries = c;
  }
  for (auto n = r.take<std::uint32_t>(); n > 0 && r.ok(); --n) out.warnings.push_back(r.takeText());
  const ivec2 size = out.map.size;
  if (!r.ok() || !r.done() || size.x < 1 || size.y < 1 || size.x > kLargestEnvironment.x ||
      size.y > kLargestEnvironment.y ||
      pixels.size() != std::size_t(size.x) * std::size_t(size.y) * sizeof(vec3))
    return std::nullopt;
  out.map.radiance.resize(std::size_t(size.x) * std::size_t(size.y));
  std::memcpy(static_cast<void*>(out.map.radiance.data()), pixels.data(), pixels.size());
  scene::repair(out.map, scene::Negative::Keep);
  return out;
}

}  // namespace

Result<EnvironmentFile> importEnvironment(const fs::path& path, JobControl& control,
                                          const ImportLimits& limits) {
  constexpr std::size_t kMostBytes =
      std::size_t(kLargestEnvironment.x) * std::size_t(kLargestEnvironment.y) * sizeof(vec3);
  std::string pixels;
  ImportWatch watch;
  watch.store = [&](std::string_view part) -> Result<void> {
    if (pixels.size() + part.size() > kMostBytes)
      return aboutFile(path, Code::Internal, "its reader's answer is too long");
    pixels.append(part);
    return {};
  };
  PILEUS_TRY(const std::string info,
             runImportChild(path, {"environment", path.string()}, control, limits, watch));
  auto out = decode(info, pixels);
  if (!out) return aboutFile(path, Code::Internal, "its reader's answer is malformed");
  return std::move(*out);
}

bool isEnvironmentChild(int argc, char** argv) {
  return argc == 6 && std::string_view(argv[1]) == "import" && std::string_view(argv[2]) == "environment";
}

int environmentChildMain(int argc, char** argv) {
  if (!isEnvironmentChild(argc, argv)) return refuseImportByHand();
  return runAsImportChild(argv[4], argv[5], [&](ImportVoice& voice, JobControl&) {
    auto file = decodeEnvironment(argv[3]);
    if (!file) {
      // The parent names the path.
      Error e = file.error();
      if (const std::string named = fmt::format("{}: ", argv[3]); e.message.starts_with(named))
        e.message.erase(0, named.size());
      return voice.fail(e);
    }
    const auto& pixels = file->map.radiance;
    voice.sayStore({reinterpret_cast<const char*>(pixels.data()), pixels.size() * sizeof(vec3)});
    voice.say(MessageKind::Info, encode(*file));
    return 0;
  });
}

}  // namespace pileus::image
