// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A port that records all its reports on a tape, and one that plays a tape.

#include <filesystem>
#include <functional>
#include <memory>

#include "hid/HidPort.h"
#include "hid/ReportReader.h"
#include "tape/ReportTape.h"

namespace perilymph::device {

/// Forwards everything to `port` and records it in `file`. Handles buffer in their own memory and
/// never wait for the disk, so that reading stays real-time safe; a thread writes every 20 ms.
/// Entries dropped because the disk is too slow are counted in the tape.
///
/// @param head  Name, identity and descriptor of the device; its entries are not used.
///
/// @return an error if the file cannot be written.
Result<std::unique_ptr<HidPort>> recordingPort(std::unique_ptr<HidPort> port,
                                               const std::filesystem::path& file,
                                               const ReportTape& head, Clock clock = nullptr);

/// The time source for playing a tape.
struct TapeTime {
  Clock now;                                  ///< [ns]
  std::function<void(std::int64_t)> advance;  ///< Lets time pass [ns].
};

/// A device that repeats the input reports of a tape at their times. Writes end with the result of
/// the corresponding write on the tape; feature requests are answered as recorded. It is silent
/// after the last entry. Time starts with the first handle.
///
/// @param time  By default the machine's clock.
std::unique_ptr<HidPort> playingPort(ReportTape tape, TapeTime time = {});

}  // namespace perilymph::device
