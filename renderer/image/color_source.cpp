#include "renderer/image/color_source.h"
#include "renderer/base/text.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <sstream>

namespace OCIO = OCIO_NAMESPACE;

namespace pileus::image {
namespace {

bool namesAcesCg(const std::string& name) {
  const std::string n = lowered(name);
  return n == "acescg" || n == "lin_ap1" || n == "aces - acescg" || n == "linear acescg" ||
         n == "acescg - linear" || n == "lin_acescg" || n == "utility - linear - ap1";
}

bool isAcesCg(const OCIO::ConstColorSpaceRcPtr& space) {
  if (!space || space->isData()) return false;
  if (namesAcesCg(space->getName())) return true;
  for (std::size_t i = 0; i < space->getNumAliases(); ++i)
    if (namesAcesCg(space->getAlias(i))) return true;
  return false;
}

}  // namespace

ColorSource chooseColorSource(const OCIO::Config& config) {
  const auto sceneLinear = config.getColorSpace(OCIO::ROLE_SCENE_LINEAR);
  if (isAcesCg(sceneLinear)) return {sceneLinear->getName(), false, ""};
  const int count = config.getNumColorSpaces(OCIO::SEARCH_REFERENCE_SPACE_SCENE, OCIO::COLORSPACE_ALL);
  for (int i = 0; i < count; ++i) {
    const char* name =
        config.getColorSpaceNameByIndex(OCIO::SEARCH_REFERENCE_SPACE_SCENE, OCIO::COLORSPACE_ALL, i);
    if (const auto space = config.getColorSpace(name); isAcesCg(space)) return {space->getName(), false, ""};
  }
  if (const auto aces = config.getColorSpace("aces_interchange"); aces) return {aces->getName(), true, ""};
  if (sceneLinear)
    return {sceneLinear->getName(), false,
            fmt::format("it has no ACEScg and no aces_interchange role, so colours are taken as '{}'",
                        sceneLinear->getName())};
  const std::string first =
      count > 0 ? config.getColorSpaceNameByIndex(OCIO::SEARCH_REFERENCE_SPACE_SCENE, OCIO::COLORSPACE_ALL, 0)
                : "";
  return {first, false, fmt::format("it has no scene_linear role, so colours are taken as '{}'", first)};
}

Result<void> checkProfile(const std::string& name, const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  const std::string key = "ocio_profile_version:";
  while (std::getline(lines, line)) {
    if (line.compare(0, key.size(), key) != 0) continue;
    int major = 0, minor = 0;
    const int found = std::sscanf(line.c_str() + key.size(), "%9d.%9d", &major, &minor);
    const int library = OCIO::GetVersionHex(), libraryMajor = library >> 24,
              libraryMinor = (library >> 16) & 0xff;
    if (found >= 1 && std::pair(major, minor) > std::pair(libraryMajor, libraryMinor))
      return fail(Code::Input,
                  "{}: the colour config has profile version {}.{}, newer than this build's OpenColorIO {}, "
                  "which reads up to {}.{}; "
                  "use a config written for {}.{} or older",
                  name, major, minor, OCIO::GetVersion(), libraryMajor, libraryMinor, libraryMajor,
                  libraryMinor);
    return {};
  }
  return fail(Code::Input, "{}: not an OpenColorIO config (no line 'ocio_profile_version:')", name);
}

}  // namespace pileus::image
