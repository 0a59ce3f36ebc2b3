// readExrMetadata: the header of the first part only.
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "renderer/image/exr.h"
#include "renderer/image/exr_limits.h"
#include "renderer/image/reason.h"

namespace pileus::image {

Result<std::map<std::string, std::string>> readExrMetadata(const std::filesystem::path& path) {
  std::map<std::string, std::string> out;
  limitHeaders();
  try {
    std::error_code ec;
    if (!std::filesystem::is_regular_file(path, ec))
      return fail(Code::Input, "{}: is not a file", path.string());
    // Without rebuilding the table of chunks: a damaged file costs no time.
    const Imf::MultiPartInputFile file(path.c_str(), 1, false);
    if (file.parts() < 1) return out;
    const Imf::Header& header = file.header(0);
    for (auto it = header.begin(); it != header.end(); ++it)
      if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute()))
        out.emplace(it.name(), text->value());
    return out;
  } catch (const std::bad_alloc&) {
    return fail(Code::Input, "{}: does not fit into memory", path.string());
  } catch (const std::exception& e) {
    return fail(Code::Input, "{}: not a readable EXR picture ({})", path.string(), clampReason(e.what()));
  }
}

}  // namespace pileus::image
