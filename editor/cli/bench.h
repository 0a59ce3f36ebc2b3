#pragma once
// pileus bench: the tables of docs/bench.md, printed as Markdown.
#include <functional>
#include <string>

namespace pileus::cli {

struct BenchOptions {
  std::string data;  ///< folder with test volumes; "" = $PILEUS_TEST_DATA; absent: tables that need it say so
  std::string plot;  ///< SVG file for the table "curve"; "": none
  std::string only;  ///< run only tables whose name contains this
};

/// `window`: measures in a real window; returns an exit code.
int benchMain(const BenchOptions& options, const std::function<int()>& window);

}  // namespace pileus::cli
