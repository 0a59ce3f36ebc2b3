#include "renderer/shadow/shadow_store.h"

#include <algorithm>
#include <bit>
#include <map>
#include <vector>

#include "renderer/gl/storage.h"
#include "renderer/gl/texture.h"
#include "renderer/shaders/shared/bindings.h"

namespace pileus::shadow {
namespace {

/// Where a block lies: `layers` layers from `first`, a square of `edge` texels, a power of two and aligned to
/// it.
struct Place {
  ivec2 at{0};
  int edge = 0, first = 0, layers = 0;  ///< layers 0: nothing lies here
  int end() const { return first + layers; }
};

struct Array {
  gl::Texture texture;
  gl::Texture bits;           ///< half only: its texels as they are stored, unfiltered
  std::vector<Place> places;  ///< a block keeps its index
};

bool overlap(const Place& a, const Place& b) {
  return a.at.x < b.at.x + b.edge && b.at.x < a.at.x + a.edge && a.at.y < b.at.y + b.edge &&
         b.at.y < a.at.y + a.edge;
}

/// The place that ends lowest, beside and below those that are taken, in an array `width` texels wide.
Place findPlace(std::span<const Place> taken, int width, int edge, int layers) {
  Place best;
  std::vector<std::pair<int, int>> runs;  // taken in the column, first and end
  for (int y = 0; y < width; y += edge)
    for (int x = 0; x < width; x += edge) {
      Place here{ivec2(x, y), edge, 0, layers};
      runs.clear();
      for (const Place& p : taken)
        if (p.layers > 0 && overlap(p, here)) runs.emplace_back(p.first, p.end());
      std::sort(runs.begin(), runs.end());
      for (const auto& [first, end] : runs) {
        if (here.end() <= first) break;
        here.first = std::max(here.first, end);
      }
      if (best.layers == 0 || here.end() < best.end()) best = here;
      if (best.first == 0) return best;
    }
  return best;
}

int depthOf(std::span<const Place> places) {
  int depth = 0;
  for (const Place& p : places) depth = std::max(depth, p.end());
  return depth;
}

/// Edge of the widest block; 0: there is none.
int widest(std::span<const Place> places) {
  int edge = 0;
  for (const Place& p : places) edge = p.layers > 0 ? std::max(edge, p.edge) : edge;
  return edge;
}

/// All anew, the widest and deepest first: narrow blocks stand side by side in wide layers.
std::vector<Place> packed(const std::vector<Place>& places, int width) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i].layers > 0) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(places[a].edge, places[a].layers) > std::pair(places[b].edge, places[b].layers);
  });
  std::vector<Place> out(places.size());
  for (const std::size_t i : order) out[i] = findPlace(out, width, places[i].edge, places[i].layers);
  return out;
}

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
  ~DeepArena() { release(); }
  std::size_t freeRange(std::size_t count) const {
    std::size_t at = 0;
    for (const auto& [first, n] : taken) {
      if (first - at >= count) return at;
      at = first + n;
    }
    return at;
  }
  void release() {
    glDeleteTextures(1, &texels);
    glDeleteBuffers(1, &buffer);
    buffer = texels = 0;
    capacity = 0;
  }
  Result<void> grow(std::size_t elements) {
    if (taken.empty()) release();
    gl::forgetErrors();
    GLuint larger = 0;
    glCreateBuffers(1, &larger);
    glNamedBufferStorage(larger, GLsizeiptr(elements * kDeepElement), nullptr, GL_DYNAMIC_STORAGE_BIT);
    if (auto stored = gl::checkStorage("deep shadow maps", elements * kDeepElement); !stored) {
      glDeleteBuffers(1, &larger);
      return stored;
    }
    if (buffer) glCopyNamedBufferSubData(buffer, larger, 0, 0, GLsizeiptr(capacity * kDeepElement));
    glDeleteBuffers(1, &buffer);
    buffer = larger;
    capacity = elements;
    if (!texels) glCreateTextures(GL_TEXTURE_BUFFER, 1, &texels);
    glTextureBuffer(texels, GL_RG32UI, buffer);
    glObjectLabel(GL_BUFFER, buffer, -1, "deep shadow maps");
    return {};
  }
};

}  // namespace

struct ShadowStoreState {
  std::size_t budget = 0;
  Array arrays[kArrays];
  DeepArena deep;
  std::map<const void*, ShadowStore::Reclaim> reclaims;  ///< by owner

  std::size_t bytes() const {
    std::size_t sum = deep.capacity * kDeepElement;
    for (const Array& a : arrays) sum += a.texture.bytes();
    return sum;
  }
  static std::size_t bytesOf(int kind, ivec3 size) {
    return gl::texelBytes(kFormats[kind]) * std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
  }

