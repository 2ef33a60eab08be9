#pragma once

// A port that writes a tape of all that passes through it, and one that plays a tape back.

#include <filesystem>
#include <functional>
#include <memory>

#include "perilymph/device/HidPort.h"
#include "perilymph/device/ReportReader.h"
#include "perilymph/device/ReportTape.h"

namespace perilymph::device {

/// Passes everything on to `port` and keeps it in `file`. Handles note in memory of their own and
/// never wait for the disk, so reading stays real-time safe; a thread writes every 20 ms. What a
/// slow disk had no room for is counted in the tape.
///
/// @param head  Name, identity and descriptor of the device; its entries are not used.
/// @return a sentence if the file cannot be written.
Result<std::unique_ptr<HidPort>> recordingPort(std::unique_ptr<HidPort> port,
                                               const std::filesystem::path& file,
                                               const ReportTape& head, Clock clock = nullptr);

/// The time by which a tape is played.
struct TapeTime {
  Clock now;                                  ///< [ns]
  std::function<void(std::int64_t)> advance;  ///< Lets so much time pass [ns].
};

/// A device that says again what it said on the tape, when it said it. What it is told ends as the
/// same number of reports ended on the tape; features answer as they did. After the last entry it
/// is silent. Time begins with the first handle.
///
/// @param time  The machine's own without.
std::unique_ptr<HidPort> playingPort(ReportTape tape, TapeTime time = {});

}  // namespace perilymph::device
