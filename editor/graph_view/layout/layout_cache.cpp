#include "editor/graph_view/layout/layout_cache.h"

#include "editor/app/editor.h"

namespace pileus::editor {

std::shared_ptr<const Layout> shownLayout(Editor& editor) {
  Canvas& canvas = editor.canvas;
  LayoutCache& cache = canvas.cache;
  const MoveGesture& moving = canvas.moving;
  canvas.thumbnails.all = editor.settings.showThumbnails;
  // A frame that is dragged changes what no counter tells.
  const bool same = cache.layout && cache.revision == editor.document.graphRevision() &&
                    cache.moving == moving.active && !moving.frame && cache.moved == moving.by &&
                    cache.raised == editor.document.selection() && cache.thumbnails == canvas.thumbnails &&
                    (cache.frame == editor.frame || !cache.layout->animated);
  if (same) return cache.layout;
  cache.layout = std::make_shared<const Layout>(
      layoutGraph(shownGraph(editor), editor.document.selection(), canvas.thumbnails, editor.frame));
  cache.frame = editor.frame;
  cache.revision = editor.document.graphRevision();
  cache.moving = moving.active;
  cache.moved = moving.by;
  cache.raised = editor.document.selection();
  cache.thumbnails = canvas.thumbnails;
  return cache.layout;
}

}  // namespace pileus::editor
