#pragma once
// Small pictures of graphs: those of the presets are part of the program, those of the user's files are kept
// in the cache folder when a document is saved. UI thread.
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "renderer/base/hash.h"
#include "renderer/base/jobs.h"
#include "renderer/gl/texture.h"

namespace pileus::editor {

/// Where the picture of a graph file is kept, whether or not there is one.
std::filesystem::path thumbnailPath(const std::filesystem::path& graph);

/// Averages blocks of an 8-bit RGBA picture so that it is at most `longest` wide and high; opaque.
struct SmallPicture {
  ivec2 size{0};
  std::vector<float> rgba;
};
SmallPicture reducedPicture(ivec2 size, const std::vector<unsigned char>& rgba, int longest);

/// What an RGBA8 texture holds; nothing of texture 0. GL thread.
struct TexturePixels {
  ivec2 size{0};
  std::vector<unsigned char> rgba;
};
TexturePixels readTexture(unsigned texture);

class GraphPictures {
 public:
  struct Shown {
    unsigned texture = 0;  ///< 0: there is none (yet)
    ivec2 size{0};
  };
  /// At most one picture is decoded a frame.
  void beginFrame() { loaded_ = false; }
  bool wantsFrame() const { return loaded_; }  ///< others may be waiting for their turn
  Shown preset(std::string_view name);         ///< "default.json"
  Shown file(const std::filesystem::path& graph);
  /// The PNG beside a preset of one's own; `stamp` is another one when the preset was written anew.
  Shown beside(const std::filesystem::path& preset, Key stamp);
  /// Keeps what `texture` (RGBA8, display-referred) shows as the picture of this file: a job writes it.
  void keep(unsigned texture, const std::filesystem::path& graph);
  void forget(const std::filesystem::path& graph) { files_.erase(graph.string()); }

 private:
  struct Entry {
    gl::Texture texture;
    ivec2 size{0};
  };
  Shown load(std::map<std::string, Entry>& in, const std::string& key, std::string_view bytes);
  std::map<std::string, Entry> presets_, files_, own_;
  std::unique_ptr<Job<bool>> writing_;
  bool loaded_ = false;
};

}  // namespace pileus::editor
