#include "renderer/shadow/shadow_store.h"

#include <algorithm>
#include <bit>
#include <map>
#include <vector>

#include "renderer/gl/texture.h"
#include "renderer/shaders/shared/bindings.h"

namespace pileus::shadow {
namespace {

/// A run of layers cut into equal power-of-two cells.
struct Sheet {
  int firstLayer = 0, layers = 0, cellEdge = 0, across = 0;
  std::vector<bool> used;
  bool empty() const {
    return std::none_of(used.begin(), used.end(), [](bool u) { return u; });
  }
};

struct Array {
  gl::Texture texture;
  gl::Texture bits;           ///< half only: its texels as they are stored, unfiltered
  std::vector<Sheet> sheets;  ///< index is stable; layers == 0: unused entry
};

constexpr int kArrays = 5;
constexpr GLenum kFormats[kArrays] = {GL_RGBA32F, GL_RGBA16F, GL_RGBA16, GL_RGBA8, GL_RG16F};
constexpr const char* kLabels[kArrays] = {"shadow store float", "shadow store half", "shadow store unorm",
                                          "shadow store byte", "shadow store pair"};
constexpr int kUnits[kArrays] = {UNIT_SHADOW_FLOAT, UNIT_SHADOW_HALF, UNIT_SHADOW_UNORM, UNIT_SHADOW_BYTE,
                                 UNIT_SHADOW_PAIR};
constexpr std::size_t kDeepElement = sizeof(uvec2);

/// The vertices of all deep maps in one buffer texture. Ranges never move; the buffer grows by doubling.
struct DeepArena {
  GLuint buffer = 0, texels = 0;
  std::size_t capacity = 0;                  ///< elements
  std::map<std::size_t, std::size_t> taken;  ///< first -> count

  DeepArena() = default;
  DeepArena(const DeepArena&) = delete;
  DeepArena& operator=(const DeepArena&) = delete;
  ~DeepArena() {
    glDeleteTextures(1, &texels);
    glDeleteBuffers(1, &buffer);
  }
  std::size_t freeRange(std::size_t count) const {
    std::size_t at = 0;
    for (const auto& [first, n] : taken) {
      if (first - at >= count) return at;
      at = first + n;
    }
    return at;
  }
  void grow(std::size_t elements) {
    GLuint larger = 0;
    glCreateBuffers(1, &larger);
    glNamedBufferStorage(larger, GLsizeiptr(elements * kDeepElement), nullptr, GL_DYNAMIC_STORAGE_BIT);
    if (buffer) glCopyNamedBufferSubData(buffer, larger, 0, 0, GLsizeiptr(capacity * kDeepElement));
    glDeleteBuffers(1, &buffer);
    buffer = larger;
    capacity = elements;
    if (!texels) glCreateTextures(GL_TEXTURE_BUFFER, 1, &texels);
    glTextureBuffer(texels, GL_RG32UI, buffer);
    glObjectLabel(GL_BUFFER, buffer, -1, "deep shadow maps");
  }
};

}  // namespace

struct ShadowStoreState {
  gl::DeviceInfo device;
  std::size_t budget = 0;
  Array arrays[kArrays];
  DeepArena deep;

  /// First layer of a free run, or the layer after the last used one.
  static int freeRun(const Array& a, int layers, int depth) {
    std::vector<bool> taken(std::size_t(std::max(depth, 0)), false);
    int end = 0;
    for (const Sheet& s : a.sheets)
      for (int l = 0; l < s.layers; ++l) {
        taken[std::size_t(s.firstLayer + l)] = true;
        end = std::max(end, s.firstLayer + l + 1);
      }
    for (int first = 0, run = 0, l = 0; l < depth; ++l) {
      run = taken[std::size_t(l)] ? 0 : run + 1;
      if (run == 0) first = l + 1;
      if (run == layers) return first;
    }
    return end;
  }

