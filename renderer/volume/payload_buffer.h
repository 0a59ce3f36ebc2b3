#pragma once
// Growing array of brick payloads in anonymous pages: grows without copying, gives back what it does not use.
#include <cstddef>
#include <cstdint>
#include <memory>

namespace pileus::volume {

class PayloadBuffer {
 public:
  PayloadBuffer() = default;
  ~PayloadBuffer();
  PayloadBuffer(const PayloadBuffer&) = delete;
  PayloadBuffer& operator=(const PayloadBuffer&) = delete;

  /// Room for `count` payloads; new ones are zero. False: out of memory (the old content stays).
  bool resize(std::uint64_t count);
  std::byte* at(std::uint64_t index);
  /// Hands the pages over; the buffer is empty afterwards. Null if it held none.
  std::shared_ptr<const std::byte> release();

 private:
  std::byte* data_ = nullptr;
  std::size_t size_ = 0;  ///< bytes mapped
};

}  // namespace pileus::volume