  /// What the maps that have gone left behind: arrays without any are given up, those with few become as
  /// small as they can be. What cannot be moved stays.
  void tighten(int except) {
    if (deep.taken.empty()) deep.release();
    for (int k = 0; k < kArrays; ++k) {
      Array& a = arrays[k];
      if (k == except || !a.texture) continue;
      const int width = widest(a.places);
      if (width == 0) {
        a.texture = {}, a.bits = {};
        a.places.clear();
        continue;
      }
      std::vector<Place> places = packed(a.places, width);
      const ivec3 size(width, width, depthOf(places));
      if (bytesOf(k, size) < a.texture.bytes()) (void)place(k, std::move(places), size);
    }
  }

  /// A texture in which all `places` have room; what lies at the array's places moves there. Error (Gpu): all
  /// stays as it is.
  Result<void> move(int kind, std::vector<Place> places, ivec3 size) {
    Array& a = arrays[kind];
    if (depthOf(a.places) == 0) a.texture = {}, a.bits = {};  // nothing to keep beside what is to come
    const std::size_t wanted = bytesOf(kind, size);
    const auto others = [&] { return bytes() - a.texture.bytes(); };
    if (wanted + others() > budget) tighten(kind);
    if (wanted + others() > budget)
      return fail(Code::Gpu,
                  "shadow maps would need {} ({} x {} texels, {} layers{}); {} are set aside for them: lower "
                  "their resolution, or raise --gpu-memory",
                  gl::neededMib(wanted + others()), size.x, size.y, size.z,
                  others() > 0 ? ", beside " + gl::neededMib(others()) + " of other maps" : "",
                  gl::givenMib(budget));
    return place(kind, std::move(places), size);
  }

  Result<void> place(int kind, std::vector<Place> places, ivec3 size) {
    Array& a = arrays[kind];
    PILEUS_TRY(gl::Texture larger,
               gl::Texture::create(GL_TEXTURE_2D_ARRAY, kFormats[kind], size, kLabels[kind]));
    larger.filter(GL_LINEAR);
    for (std::size_t i = 0; i < a.places.size(); ++i) {
      const Place &from = a.places[i], &to = places[i];
      if (from.layers > 0)
        glCopyImageSubData(a.texture.id(), GL_TEXTURE_2D_ARRAY, 0, from.at.x, from.at.y, from.first,
                           larger.id(), GL_TEXTURE_2D_ARRAY, 0, to.at.x, to.at.y, to.first, from.edge,
                           from.edge, from.layers);
    }
    a.texture = std::move(larger);
    a.places = std::move(places);
    if (kind == STORE_HALF) a.bits = gl::Texture::view(a.texture, GL_RG32UI, "shadow store half, as bits");
    return {};
  }

  /// Tries, and tries again for as long as somebody lets go of maps.
  template <class Try>
  auto reclaiming(std::size_t need, const Try& attempt) {
    const auto reclaim = [&] {
      return std::any_of(reclaims.begin(), reclaims.end(), [&](const auto& r) { return r.second(need); });
    };
    auto result = attempt();
    while (!result && result.error().code == Code::Gpu && need <= budget && reclaim()) result = attempt();
    return result;
  }

  /// The index of a new place of that size.
  Result<std::size_t> take(int kind, int edge, int layers) {
    Array& a = arrays[kind];
    const ivec3 old = a.texture ? a.texture.size() : ivec3(0);
    std::size_t index = 0;
    while (index < a.places.size() && a.places[index].layers != 0) ++index;
    const auto with = [&](std::vector<Place> places, const Place& place) {
      places.resize(std::max(places.size(), index + 1));
      places[index] = place;
      return places;
    };
    const int width = std::max(edge, old.x);
    std::vector<Place> still;  // all others as they lie
    if (width == old.x) {
      still = with(a.places, findPlace(a.places, width, edge, layers));
      if (depthOf(still) <= old.z) {
        a.places = std::move(still);
        return index;
      }
    }
    std::vector<Place> places = packed(with(a.places, {ivec2(0), edge, 0, layers}), width);
    if (!still.empty() && depthOf(still) <= depthOf(places)) places = std::move(still);
    const std::size_t had = a.places.size();
    a.places.resize(places.size());
    Result<void> moved = move(kind, places, ivec3(width, width, depthOf(places)));
    if (const int narrow = std::max(edge, widest(a.places)); !moved && narrow < width) {
      // The wide map that made it so wide has gone.
      a.places.resize(had);
      places = packed(with(a.places, {ivec2(0), edge, 0, layers}), narrow);
      a.places.resize(places.size());
      moved = move(kind, places, ivec3(narrow, narrow, depthOf(places)));
    }
    if (moved) return index;
    a.places.resize(had);
    return moved.error();
  }

