#pragma once
// What the shaders of a pass read at random besides voxels and maps, in one buffer texture cut into sections
// (shaders/lib/scene_table.glsl): a pass has sixteen texture units. A section is replaced without the others
// being uploaded again. GL thread.
#include <array>
#include <span>
#include <vector>

#include "renderer/base/result.h"
#include "renderer/gl/buffer.h"
#include "renderer/gl/shader_library.h"

namespace pileus::residency {

class SceneTable {
 public:
  enum class Section {
    Volumes,      ///< VolumeRecords, then tables of densities and LevelRecords; begins at texel 0
    TileOffsets,  ///< numbers, four to a texel
    TileItems,    ///< numbers
    ShadowItems,  ///< numbers
    Solids,       ///< SolidRecords
    Air           ///< of each sun behind air SUN_HEIGHTS texels
  };
  static constexpr std::size_t kSections = 6;

  /// Replaces a section; uploaded by the next bind(), and only where it is not what is there.
  template <class T>
  void set(Section section, std::span<const T> content) {
    set(section, content.data(), content.size_bytes());
  }
  /// Behind every set(): to its binding point, and where sections begin into the program. Error (Gpu) where
  /// the driver has no buffer textures that long.
  Result<void> bind(gl::Program& program);

 private:
  struct Part {
    std::vector<uvec4> texels;
    std::size_t bytes = 0;  ///< of them
    std::size_t first = 0, room = 0;
    bool changed = false;
  };
  void set(Section section, const void* data, std::size_t bytes);
  Result<void> layOut();
  std::array<Part, kSections> parts_;
  gl::Buffer buffer_{"scene table"};
};

}  // namespace pileus::residency
