#include "editor/cli/nodes.h"

#include <cstdio>
#include <string>

#include "nodes/file/docs_export.h"

namespace pileus::cli {

int nodesMain(NodesFormat format) {
  std::string text;
  switch (format) {
    case NodesFormat::Text:
      text = nodes::nodesText();
      break;
    case NodesFormat::Markdown:
      text = nodes::nodesMarkdown();
      break;
    case NodesFormat::Json:
      text = nodes::nodesJson();
      break;
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
  return 0;
}

}  // namespace pileus::cli
