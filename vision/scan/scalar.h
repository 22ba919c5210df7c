// The number types that binary cloud files are made of.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace spool {

enum class Scalar {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat,
  kDouble
};
enum class ByteOrder { kLittle, kBig };

[[nodiscard]] constexpr std::size_t bytes_of(Scalar type) {
  switch (type) {
    case Scalar::kInt8:
    case Scalar::kUint8:
      return 1;
    case Scalar::kInt16:
    case Scalar::kUint16:
      return 2;
    case Scalar::kInt32:
    case Scalar::kUint32:
    case Scalar::kFloat:
      return 4;
    case Scalar::kInt64:
    case Scalar::kUint64:
    case Scalar::kDouble:
      return 8;
  }
  return 8;
}

// The number at `at`, where bytes_of() bytes must lie, in the machine's own order and alignment.
template <class T>
[[nodiscard]] T load_as(const char* at, ByteOrder order) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, at, sizeof(T));
  static_assert(std::endian::native == std::endian::little, "ours are little-endian machines");
  if (order == ByteOrder::kBig)
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) {
      const char swapped = bytes[i];
      bytes[i] = bytes[sizeof(T) - 1 - i];
      bytes[sizeof(T) - 1 - i] = swapped;
    }
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

[[nodiscard]] inline double load_scalar(const char* at, Scalar type, ByteOrder order) {
  switch (type) {
    case Scalar::kInt8:
      return load_as<std::int8_t>(at, order);
    case Scalar::kUint8:
      return load_as<std::uint8_t>(at, order);
    case Scalar::kInt16:
      return load_as<std::int16_t>(at, order);
    case Scalar::kUint16:
      return load_as<std::uint16_t>(at, order);
    case Scalar::kInt32:
      return load_as<std::int32_t>(at, order);
    case Scalar::kUint32:
      return load_as<std::uint32_t>(at, order);
    case Scalar::kInt64:
      return static_cast<double>(load_as<std::int64_t>(at, order));
    case Scalar::kUint64:
      return static_cast<double>(load_as<std::uint64_t>(at, order));
    case Scalar::kFloat:
      return static_cast<double>(load_as<float>(at, order));
    case Scalar::kDouble:
      return load_as<double>(at, order);
  }
  return 0;
}

}  // namespace spool
