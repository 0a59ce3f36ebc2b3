// main() of every test: fails a test that logs an unexpected warning or error, or that compiles a shader the
// reference compiler refuses, and keeps caches out of the user's home.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string_view>

#include "renderer/base/log.h"
#include "renderer/image/environment_import.h"
#include "renderer/volume/vdb_child.h"
#include "tests/support/reference_compiler.h"
#include "tests/support/support.h"

namespace {

int expected = 0;

std::size_t troubles() {
  return pileus::log::count(pileus::log::Level::Warning) + pileus::log::count(pileus::log::Level::Error);
}

class LogGuard : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override { before_ = troubles(); }
  void OnTestEnd(const testing::TestInfo&) override {
    if (expected == 0 && troubles() > before_ + allowed_) {
      const auto lines = pileus::log::history();
      ADD_FAILURE() << "unexpected warning in the log: " << (lines.empty() ? "" : lines.back().text);
    }
    allowed_ = 0;
    const std::string refused = pileus::test::refusedPrograms(pileus::test::compiledPrograms());
    if (!refused.empty()) ADD_FAILURE() << "the reference compiler refuses " << refused;
  }
  std::size_t before_ = 0;

 public:
  static inline std::size_t allowed_ = 0;
};

}  // namespace

namespace pileus::test {
namespace {
std::size_t atStart = 0;
}
ExpectLogged::ExpectLogged() {
  ++expected;
  atStart = troubles();
}
bool ExpectLogged::lives() { return expected > 0; }
ExpectLogged::~ExpectLogged() {
  --expected;
  LogGuard::allowed_ += troubles() - atStart;
}
}  // namespace pileus::test

int main(int argc, char** argv) {
  // Tests that read volumes start their own executable as the child that parses them.
  if (pileus::image::isEnvironmentChild(argc, argv)) return pileus::image::environmentChildMain(argc, argv);
  if (argc > 1 && std::string_view(argv[1]) == "import") return pileus::volume::importChildMain(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  if (!std::getenv("XDG_CACHE_HOME")) ::setenv("XDG_CACHE_HOME", pileus::test::scratchFolder().c_str(), 1);
  if (!std::getenv("XDG_CONFIG_HOME")) ::setenv("XDG_CONFIG_HOME", pileus::test::scratchFolder().c_str(), 1);
  // Compiled shaders are kept for the next run, of this test or of another.
  const std::filesystem::path cache = std::filesystem::path(PILEUS_BINARY).parent_path() / "shader_cache";
  ::setenv("MESA_SHADER_CACHE_DIR", cache.c_str(), 0);
  if (pileus::test::hasReferenceCompiler())
    ::setenv("PILEUS_SHADER_SOURCES", pileus::test::compiledPrograms().c_str(), 0);
  testing::UnitTest::GetInstance()->listeners().Append(new LogGuard);
  return RUN_ALL_TESTS();
}