  Result<void> grow(int kind, int edge, int depth) {
    Array& a = arrays[kind];
    const ivec3 old = a.texture ? a.texture.size() : ivec3(0);
    const ivec3 size(std::max(edge, old.x), std::max(edge, old.y), std::max(depth, old.z));
    if (size == old) return {};
    const std::size_t bytes =
        gl::texelBytes(kFormats[kind]) * std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    std::size_t others = deep.capacity * kDeepElement;
    for (int k = 0; k < kArrays; ++k)
      if (k != kind) others += arrays[k].texture.bytes();
    if (size.x > device.maxTextureSize || size.z > device.maxArrayLayers || bytes + others > budget)
      return fail(Code::Gpu,
                  "shadow maps would need {} MiB ({} x {} texels, {} layers); {} MiB are set aside for them",
                  (bytes + others) >> 20, size.x, size.y, size.z, budget >> 20);
    while (glGetError() != GL_NO_ERROR) {
    }
    gl::Texture grown(GL_TEXTURE_2D_ARRAY, kFormats[kind], size, kLabels[kind]);
    grown.filter(GL_LINEAR);
    if (glGetError() == GL_OUT_OF_MEMORY)
      return fail(Code::Gpu, "out of GPU memory: {} MiB for shadow maps", bytes >> 20);
    if (a.texture)
      glCopyImageSubData(a.texture.id(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, grown.id(), GL_TEXTURE_2D_ARRAY, 0,
                         0, 0, 0, old.x, old.y, old.z);
    a.texture = std::move(grown);
    if (kind == STORE_HALF) a.bits = gl::Texture::view(a.texture, GL_RG32UI, "shadow store half, as bits");
    return {};
  }
};

ShadowBlock::ShadowBlock(std::shared_ptr<ShadowStoreState> store, Texels texels, int resolution, int layers,
                         int faces, int sheet, int cell)
    : store_(std::move(store)),
      texels_(texels),
      resolution_(resolution),
      layers_(layers),
      faces_(faces),
      sheet_(sheet),
      cell_(cell) {}

ShadowBlock::~ShadowBlock() {
  Sheet& s = store_->arrays[int(texels_)].sheets[std::size_t(sheet_)];
  s.used[std::size_t(cell_)] = false;
  if (s.empty()) s = Sheet{};
}

std::size_t ShadowBlock::bytes() const {
  return gl::texelBytes(format()) * std::size_t(resolution_) * std::size_t(resolution_) *
         std::size_t(layers_ * faces_);
}

gpu::BlockRecord ShadowBlock::record() const {
  const Sheet& s = store_->arrays[int(texels_)].sheets[std::size_t(sheet_)];
  return {ivec4((cell_ % s.across) * s.cellEdge, (cell_ / s.across) * s.cellEdge, resolution_, s.firstLayer),
          ivec4(int(texels_), layers_, faces_, 0)};
}

DeepBlock::~DeepBlock() { store_->deep.taken.erase(first_); }

void DeepBlock::write(std::size_t at, std::span<const uvec2> elements) const {
  glNamedBufferSubData(store_->deep.buffer, GLintptr((first_ + at) * kDeepElement),
                       GLsizeiptr(elements.size_bytes()), elements.data());
}

std::vector<uvec2> DeepBlock::read(std::size_t at, std::size_t count) const {
  std::vector<uvec2> out(count);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  if (count > 0)
    glGetNamedBufferSubData(store_->deep.buffer, GLintptr((first_ + at) * kDeepElement),
                            GLsizeiptr(count * kDeepElement), out.data());
  return out;
}

void DeepBlock::bindImage(GLuint unit) const {
  glBindImageTexture(unit, store_->deep.texels, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32UI);
}

GLuint ShadowBlock::texture() const { return store_->arrays[int(texels_)].texture.id(); }
GLenum ShadowBlock::format() const { return kFormats[int(texels_)]; }

ShadowStore::ShadowStore(const gl::DeviceInfo& device, std::size_t budgetBytes)
    : state_(std::make_shared<ShadowStoreState>()) {
  state_->device = device;
  state_->budget = budgetBytes;
}

Result<std::shared_ptr<const ShadowBlock>> ShadowStore::allocate(Texels texels, int resolution, int layers,
                                                                 int faces) {
  Array& a = state_->arrays[int(texels)];
  const int edge = int(std::bit_ceil(unsigned(std::max(resolution, 16))));
  const auto take = [&](std::size_t sheet, std::size_t cell) {
    a.sheets[sheet].used[cell] = true;
    return std::make_shared<const ShadowBlock>(state_, texels, resolution, layers, faces, int(sheet),
                                               int(cell));
  };
  for (std::size_t i = 0; i < a.sheets.size(); ++i) {
    const Sheet& s = a.sheets[i];
    if (s.layers != layers * faces || s.cellEdge != edge) continue;
    for (std::size_t c = 0; c < s.used.size(); ++c)
      if (!s.used[c]) return take(i, c);
  }
  const int depth = a.texture ? a.texture.size().z : 0;
  const int first = ShadowStoreState::freeRun(a, layers * faces, depth);
  PILEUS_CHECK(state_->grow(int(texels), edge, first + layers * faces));
  const int across = a.texture.size().x / edge;
  std::size_t index = 0;
  while (index < a.sheets.size() && a.sheets[index].layers != 0) ++index;
  if (index == a.sheets.size()) a.sheets.emplace_back();
  a.sheets[index] = {first, layers * faces, edge, across,
                     std::vector<bool>(std::size_t(across) * std::size_t(across), false)};
  return take(index, 0);
}

Result<std::shared_ptr<const DeepBlock>> ShadowStore::allocateDeep(std::size_t elements) {
  DeepArena& arena = state_->deep;
  elements = std::max<std::size_t>(elements, 1);
  const std::size_t first = arena.freeRange(elements), end = first + elements;
  if (end > arena.capacity) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
    std::size_t others = 0;
    for (const Array& a : state_->arrays) others += a.texture.bytes();
    const std::size_t wanted = std::max(end, std::min(2 * arena.capacity, std::size_t(limit)));
    if (end > std::size_t(limit))
      return fail(Code::Gpu,
                  "deep shadow maps would hold {} vertices and texels, the buffer textures of this OpenGL "
                  "driver {}: raise the error bound or lower the resolution",
                  end, limit);
    if (others + end * kDeepElement > state_->budget)
      return fail(Code::Gpu,
                  "a deep shadow map needs {} MiB more; {} MiB are set aside for shadow maps: raise its "
                  "error bound or lower its resolution",
                  (elements * kDeepElement) >> 20, state_->budget >> 20);
    arena.grow(others + wanted * kDeepElement > state_->budget ? end : wanted);
  }
  arena.taken.emplace(first, elements);
  return std::make_shared<const DeepBlock>(state_, first, elements);
}

void ShadowStore::bind() const {
  for (int k = 0; k < kArrays; ++k) glBindTextureUnit(GLuint(kUnits[k]), state_->arrays[k].texture.id());
  glBindTextureUnit(UNIT_SHADOW_HALF_BITS, state_->arrays[STORE_HALF].bits.id());
  glBindTextureUnit(UNIT_SHADOW_DEEP, state_->deep.texels);
}

std::size_t ShadowStore::bytes() const {
  std::size_t sum = state_->deep.capacity * kDeepElement;
  for (const Array& a : state_->arrays) sum += a.texture.bytes();
  return sum;
}

}  // namespace pileus::shadow
