#pragma once
// What was going on when the program crashed: the last events are kept in memory, and a fatal signal writes
// them to a file together with the graph, the GPU and the version. The next start says so.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pileus::editor::crash {

/// Where reports lie: crashes/ in the state folder.
std::filesystem::path folder();

/// Handles SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT from now on. `where`: the folder for reports.
void install(const std::filesystem::path& where = folder());
/// Facts for the report; cut at 500 bytes.
void setGraph(std::string_view path);
void setDevice(std::string_view text);
/// One more event of the last 200; cut at 95 bytes. Any thread; cheap.
void note(std::string_view text);
/// The kept events, oldest first: what a report would list.
std::vector<std::string> events();

/// Reports that no start has mentioned yet; they count as mentioned from now on.
std::vector<std::filesystem::path> takeNewReports(const std::filesystem::path& where = folder());

}  // namespace pileus::editor::crash
