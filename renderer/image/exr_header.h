#pragma once
// What all readers of EXR files share: the opening of a file and the check of what its header claims.
// Internal to renderer/image.
#include <OpenEXR/ImfHeader.h>

#include <cstdint>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>

#include "renderer/base/result.h"
#include "renderer/image/image.h"

namespace pileus::image {

/// Window sizes against fixed limits and against the file's length, in 64 bits and before anything is
/// allocated for them: a header costs a hostile file nothing.
Result<void> checkExrSizes(const Imf::Header& header, std::int64_t fileBytes);

/// Rec. 709's where the file does not say, or says no numbers.
Chromaticities readChromaticities(const Imf::Header& header);

/// The library begins its messages with the path, which ours name already.
std::string reasonWithoutPath(std::string_view reason, const std::filesystem::path& path);

/// Bytes of a file that can be read; also sets the library's own limits.
Result<std::int64_t> openableExr(const std::filesystem::path& path);

/// `read(bytes)` gives a Result<T>; what is thrown in it becomes an Error, and all of them name the file.
template <class T, class Read>
Result<T> readingExr(const std::filesystem::path& path, Read&& read) {
  PILEUS_TRY(const std::int64_t bytes, openableExr(path));
  try {
    Result<T> out = read(bytes);
    if (!out) return fail(out.error().code, "{}: {}", path.string(), out.error().message);
    return out;
  } catch (const std::bad_alloc&) {
    return fail(Code::Input, "{}: does not fit into memory", path.string());
  } catch (const std::exception& e) {
    return fail(Code::Input, "{}: not a readable EXR picture ({})", path.string(),
                reasonWithoutPath(e.what(), path));
  }
}

}  // namespace pileus::image
