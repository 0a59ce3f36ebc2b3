#include "renderer/residency/majorants.h"

#include <algorithm>
#include <bit>

#include "renderer/shaders/shared/path.h"

namespace pileus::residency {
namespace {

constexpr double kRounding = 1e-5;  ///< of the arithmetic between a brick's bytes and sigma_t

double boundOf(const volume::Instance& i, const volume::Brick& b, double extinction) {
  const bool stored = b.payload != volume::kConstantBrick;
  // The positions it answers for, and those next to them in its near apron.
  const double low = std::min(double(b.minimum), double(b.offset)),
               high = std::max(double(b.maximum), stored ? double(b.offset) + double(b.scale) : 0.0);
  const double density = i.remap ? i.remap->largest(std::min(low, stored ? low : 0.0), high) : high;
  return std::max(density * extinction, 0.0) * (1 + kRounding);
}

}  // namespace

std::vector<float> majorantsOf(const volume::Instance& i, int level, double scale) {
  const volume::Level& bricks = i.grid->levels[std::size_t(level)];
  const double extinction = i.emission ? 0.0 : i.medium.meanExtinction() * scale;
  std::vector<float> out;
  out.reserve(bricks.table.size() * 65 / 64 + 1);
  for (const volume::Brick& b : bricks.table) out.push_back(float(boundOf(i, b, extinction)));
  const ivec3 blocks = (bricks.bricks + kBlockBricks - 1) / kBlockBricks;
  for (int z = 0; z < blocks.z; ++z)
    for (int y = 0; y < blocks.y; ++y)
      for (int x = 0; x < blocks.x; ++x) {
        const ivec3 lo = kBlockBricks * ivec3(x, y, z), hi = glm::min(lo + kBlockBricks, bricks.bricks);
        float most = 0;
        for (int c = lo.z; c < hi.z; ++c)
          for (int b = lo.y; b < hi.y; ++b)
            for (int a = lo.x; a < hi.x; ++a)
              most = std::max(most, out[std::size_t((c * bricks.bricks.y + b) * bricks.bricks.x + a)]);
        out.push_back(most);
      }
  return out;
}

Result<void> Majorants::make(const volume::InstanceList& instances, const BrickPool& pool,
                             const gl::DeviceInfo& device, double scale) {
  std::vector<std::uint32_t> texels(2 * std::max<std::size_t>(instances.size(), 1), 0);
  for (std::size_t v = 0; v < instances.size(); ++v) {
    const volume::Instance& i = instances[v];
    const ResidentGrid* place = i.shape == volume::Shape::Grid && i.grid ? pool.find(*i.grid) : nullptr;
    if (!place) continue;
    texels[2 * v] = std::uint32_t(texels.size());
    texels[2 * v + 1] =
        std::uint32_t(texels.size() + i.grid->levels[std::size_t(place->finest)].table.size());
    for (const float bound : majorantsOf(i, place->finest, scale))
      texels.push_back(std::bit_cast<std::uint32_t>(bound));
  }
  if (texels.size() > device.maxBufferTexels)
    return fail(Code::Gpu,
                "bounds of {} volumes take {} texels; this OpenGL driver has buffer textures of {}: use "
                "smaller or coarser grids, or fewer",
                instances.size(), texels.size(), device.maxBufferTexels);
  return texels_.assign(std::span<const std::uint32_t>(texels));
}

void Majorants::bind() const { texels_.bindTexels(UNIT_MAJORANTS, GL_R32UI); }

}  // namespace pileus::residency
