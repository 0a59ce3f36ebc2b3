// The parent's side of import_child.h.
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <cstring>

#include "renderer/base/byte_stream.h"
#include "renderer/base/child_process.h"
#include "renderer/base/file.h"
#include "renderer/base/import_child.h"

namespace fs = std::filesystem;

namespace pileus {
namespace {

constexpr std::size_t kLongestReason = 1024;

/// Printable part of what a library wrote, on one line.
std::string_view lastLine(std::string_view text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  const auto at = text.rfind('\n');
  return at == std::string_view::npos ? text : text.substr(at + 1);
}

}  // namespace

Error aboutFile(const fs::path& path, Code code, std::string_view reason, bool passing) {
  std::string message = fmt::format("{}: {}", path.string(), reason);
  if (message.size() > kLongestReason) message = message.substr(0, kLongestReason - 3) + "...";
  return Error{code, std::move(message), passing};
}

Result<std::string> runImportChild(const fs::path& path, std::vector<std::string> arguments,
                                   JobControl& control, const ImportLimits& limits,
                                   const ImportWatch& watch) {
  arguments.insert(arguments.begin(), "import");
  arguments.push_back(std::to_string(limits.memoryBytes));
  arguments.push_back(std::to_string(static_cast<long>(limits.cpuSeconds)));
  auto started =
      ChildProcess::start(limits.executable.empty() ? executablePath() : limits.executable, arguments);
  if (!started) return aboutFile(path, Code::Internal, started.error().message, true);
  ChildProcess& child = *started;
  if (watch.started) watch.started(child.id());
  const auto suffix = [&] { return watch.suffix ? watch.suffix() : std::string(); };
  const auto begin = std::chrono::steady_clock::now();
  std::optional<Message> answer;
  for (bool open = true; open;) {
    open = child.read(std::chrono::milliseconds(20));
    if (control.cancelled()) return fail(Code::Cancelled, "cancelled");  // the destructor kills
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > limits.wallSeconds)
      return aboutFile(path, Code::Input, fmt::format("reading it took longer than {} s", limits.wallSeconds),
                       true);
    while (true) {
      auto message = takeMessage(child.out);
      if (!message) return message.error();
      if (!*message) break;
      if ((*message)->kind == MessageKind::Progress)
        control.progress(ByteReader((*message)->content).take<double>());
      else if ((*message)->kind != MessageKind::Store)
        answer = std::move(**message);
      else if (watch.store)
        PILEUS_CHECK(watch.store((*message)->content));
    }
  }
  const int status = child.wait();
  if (answer && answer->kind == MessageKind::Error) {
    ByteReader r(answer->content);
    const auto code = r.take<std::int32_t>();
    return aboutFile(path, code >= 1 && code <= 6 ? static_cast<Code>(code) : Code::Internal,
                     r.takeText() + suffix());
  }
  if (WIFSIGNALED(status)) {
    const int s = WTERMSIG(status);
    if (s == SIGXCPU)
      return aboutFile(path, Code::Input, fmt::format("reading it took longer than {} s", limits.cpuSeconds),
                       true);
    return aboutFile(path, Code::Input,
                     fmt::format("the file is damaged: its reader was stopped by signal {} ({}){}", s,
                                 ::strsignal(s), suffix()));
  }
  if (answer && WIFEXITED(status) && WEXITSTATUS(status) == 0) return std::move(answer->content);
  return aboutFile(
      path, Code::Internal,
      fmt::format("its reader ended with status {} and no answer; {}", status, lastLine(child.err)), true);
}

}  // namespace pileus
