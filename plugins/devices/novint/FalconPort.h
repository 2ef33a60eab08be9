// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The Falcon's USB interface, a serial converter of FTDI, by libftdi1.

#include <memory>
#include <string>

#include "FalconPackets.h"

struct ftdi_context;

namespace perilymph::novint {

struct CloseFtdi {
  void operator()(ftdi_context* context) const noexcept;
};

/// How an exchange ended.
enum class Reply { complete, late, lost };

class FalconPort {
public:
  /// Opens the first Falcon. If its firmware does not answer, loads the one in a file.
  /// @param firmware  Path of the user's copy of the firmware; may be empty.
  /// @return Empty, or a sentence for the user.
  std::string open(const std::string& firmware);
  void close() noexcept { context_.reset(); }

  /// Sends a packet. False if the device is gone.
  bool send(const Packet& packet) noexcept;
  /// Waits for the answer, at most 20 ms.
  Reply receive(Packet& packet) noexcept;

private:
  bool setNormalMode() noexcept;
  bool answers() noexcept;
  std::string load(const std::string& firmware);
  bool enterLoader() noexcept;
  /// Bytes read until there are as many as asked for or a time has passed; -1: the device is gone.
  int readAtMost(std::uint8_t* bytes, int count, std::int64_t patience) noexcept;

  std::unique_ptr<ftdi_context, CloseFtdi> context_;
  bool isLate_ = false;  // an answer is still under way
};

}  // namespace perilymph::novint
