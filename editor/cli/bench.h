#pragma once
// pileus bench: the tables of docs/bench.md, printed as Markdown.
#include <string>

namespace pileus::cli {

struct BenchOptions {
  std::string data;   ///< folder with test volumes; "" = $PILEUS_TEST_DATA; absent: tables that need it say so
  std::string only;   ///< run only tables whose name contains this
};

int benchMain(const BenchOptions& options);

}  // namespace pileus::cli