  /// The first of so many elements.
  Result<std::size_t> takeDeep(std::size_t elements) {
    const std::size_t first = deep.freeRange(elements), end = first + elements;
    if (end > deep.capacity) {
      GLint limit = 0;
      glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
      const std::size_t wanted = std::max(end, std::min(2 * deep.capacity, std::size_t(limit)));
      if (end > std::size_t(limit))
        return fail(Code::Gpu,
                    "deep shadow maps would hold {} vertices and texels, the buffer textures of this OpenGL "
                    "driver {}: raise the error bound or lower the resolution",
                    end, limit);
      const auto others = [&] { return bytes() - deep.capacity * kDeepElement; };
      if (others() + end * kDeepElement > budget) tighten(-1);
      if (others() + end * kDeepElement > budget)
        return fail(Code::Gpu,
                    "a deep shadow map needs {}, {} in all with the other maps; {} are set aside for shadow "
                    "maps: raise its error bound, lower its resolution, or raise --gpu-memory",
                    gl::neededMib(elements * kDeepElement), gl::neededMib(others() + end * kDeepElement),
                    gl::givenMib(budget));
      PILEUS_CHECK(deep.grow(others() + wanted * kDeepElement > budget ? end : wanted));
    }
    deep.taken.emplace(first, elements);
    return first;
  }
};

ShadowBlock::ShadowBlock(std::shared_ptr<ShadowStoreState> store, Texels texels, int resolution, int layers,
                         int faces, std::size_t place)
    : store_(std::move(store)),
      texels_(texels),
      resolution_(resolution),
      layers_(layers),
      faces_(faces),
      place_(place) {}

ShadowBlock::~ShadowBlock() { store_->arrays[int(texels_)].places[place_] = Place{}; }

std::size_t ShadowBlock::bytes() const {
  return gl::texelBytes(format()) * std::size_t(resolution_) * std::size_t(resolution_) *
         std::size_t(layers_ * faces_);
}

gpu::BlockRecord ShadowBlock::record() const {
  const Place& p = store_->arrays[int(texels_)].places[place_];
  return {ivec4(p.at, resolution_, p.first), ivec4(int(texels_), layers_, faces_, 0)};
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

void ShadowStore::setReclaim(const void* owner, Reclaim reclaim) {
  if (reclaim)
    state_->reclaims[owner] = std::move(reclaim);
  else
    state_->reclaims.erase(owner);
}

ShadowStore::ShadowStore(std::size_t budgetBytes) : state_(std::make_shared<ShadowStoreState>()) {
  state_->budget = budgetBytes;
}

Result<std::shared_ptr<const ShadowBlock>> ShadowStore::allocate(Texels texels, int resolution, int layers,
                                                                 int faces) {
  const int edge = int(std::bit_ceil(unsigned(std::max(resolution, 16))));
  const int all = layers * faces;
  PILEUS_TRY(const std::size_t place,
             state_->reclaiming(ShadowStoreState::bytesOf(int(texels), {edge, edge, all}),
                                [&] { return state_->take(int(texels), edge, all); }));
  return std::make_shared<const ShadowBlock>(state_, texels, resolution, layers, faces, place);
}

Result<std::shared_ptr<const DeepBlock>> ShadowStore::allocateDeep(std::size_t elements) {
  elements = std::max<std::size_t>(elements, 1);
  PILEUS_TRY(const std::size_t first,
             state_->reclaiming(elements * kDeepElement, [&] { return state_->takeDeep(elements); }));
  return std::make_shared<const DeepBlock>(state_, first, elements);
}

void ShadowStore::bind() const {
  for (int k = 0; k < kArrays; ++k) glBindTextureUnit(GLuint(kUnits[k]), state_->arrays[k].texture.id());
  glBindTextureUnit(UNIT_SHADOW_HALF_BITS, state_->arrays[STORE_HALF].bits.id());
  glBindTextureUnit(UNIT_SHADOW_DEEP, state_->deep.texels);
}

std::size_t ShadowStore::bytes() const { return state_->bytes(); }

std::size_t ShadowStore::usedBytes() const {
  std::size_t sum = 0;
  for (const auto& [first, count] : state_->deep.taken) sum += count * kDeepElement;
  for (int k = 0; k < kArrays; ++k)
    for (const Place& p : state_->arrays[k].places)
      sum += ShadowStoreState::bytesOf(k, {p.edge, p.edge, p.layers});
  return sum;
}

}  // namespace pileus::shadow
