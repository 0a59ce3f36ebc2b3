#include "renderer/volume/payload_buffer.h"

#include <sys/mman.h>

#include <utility>

#include "renderer/volume/brick_grid.h"

namespace pileus::volume {

PayloadBuffer::~PayloadBuffer() {
  if (data_) ::munmap(data_, size_);
}

bool PayloadBuffer::resize(std::uint64_t count) {
  constexpr std::size_t kPage = 4096;
  const std::size_t wanted = (static_cast<std::size_t>(count) * kStoredVoxels + kPage - 1) / kPage * kPage;
  if (wanted == size_) return true;
  if (wanted == 0) {
    ::munmap(data_, size_);
    data_ = nullptr;
    size_ = 0;
    return true;
  }
  void* p = data_ ? ::mremap(data_, size_, wanted, MREMAP_MAYMOVE)
                  : ::mmap(nullptr, wanted, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (p == MAP_FAILED) return false;
  data_ = static_cast<std::byte*>(p);
  size_ = wanted;
  return true;
}

std::byte* PayloadBuffer::at(std::uint64_t index) {
  return data_ + static_cast<std::size_t>(index) * kStoredVoxels;
}

std::shared_ptr<const std::byte> PayloadBuffer::release() {
  std::byte* data = std::exchange(data_, nullptr);
  const std::size_t size = std::exchange(size_, 0);
  if (!data) return nullptr;
  return {data, [size](const std::byte* p) { ::munmap(const_cast<std::byte*>(p), size); }};
}

}  // namespace pileus::volume
