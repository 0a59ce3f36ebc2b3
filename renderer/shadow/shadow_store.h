#pragma once
// All shadow maps live here: one 2D texture array per format, blocks of map layers packed into it, narrow
// ones side by side. GL thread only; a block keeps its store alive.
#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "renderer/base/result.h"
#include "renderer/gl/shader_library.h"
#include "renderer/shaders/shared/records.h"

namespace pileus::shadow {

/// Texel formats of the store.
enum class Texels {
  Float = STORE_FLOAT,
  Half = STORE_HALF,
  Unorm = STORE_UNORM,
  Byte = STORE_BYTE,
  Pair = STORE_PAIR
};

struct ShadowStoreState;

/// A square of `resolution` texels over `layers` consecutive layers, `faces` times; contents undefined until
/// written. Freed with its last owner.
class ShadowBlock {
 public:
  ShadowBlock(std::shared_ptr<ShadowStoreState> store, Texels texels, int resolution, int layers, int faces,
              std::size_t place);
  ~ShadowBlock();
  ShadowBlock(const ShadowBlock&) = delete;
  ShadowBlock& operator=(const ShadowBlock&) = delete;

  int resolution() const { return resolution_; }
  int layers() const { return layers_; }  ///< of one face
  int faces() const { return faces_; }
  Texels texels() const { return texels_; }
  std::size_t bytes() const;
  /// Where it lies now. Every allocate() may move it, to another place in another texture: records and
  /// bindings are made anew behind it.
  gpu::BlockRecord record() const;
  GLuint texture() const;  ///< name of the array texture, likewise
  GLenum format() const;

 private:
  std::shared_ptr<ShadowStoreState> store_;
  Texels texels_;
  int resolution_, layers_, faces_;
  std::size_t place_;
};

/// A run of 8-byte elements for one deep map: a header (first vertex, count) for each texel, then the
/// vertices (x, T) of all.
class DeepBlock {
 public:
  DeepBlock(std::shared_ptr<ShadowStoreState> store, std::size_t first, std::size_t count)
      : store_(std::move(store)), first_(first), count_(count) {}
  ~DeepBlock();
  DeepBlock(const DeepBlock&) = delete;
  DeepBlock& operator=(const DeepBlock&) = delete;
  std::size_t first() const { return first_; }
  std::size_t count() const { return count_; }
  std::size_t bytes() const { return count_ * 8; }
  void write(std::size_t at, std::span<const uvec2> elements) const;  ///< relative to first()
  std::vector<uvec2> read(std::size_t at, std::size_t count) const;
  void bindImage(GLuint unit) const;  ///< the whole buffer, for writing

 private:
  std::shared_ptr<ShadowStoreState> store_;
  std::size_t first_, count_;
};

class ShadowStore {
 public:
  /// Lets go of maps that nobody waits for, of at least so many bytes where there are as many; false: of
  /// none.
  using Reclaim = std::function<bool(std::size_t bytes)>;

  explicit ShadowStore(std::size_t budgetBytes);
  /// Asked, and asked again, where a map does not fit: one for each owner, who takes it back with null. It
  /// frees blocks and makes none.
  void setReclaim(const void* owner, Reclaim reclaim);
  /// Error (Gpu) names the need and the budget, or the limit of the driver.
  Result<std::shared_ptr<const ShadowBlock>> allocate(Texels texels, int resolution, int layers,
                                                      int faces = 1);
  Result<std::shared_ptr<const DeepBlock>> allocateDeep(std::size_t elements);
  /// Every array and the deep buffer to their texture units.
  void bind() const;
  std::size_t bytes() const;      ///< of its textures and buffers
  std::size_t usedBytes() const;  ///< of the maps that lie there

 private:
  std::shared_ptr<ShadowStoreState> state_;
};

}  // namespace pileus::shadow
