#include "editor/graph_view/layout/layout_cache.h"

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/preferences/settings.h"
#include "editor/time/clock.h"

namespace pileus::editor {

std::shared_ptr<const Layout> shownLayout(const Session& session, const Clock& clock,
                                          const Settings& settings, Canvas& canvas) {
  LayoutCache& cache = canvas.cache;
  const MoveGesture& moving = canvas.moving;
  canvas.thumbnails.all = settings.showThumbnails;
  // A frame that is dragged changes what no counter tells.
  const bool same = cache.layout && cache.revision == session.document.graphRevision() &&
                    cache.moving == moving.active && !moving.frame && cache.moved == moving.by &&
                    cache.raised == session.document.selection() && cache.thumbnails == canvas.thumbnails &&
                    (cache.frame == clock.frame || !cache.layout->animated);
  if (same) return cache.layout;
  cache.layout = std::make_shared<const Layout>(
      layoutGraph(shownGraph(session, canvas), session.document.selection(), canvas.thumbnails, clock.frame));
  cache.frame = clock.frame;
  cache.revision = session.document.graphRevision();
  cache.moving = moving.active;
  cache.moved = moving.by;
  cache.raised = session.document.selection();
  cache.thumbnails = canvas.thumbnails;
  return cache.layout;
}

}  // namespace pileus::editor
