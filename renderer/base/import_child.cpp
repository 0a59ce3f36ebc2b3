// The child's side of import_child.h, and the messages.
#include "renderer/base/import_child.h"

#include <malloc.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <new>
#include <thread>

#include "renderer/base/byte_stream.h"

namespace pileus {
namespace {

constexpr std::uint32_t kMaxMessage = 64u << 20;

void limit(__rlimit_resource resource, rlim_t value, rlim_t hard) {
  rlimit r{value, hard};
  rlimit old{};
  if (::getrlimit(resource, &old) == 0) {
    r.rlim_max = std::min(r.rlim_max, old.rlim_max);
    r.rlim_cur = std::min(r.rlim_cur, r.rlim_max);
  }
  ::setrlimit(resource, &r);
}

void limitSelf(const char* memoryBytes, const char* cpuSeconds) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // dies with its parent
  limit(RLIMIT_CORE, 0, 0);
  const rlim_t cpu = std::strtoull(cpuSeconds, nullptr, 10);
  limit(RLIMIT_CPU, cpu, cpu + 2);
#if !defined(__SANITIZE_ADDRESS__)  // whose shadow memory takes terabytes of address space
  const rlim_t memory = std::strtoull(memoryBytes, nullptr, 10);
  limit(RLIMIT_AS, memory, memory);
#else
  (void)memoryBytes;
#endif
  ::mallopt(M_ARENA_MAX, 2);  // an arena per thread would eat the address space on large machines
}

}  // namespace

std::string encodeMessage(MessageKind kind, std::string_view content) {
  std::string out(1, static_cast<char>(kind));
  return out + ByteWriter().put(content).bytes();
}

Result<std::optional<Message>> takeMessage(std::string& buffer) {
  if (buffer.size() < 5) return std::optional<Message>();
  std::uint32_t size;
  std::memcpy(&size, buffer.data() + 1, sizeof size);
  if (std::string_view("PEISD").find(buffer[0]) == std::string_view::npos || size > kMaxMessage)
    return fail(Code::Internal, "the importer said something that is no message");
  if (buffer.size() < 5 + std::size_t(size)) return std::optional<Message>();
  Message m{static_cast<MessageKind>(buffer[0]), buffer.substr(5, size)};
  buffer.erase(0, 5 + std::size_t(size));
  return std::optional<Message>(std::move(m));
}

struct ImportVoice::Pipe {
  int fd = -1;
  std::mutex mutex;
};

ImportVoice::ImportVoice() : pipe_(std::make_unique<Pipe>()) {
  pipe_->fd = ::dup(1);
  ::dup2(2, 1);
}
ImportVoice::~ImportVoice() = default;

void ImportVoice::say(MessageKind kind, std::string_view content) {
  const std::string bytes = encodeMessage(kind, content);
  const std::lock_guard lock(pipe_->mutex);
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::write(pipe_->fd, bytes.data() + done, bytes.size() - done);
    if (n <= 0) std::_Exit(1);  // the parent has gone
    done += static_cast<std::size_t>(n);
  }
}

void ImportVoice::sayStore(std::string_view bytes) {
  constexpr std::size_t kPart = std::size_t(1) << 20;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(kPart, bytes.size())))
    say(MessageKind::Store, bytes.substr(0, kPart));
}

int ImportVoice::fail(const Error& e) {
  say(MessageKind::Error, ByteWriter().put(static_cast<std::int32_t>(e.code)).put(e.message).bytes());
  return static_cast<int>(e.code);
}

int runAsImportChild(const char* memoryBytes, const char* cpuSeconds,
                     const std::function<int(ImportVoice&, JobControl&)>& work) {
  limitSelf(memoryBytes, cpuSeconds);
  const tbb::global_control threads(
      tbb::global_control::max_allowed_parallelism,
      std::min<std::size_t>(std::max(1u, std::thread::hardware_concurrency()), 16));
  ImportVoice voice;
  JobControl control;
  std::atomic<bool> over{false};
  std::thread reporter([&] {
    for (double last = 0; !over; std::this_thread::sleep_for(std::chrono::milliseconds(20)))
      if (const double now = control.progress(); now != last)
        voice.say(MessageKind::Progress, ByteWriter().put(last = now).bytes());
  });
  int status;
  try {
    status = work(voice, control);
  } catch (const std::bad_alloc&) {
    status = voice.fail(pileus::fail(Code::Input, "reading it takes more than the {} MiB of memory allowed",
                                     std::strtoull(memoryBytes, nullptr, 10) >> 20));
  } catch (const std::exception& e) {
    status = voice.fail(pileus::fail(Code::Input, "the file is damaged ({})", e.what()));
  } catch (...) {
    status = voice.fail(pileus::fail(Code::Input, "the file is damaged"));
  }
  over = true;
  reporter.join();
  return status;
}

int refuseImportByHand() {
  static constexpr char kWhy[] = "pileus: `import` is internal; use `pileus info FILE`\n";
  return ::write(2, kWhy, sizeof kWhy - 1) > 0 ? 2 : 2;
}

}  // namespace pileus
