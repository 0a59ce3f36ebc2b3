#pragma once
// Files of hostile hands are decoded by a child process of the same binary, under limits: libraries may hang,
// crash or exhaust memory on them and cannot be interrupted; cancelling kills the child. What both sides say
// to each other, and how each of them runs. Parent: any thread.
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/jobs.h"
#include "renderer/base/result.h"

namespace pileus {

struct ImportLimits {
  std::uint64_t memoryBytes = std::uint64_t(8) << 30;  ///< address space of the child
  double cpuSeconds = 900;
  double wallSeconds = 900;
  std::filesystem::path executable;  ///< who is run as `<executable> import ..`; empty: this executable
};

/// A message: one byte kind, four bytes length, content.
enum class MessageKind : char {
  Progress = 'P',  ///< double
  Error = 'E',     ///< int32 Code, text
  Info = 'I',      ///< the answer
  Store = 'S',     ///< a part of something large; all of them together are it
  Done = 'D',      ///< the answer where there is a store
};
std::string encodeMessage(MessageKind kind, std::string_view content);
struct Message {
  MessageKind kind;
  std::string content;
};
/// Takes the first whole message off `buffer`; nothing yet: nullopt. An Error: the bytes are no message.
Result<std::optional<Message>> takeMessage(std::string& buffer);

/// An error about a file: its path, then the reason, of a length that can be shown. `passing`: the file is
/// not to blame, it may be read later.
Error aboutFile(const std::filesystem::path& path, Code code, std::string_view reason, bool passing = false);

/// What the parent does beside waiting. Each may be null.
struct ImportWatch {
  std::function<void(long process)> started;
  std::function<Result<void>(std::string_view part)> store;  ///< for each MessageKind::Store
  std::function<std::string()> suffix;                       ///< behind what is wrong with the file
};

/// Runs `<executable> import ARGUMENTS MEMORY CPU` to its end and returns the content of its Info or Done
/// message. Errors: Input (about the file), Cancelled, Internal (the child could not be run).
Result<std::string> runImportChild(const std::filesystem::path& path, std::vector<std::string> arguments,
                                   JobControl& control, const ImportLimits& limits,
                                   const ImportWatch& watch = {});

/// The child's side of the pipe; whatever libraries print goes to standard error instead. Any thread.
class ImportVoice {
 public:
  ImportVoice();
  ~ImportVoice();
  void say(MessageKind kind, std::string_view content);
  /// In messages of a megabyte.
  void sayStore(std::string_view bytes);
  int fail(const Error& e);  ///< the exit status

 private:
  struct Pipe;
  std::unique_ptr<Pipe> pipe_;
};

/// The child: takes the limits upon itself (bytes of address space, seconds), reports the control's progress
/// and turns what is thrown into an error about the file. Returns the exit status.
int runAsImportChild(const char* memoryBytes, const char* cpuSeconds,
                     const std::function<int(ImportVoice&, JobControl&)>& work);

/// What the hidden subcommand says to people.
int refuseImportByHand();

}  // namespace pileus
