// Depth images packed without loss.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/sensor/packed_depth.h"

#include <cassert>
#include <cstddef>

namespace spool::sensor {

namespace {

// Numbers in half bytes: three bits each, the lowest first, and a fourth that says that more
// follow.
class HalfByteWriter {
 public:
  explicit HalfByteWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}
  void put(std::uint32_t number) {
    do {
      const std::uint32_t rest = number >> 3U;
      put_half((number & 7U) | (rest != 0 ? 8U : 0U));
      number = rest;
    } while (number != 0);
  }

 private:
  void put_half(std::uint32_t half) {
    if (is_low_)
      bytes_.push_back(static_cast<std::uint8_t>(half));
    else
      bytes_.back() = static_cast<std::uint8_t>(bytes_.back() | (half << 4U));
    is_low_ = !is_low_;
  }

  std::vector<std::uint8_t>& bytes_;
  bool is_low_ = true;  // the next half begins a byte
};

class HalfByteReader {
 public:
  explicit HalfByteReader(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}
  std::uint32_t get() {
    std::uint32_t number = 0;
    for (unsigned shift = 0;; shift += 3) {
      const std::uint32_t half = get_half();
      number |= (half & 7U) << shift;
      if ((half & 8U) == 0) return number;
    }
  }

 private:
  std::uint32_t get_half() {
    assert(at_ / 2 < bytes_.size() && "as pack() wrote it");
    const std::uint32_t byte = bytes_[at_ / 2];
    return at_++ % 2 == 0 ? byte & 15U : byte >> 4U;
  }

  const std::vector<std::uint8_t>& bytes_;
  std::size_t at_ = 0;
};

// 0, -1, 1, -2, 2 … as 0, 1, 2, 3, 4 …
std::uint32_t folded(std::int32_t difference) {
  return (static_cast<std::uint32_t>(difference) << 1U) ^
         static_cast<std::uint32_t>(difference >> 31);
}
std::int32_t unfolded(std::uint32_t number) {
  return static_cast<std::int32_t>(number >> 1U) ^ -static_cast<std::int32_t>(number & 1U);
}

}  // namespace

PackedDepth pack(const DepthFrame& frame) {
  assert(frame.is_consistent() && "a count for every pixel");
  PackedDepth packed{frame.index, frame.seconds, frame.width, frame.height};
  packed.bytes.reserve(frame.depth.size());
  HalfByteWriter out(packed.bytes);
  std::int32_t last = 0;
  for (std::size_t i = 0; i < frame.depth.size();) {
    std::size_t end = i;
    while (end < frame.depth.size() && frame.depth[end] == 0) ++end;
    out.put(static_cast<std::uint32_t>(end - i));
    i = end;
    while (end < frame.depth.size() && frame.depth[end] != 0) ++end;
    out.put(static_cast<std::uint32_t>(end - i));
    for (; i < end; ++i) {
      out.put(folded(frame.depth[i] - last));
      last = frame.depth[i];
    }
  }
  packed.bytes.shrink_to_fit();
  return packed;
}

DepthFrame unpack(const PackedDepth& packed) {
  DepthFrame frame{packed.index, packed.seconds, packed.width, packed.height};
  const auto pixels =
      static_cast<std::size_t>(packed.width) * static_cast<std::size_t>(packed.height);
  frame.depth.reserve(pixels);
  HalfByteReader in(packed.bytes);
  std::int32_t last = 0;
  while (frame.depth.size() < pixels) {
    frame.depth.resize(frame.depth.size() + in.get(), 0);
    for (std::uint32_t left = in.get(); left > 0; --left) {
      last += unfolded(in.get());
      frame.depth.push_back(static_cast<std::uint16_t>(last));
    }
  }
  assert(frame.depth.size() == pixels && "as pack() wrote it");
  return frame;
}

}  // namespace spool::sensor
