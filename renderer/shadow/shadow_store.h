#pragma once
// All shadow maps live here: one 2D texture array per format, blocks of map layers packed into it. GL thread only; a block keeps its
// store alive.
#include <memory>

#include "renderer/base/enum_info.h"
#include "renderer/base/result.h"
#include "renderer/gl/context.h"
#include "renderer/gl/shader_library.h"
#include "renderer/shaders/shared/records.h"

#include <array>

namespace pileus::shadow {

enum class Storage { Float, Half };
constexpr auto enumInfo(Storage*) {
  return std::array{EnumItem<Storage>{Storage::Float, "float", "Float", "32-bit coefficients: exact to about 1e-6."},
                    EnumItem<Storage>{Storage::Half, "half", "Half", "16-bit coefficients and interval ends: half the memory, errors around 1e-3."}};
}

/// Texel formats of the store.
enum class Texels { Float = 0, Half = 1, Unorm = 2 };

struct ShadowStoreState;

/// A square of `resolution` texels over `layers` consecutive layers; contents undefined until written. Freed with its last owner.
class ShadowBlock {
 public:
  ShadowBlock(std::shared_ptr<ShadowStoreState> store, Texels texels, int resolution, int layers, int sheet, int cell);
  ~ShadowBlock();
  ShadowBlock(const ShadowBlock&) = delete;
  ShadowBlock& operator=(const ShadowBlock&) = delete;

  int resolution() const { return resolution_; }
  int layers() const { return layers_; }
  Texels texels() const { return texels_; }
  std::size_t bytes() const;
  /// Where it lies now (blocks never move, their texture may be replaced by a larger one).
  gpu::BlockRecord record() const;
  GLuint texture() const;   ///< name of the array texture; may change when the store grows
  GLenum format() const;

 private:
  std::shared_ptr<ShadowStoreState> store_;
  Texels texels_;
  int resolution_, layers_, sheet_, cell_;
};

class ShadowStore {
 public:
  ShadowStore(const gl::DeviceInfo& device, std::size_t budgetBytes);
  /// Error (Gpu) names the need and the budget.
  Result<std::shared_ptr<const ShadowBlock>> allocate(Texels texels, int resolution, int layers);
  /// The three arrays to their texture units.
  void bind() const;
  std::size_t bytes() const;

 private:
  std::shared_ptr<ShadowStoreState> state_;
};

}  // namespace pileus::shadow
