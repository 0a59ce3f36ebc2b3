#pragma once
// Pictures on nodes: what an image node shows, light from everywhere, and the coefficients of a shadow map.
// Made when they are first seen, and again when what they show has changed; while frames go by, once a
// second, and when they rest.
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "editor/graph_view/draw_node.h"
#include "renderer/gl/texture.h"

namespace pileus::editor {

struct Canvas;
struct Clock;
struct GraphRoom;
struct Session;
struct Settings;
struct Shown;
struct Ui;

class Thumbnails {
 public:
  NodePicture image(const Session& session, const Clock& clock, Shown& shown, const std::string& name);
  /// All directions of an environment or a sky, azimuth 0 in the middle.
  NodePicture environment(const Session& session, const Clock& clock, Shown& shown, const std::string& name);
  NodePicture map(const Session& session, const Clock& clock, const Shown& shown, const std::string& name,
                  const nodes::NodeType& type);
  /// Those of nodes that are gone go, and their textures are used again.
  void prune(const nodes::Graph& graph);
  std::size_t count() const { return entries_.size(); }
  /// Of the picture that is there; 0 = none is.
  int frameOf(const std::string& name) const;

 private:
  struct Entry {
    std::weak_ptr<const void> source;  ///< what it was made from
    double fraction = -1, madeAt = -1;
    int frame = 0;
    std::string display;  ///< settings of the display transform
    int slot = 0;         ///< of the display's textures
    gl::Texture texture;  ///< of a map
    NodePicture picture;
  };
  /// Another frame is shown, but soon the next one: what is there stays for now.
  bool passing(const Clock& clock, const Shown& shown, const Entry& e) const;
  void made(const Shown& shown, Entry& e);
  /// Texels through the display transform of what is shown, without its marks, into the entry's picture.
  void draw(const Session& session, const Clock& clock, Shown& shown, const gl::Texture& texels, ivec2 size,
            Entry& e);

  std::map<std::string, Entry> entries_;
  std::vector<int> freeSlots_;
  int slots_ = 0;
};

NodePicture nodePicture(const GraphRoom& room, const NodePlace& place);
/// Shift+H: turns the pictures of the selected nodes on or off together.
void toggleThumbnails(Ui& ui, const Session& session, const Settings& settings, Canvas& canvas);

}  // namespace pileus::editor
