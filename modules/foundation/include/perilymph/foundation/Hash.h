// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A 64-bit fingerprint (FNV-1a) of bytes, for models, states and files. Not cryptographic.

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace perilymph {

/// Collects values into a fingerprint. The same values in the same order give the same number on
/// every little-endian machine.
class Hash {
public:
  void addBytes(const void* data, std::size_t size) noexcept
  {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) value_ = (value_ ^ bytes[i]) * prime;
  }

  /// Adds a number or another value without padding.
  template <class Value>
  void add(const Value& value) noexcept
  {
    static_assert(std::is_arithmetic_v<Value> || std::is_enum_v<Value> ||
                      std::has_unique_object_representations_v<Value>,
                  "padding bytes would make the fingerprint random");
    addBytes(&value, sizeof value);
  }

  std::uint64_t value() const noexcept { return value_; }

private:
  static constexpr std::uint64_t prime = 0x100000001b3;
  std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace perilymph
