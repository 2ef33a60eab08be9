// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The messages of a client, of which only the headers are kept.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace perilymph::broadcast {

/// Reads a stream of OpenIGTLink messages in pieces of any size, in constant memory. A header has 58
/// bytes, big-endian: version (2 bytes), type (12), device name (20), time (8), size of the body
/// (8), CRC-64 of the body (8). (OpenIGTLink protocol version 2; header version 2 is protocol 3, whose
/// extended header and metadata are part of the body.)
class RequestReader {
public:
  static constexpr std::size_t headerSize = 58;
  /// Protocol 3 has header version 2. Some senders write the protocol's version.
  static constexpr std::uint64_t maxVersion = 3;
  /// Larger bodies are skipped unread: requests have none, and what else is sent is dropped.
  static constexpr std::uint64_t maxBody = 1 << 20;

  /// A complete message.
  struct Request {
    std::string type;    ///< "GET_POLYDATA"
    std::string device;  ///< Name of the requested device; may be empty.
  };

  /// Takes bytes up to the end of the first message that is complete. Returns how many it took;
  /// then request() tells whether a message ended there.
  std::size_t take(std::span<const std::uint8_t> bytes);

  /// The message that ended with the last byte taken.
  const std::optional<Request>& request() const noexcept { return request_; }
  /// A clause: why the stream is no OpenIGTLink; empty if it is. Nothing more is taken then.
  const std::string& fault() const noexcept { return fault_; }
  /// Bytes of skipped bodies, of all messages.
  std::uint64_t skipped() const noexcept { return skipped_; }
  /// A message has begun and is not complete.
  bool isWithinMessage() const noexcept { return headerBytes_ > 0; }

private:
  void readHeader();
  void finish();

  std::array<std::uint8_t, headerSize> header_{};
  std::size_t headerBytes_ = 0;
  std::uint64_t bodyLeft_ = 0;
  std::uint64_t crc_ = 0, statedCrc_ = 0;
  std::uint64_t skipped_ = 0;
  bool isSkipped_ = false;  // the body that is being read
  Request current_;
  std::optional<Request> request_;
  std::string fault_;
};

}  // namespace perilymph::broadcast
