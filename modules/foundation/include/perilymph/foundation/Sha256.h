// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// SHA-256, to detect files that were changed after they were written.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace perilymph {

/// Incremental SHA-256 hash (FIPS 180-4).
class Sha256 {
public:
  Sha256();
  Sha256(const Sha256& other);
  Sha256& operator=(const Sha256& other);
  ~Sha256();

  void add(std::span<const unsigned char> bytes);
  void add(std::string_view text);
  /// Adds a number as eight bytes, little-endian.
  void add(std::uint64_t number);

  /// Hash of all data added so far, as 64 hexadecimal digits; more may be added afterwards.
  std::string hex() const;

private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace perilymph
