// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Bytes of a file as a stream, inflated as they come if they are packed.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

enum class Packing {
  none,      ///< As they are.
  required,  ///< gzip or zlib; other bytes are damage.
  detected   ///< gzip if they begin so, else as they are.
};

/// A file from a byte on. Holds 64 kB, whatever the file's size and what it inflates to.
class ByteSource {
public:
  /// Refuses what is no regular file, and damaged packing.
  static Result<ByteSource> open(const std::filesystem::path& file, std::size_t from,
                                 Packing packing);

  /// Fills up to `count` bytes and returns how many; fewer only at the end. Refuses damaged
  /// packing, and bytes behind it.
  Result<std::size_t> read(char* to, std::size_t count);

  /// Skips bytes; refuses an end before.
  Result<void> skip(std::size_t count);

  bool isPacked() const noexcept;

  /// Bytes of the file from the first one on; packed ones inflate to at most 1032 times as many.
  std::uintmax_t fileBytes() const noexcept;

private:
  struct Stream;
  explicit ByteSource(std::shared_ptr<Stream> stream) : stream_(std::move(stream)) {}

  std::shared_ptr<Stream> stream_;
};

/// The limit of deflate: bits of a longest match.
inline constexpr std::uintmax_t maxInflation = 1032;

Error unreadableFile(const std::filesystem::path& file);
Error cutOffFile(const std::filesystem::path& file);

}  // namespace perilymph::imaging
