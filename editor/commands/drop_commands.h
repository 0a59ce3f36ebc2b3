#pragma once
// What becomes of files that came from outside: a graph is opened or merged, a volume becomes a lit cloud, a
// still gives back its graph.
namespace pileus::editor {

struct Editor;

/// Between two frames. Returns whether files had been read.
bool takeDrops(Editor& editor);
/// File > Import VDB...
void askImportVdb(Editor& editor);

}  // namespace pileus::editor
