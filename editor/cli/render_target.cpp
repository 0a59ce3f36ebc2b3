#include "editor/cli/render_target.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <optional>
#include <regex>
#include <system_error>

#include "renderer/base/file.h"
#include "renderer/base/text.h"

namespace fs = std::filesystem;

namespace pileus::cli {
namespace {

struct Token {
  std::size_t begin = 0, length = 0;
  int width = 1;
};

/// The last match; its first group that holds digits is the width, without one the length of a run of '#'.
std::optional<Token> lastToken(const std::string& name, const std::regex& pattern) {
  constexpr int kWidest = 12;
  std::optional<Token> last;
  for (std::sregex_iterator it(name.begin(), name.end(), pattern), end; it != end; ++it) {
    Token token{static_cast<std::size_t>(it->position()), static_cast<std::size_t>(it->length()), 1};
    if (name[token.begin] == '#')
      token.width = static_cast<int>(std::min<std::size_t>(token.length, kWidest));
    for (std::size_t i = 1; i < it->size(); ++i)
      if ((*it)[i].length() > 0)
        token.width = (*it)[i].length() > 2 ? kWidest : std::clamp(std::stoi((*it)[i]), 1, kWidest);
    last = token;
  }
  return last;
}

std::string endingOf(const fs::path& path) { return lowered(path.extension().string()); }

}  // namespace

std::string FramePattern::path(int frame) const {
  return hasFrame() ? before + fmt::format("{:0{}d}", frame, width) + after : before;
}

Result<FramePattern> framePattern(const std::string& out) {
  static const std::regex kHashes("#+"), kPercent(R"(%0?(\d+)d|%0?d(?![A-Za-z]))"),
      kDollar(R"(\$F(\d+)|\$F(?![A-Za-z]))");
  const std::size_t slash = out.rfind('/');
  const std::string folder = slash == out.npos ? "" : out.substr(0, slash + 1),
                    name = out.substr(folder.size());
  std::optional<Token> found;
  for (const std::regex* kind : {&kHashes, &kPercent, &kDollar}) {
    const std::optional<Token> token = lastToken(name, *kind);
    if (!token) continue;
    if (found)
      return fail(Code::Arguments, "{}: both '{}' and '{}' could be the frame; use one of them", out,
                  name.substr(found->begin, found->length), name.substr(token->begin, token->length));
    found = token;
  }
  if (!found) return FramePattern{out, "", 0};
  return FramePattern{folder + name.substr(0, found->begin), name.substr(found->begin + found->length),
                      found->width};
}

Result<TargetKind> targetKind(const std::string& out) {
  if (out == "-") return TargetKind::StandardOutput;
  const std::string ending = endingOf(out);
  if (ending == ".png") return TargetKind::Png;
  if (ending == ".exr" || isStream(out)) return TargetKind::Exr;
  return fail(Code::Arguments, "{}: pictures are written as .exr, or .png; {}", out,
              ending.empty() ? "this name has no ending" : "'" + ending + "' is neither");
}

Result<void> checkTarget(const fs::path& path) {
  std::error_code ec;
  const auto refused = [&](const std::string& why) {
    return fail(Code::Input, "{}: cannot be written ({})", path.string(), why);
  };
  if (isStream(path)) {
    if (::access(path.c_str(), W_OK) != 0) return refused(std::strerror(errno));
    return {};
  }
  const fs::path file = linkTarget(path);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ec)) return refused(fmt::format("folder {} does not exist", folder.string()));
  if (fs::is_directory(file, ec)) return refused("is a folder");
  if (::access(folder.c_str(), W_OK) != 0)
    return refused(fmt::format("folder {} is not writable", folder.string()));
  return {};
}

Result<void> writeStandardOutput(std::string_view bytes) {
  if (!writeAll(STDOUT_FILENO, bytes))
    return fail(Code::Input, "standard output: cannot be written ({})", std::strerror(errno));
  return {};
}

}  // namespace pileus::cli
