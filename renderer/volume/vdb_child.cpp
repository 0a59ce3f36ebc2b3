#include "renderer/volume/vdb_child.h"

#include <malloc.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <new>
#include <thread>

#include "renderer/volume/brick_store.h"
#include "renderer/volume/byte_stream.h"
#include "renderer/volume/vdb_file.h"

namespace pileus::volume {
namespace {

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

/// The pipe to the parent; whatever libraries print goes to standard error instead.
class Speaker {
 public:
  Speaker() : fd_(::dup(1)) { ::dup2(2, 1); }
  void say(MessageKind kind, std::string_view content) {
    const std::string bytes = encodeMessage(kind, content);
    const std::lock_guard lock(mutex_);
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t n = ::write(fd_, bytes.data() + done, bytes.size() - done);
      if (n <= 0) std::_Exit(1);  // the parent has gone
      done += static_cast<std::size_t>(n);
    }
  }
  int fail(const Error& e) {
    say(MessageKind::Error, ByteWriter().put(static_cast<std::int32_t>(e.code)).put(e.message).bytes());
    return static_cast<int>(e.code);
  }

 private:
  int fd_;
  std::mutex mutex_;
};

int work(int argc, char** argv, Speaker& speaker, JobControl& control) {
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
    constexpr std::size_t kPart = std::size_t(1) << 20;
    writeStoreTo(*imported->grid, notes, [&](std::string_view bytes) {
      for (; !bytes.empty(); bytes.remove_prefix(std::min(kPart, bytes.size())))
        speaker.say(MessageKind::Store, bytes.substr(0, kPart));
      return true;
    });
  }
  speaker.say(MessageKind::Done, written ? "" : written.error().message);
  return 0;
}

}  // namespace

int importChildMain(int argc, char** argv) {
  const std::string_view verb = argc > 2 ? argv[2] : "";
  if (!(verb == "inspect" && argc == 6) && !(verb == "grid" && argc == 9)) {
    static constexpr char kWhy[] = "pileus: `import` is internal; use `pileus info FILE`\n";
    return ::write(2, kWhy, sizeof kWhy - 1) > 0 ? 2 : 2;
  }
  limitSelf(argv[argc - 2], argv[argc - 1]);
  const tbb::global_control threads(
      tbb::global_control::max_allowed_parallelism,
      std::min<std::size_t>(std::max(1u, std::thread::hardware_concurrency()), 16));
  Speaker speaker;
  JobControl control;
  std::atomic<bool> over{false};
  std::thread reporter([&] {
    for (double last = 0; !over; std::this_thread::sleep_for(std::chrono::milliseconds(20)))
      if (const double now = control.progress(); now != last)
        speaker.say(MessageKind::Progress, ByteWriter().put(last = now).bytes());
  });
  int status;
  try {
    status = work(argc, argv, speaker, control);
  } catch (const std::bad_alloc&) {
    status = speaker.fail(pileus::fail(Code::Input, "reading it takes more than the {} MiB of memory allowed",
                                       std::strtoull(argv[argc - 2], nullptr, 10) >> 20));
  } catch (const std::exception& e) {
    status = speaker.fail(pileus::fail(Code::Input, "the file is damaged ({})", e.what()));
  } catch (...) {
    status = speaker.fail(pileus::fail(Code::Input, "the file is damaged"));
  }
  over = true;
  reporter.join();
  return status;
}

}  // namespace pileus::volume
