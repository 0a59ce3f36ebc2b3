#include "editor/document/recovery.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>

#include "nodes/file/serialize.h"
#include "renderer/base/file.h"
#include "renderer/base/log.h"

namespace fs = std::filesystem;

namespace pileus::editor {

/// A folder that this process holds: the lock ends with the process, however that ends.
struct Recovery::Set {
  fs::path folder;
  int lock = -1;
  int number = 0;  ///< of the last file; jobs run one at a time
  ~Set() {
    if (lock >= 0) ::close(lock);
  }
  Set() = default;
  Set(const Set&) = delete;
};

namespace {

constexpr char kLockName[] = "lock", kAboutName[] = "about.json";

/// "0001.json"; names sort by age.
std::string fileName(int number) { return fmt::format("{:04}.json", number); }

bool isRecoveryFile(const fs::path& path) {
  const std::string stem = path.stem().string();
  return path.extension() == ".json" && stem.size() >= 4 &&
         stem.find_first_not_of("0123456789") == std::string::npos;
}

std::vector<fs::path> filesOf(const fs::path& set) {
  std::vector<fs::path> files;
  std::error_code ec;
  for (fs::directory_iterator it(set, ec), end; !ec && it != end; it.increment(ec))
    if (isRecoveryFile(it->path())) files.push_back(it->path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Makes the set's folder and takes its lock.
Result<void> create(const fs::path& folder, const fs::path& original, int& lock) {
  std::error_code ec;
  fs::create_directories(folder, ec);
  if (ec) return fail(Code::Input, "{}: cannot be made ({})", folder.string(), ec.message());
  lock = ::open((folder / kLockName).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (lock < 0 || ::flock(lock, LOCK_EX | LOCK_NB) != 0)
    return fail(Code::Input, "{}: cannot be locked", (folder / kLockName).string());
  const nlohmann::json about = {{"path", original.string()}, {"process", ::getpid()}};
  return writeFileAtomic(folder / kAboutName,
                         about.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

Result<void> writeNext(const fs::path& folder, int number, const nodes::Graph& graph) {
  const fs::path file = folder / fileName(number);
  PILEUS_CHECK(writeFileAtomic(file, nodes::graphText(graph)));
  ::chmod(file.c_str(), 0444);  // nobody works in it by accident
  std::error_code ec;
  std::vector<fs::path> files = filesOf(folder);
  for (std::size_t i = 0; i + kRecoveryFiles < files.size(); ++i) fs::remove(files[i], ec);
  return {};
}

/// Is nobody holding the set? Takes the lock for a moment.
bool abandoned(const fs::path& set) {
  const int lock = ::open((set / kLockName).c_str(), O_RDWR | O_CLOEXEC);
  if (lock < 0) return true;
  const bool free = ::flock(lock, LOCK_EX | LOCK_NB) == 0;
  ::close(lock);
  return free;
}

std::int64_t modified(const fs::path& path) {
  struct stat st {};
  return ::stat(path.c_str(), &st) == 0 ? static_cast<std::int64_t>(st.st_mtim.tv_sec) : 0;
}

/// Nothing: there is no work in this set that its document lacks.
std::optional<Lost> lostIn(const fs::path& set) {
  const std::vector<fs::path> files = filesOf(set);
  if (files.empty()) return std::nullopt;
  Lost lost{set, files.back(), {}, modified(files.back())};
  const Result<std::string> text = readFile(set / kAboutName, 1 << 20);
  const nlohmann::json about = text ? nlohmann::json::parse(*text, nullptr, false) : nlohmann::json();
  if (about.is_object() && about.contains("path") && about["path"].is_string())
    lost.original = about["path"].get<std::string>();
  const Result<nodes::Loaded> work = nodes::loadGraph(lost.file);
  if (!work) return std::nullopt;
  if (lost.original.empty()) return lost;
  const Result<nodes::Loaded> saved = nodes::loadGraph(lost.original);
  if (saved && (saved->graph == work->graph || modified(lost.original) > lost.time)) return std::nullopt;
  return lost;
}

}  // namespace

fs::path recoveryFolder() { return stateFolder() / "recovery"; }

Recovery::Recovery(fs::path folder, double restSeconds) : folder_(std::move(folder)), rest_(restSeconds) {}
Recovery::~Recovery() = default;

void Recovery::begin(const nodes::Graph& graph, const fs::path& path) {
  if (!set_) {
    static int sets = 0;
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    set_ = std::make_shared<Set>();
    set_->folder =
        folder_ / fmt::format("{}-{}-{}", std::chrono::duration_cast<std::chrono::seconds>(now).count(),
                              ::getpid(), ++sets);
  }
  job_ = std::make_unique<Job<bool>>([set = set_, graph, path](JobControl&) -> Result<bool> {
    if (set->lock < 0) PILEUS_CHECK(create(set->folder, path, set->lock));
    PILEUS_CHECK(writeNext(set->folder, ++set->number, graph));
    return true;
  });
}

void Recovery::watch(const nodes::Graph& graph, std::uint64_t revision, const fs::path& path, bool dirty,
                     bool resting) {
  if (job_ && job_->done()) {
    if (job_->result())
      ++written_;
    else
      error_ = job_->result().error().message;
    job_.reset();
  }
  if (path != path_) {
    discard();
    path_ = path;
  }
  if (revision != seen_ || !resting) age_.restart();
  seen_ = revision;
  dirty_ = dirty;
  if (!dirty) {
    if (set_ && !job_) discard();
    saved_ = revision;
    return;
  }
  if (revision == saved_ || job_ || age_.ms() < rest_ * 1000) return;
  saved_ = revision;
  begin(graph, path);
}

double Recovery::dueSeconds() const {
  if (job_ || !dirty_ || seen_ == saved_) return -1;
  return std::max(0.0, rest_ - age_.ms() / 1000);
}

Result<void> Recovery::saveNow(const nodes::Graph& graph, const fs::path& path) {
  job_.reset();                  // joins: what it writes is older
  if (path != path_) discard();  // the set of another document, which was given up
  path_ = path;                  // or watch() would take this one for that
  begin(graph, path);
  job_->wait();
  const Result<bool> result = job_->result();
  job_.reset();
  if (!result) return result.error();
  ++written_;
  return {};
}

void Recovery::discard() {
  job_.reset();
  saved_ = 0;
  if (!set_) return;
  std::error_code ec;
  fs::remove_all(set_->folder, ec);
  set_.reset();
}

std::string Recovery::takeError() { return std::exchange(error_, {}); }

std::vector<Lost> findLost(const fs::path& folder) {
  std::vector<Lost> found;
  std::error_code ec;
  std::vector<fs::path> sets;
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec))
    if (it->is_directory(ec)) sets.push_back(it->path());
  for (const fs::path& set : sets) {
    // A folder without a lock may be one that another editor makes right now.
    if (!fs::exists(set / kLockName, ec) || !abandoned(set)) continue;
    if (auto lost = lostIn(set))
      found.push_back(std::move(*lost));
    else
      fs::remove_all(set, ec);
  }
  std::sort(found.begin(), found.end(), [](const Lost& a, const Lost& b) { return a.time > b.time; });
  return found;
}

void removeLost(const Lost& lost) {
  std::error_code ec;
  fs::remove_all(lost.set, ec);
}

}  // namespace pileus::editor
