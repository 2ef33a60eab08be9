// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A recording of all reports of a device with their times, as a text file, for inspection and for
// playback without the device.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "codec/DeviceProfile.h"
#include "hid/Transport.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::device {

/// Kind of an entry.
enum class TapeEvent : std::uint8_t {
  input,       ///< An input report was read.
  written,     ///< An output report was accepted by the device.
  refused,     ///< An output report was refused.
  featureSet,  ///< A feature report was accepted by the device.
  featureGot,  ///< The device answered with a feature report.
  gone,        ///< The device was unplugged.
};

struct TapeEntry {
  std::int64_t time = 0;  ///< Start time since the beginning of the tape [ns].
  std::int64_t took = 0;  ///< Duration of the write or request [ns].
  TapeEvent event = TapeEvent::input;
  std::vector<std::uint8_t> bytes;  ///< Report number first, 0 if unnumbered.
};

/// A text file of lines, each a letter, a colon and words:
///
///     # comment
///     D: 0                               of hid-recorder: the first device, the only one allowed
///     N: name    I: bus vendor product   R: size descriptor       of hid-recorder
///     E: seconds size bytes              an input report, as written by hid-recorder
///     W, F, S, G: seconds seconds size bytes    written, refused, feature set, feature got; the
///                                               second time is its duration
///     U: seconds                         unplugged
///
/// Bytes and identity are hexadecimal; bytes are as on the wire: preceded by the report number if
/// the device numbers its reports. A capture of hid-recorder (hid-tools) is a valid tape.
struct ReportTape {
  std::string name;
  std::uint32_t bus = 0;
  HidIdentity identity;
  std::vector<std::uint8_t> descriptor;
  std::vector<TapeEntry> entries;  ///< In chronological order.
  std::uint64_t lost = 0;          ///< Reports not recorded because the disk was too slow.
};

/// Reads a tape; an error names file and line. An incomplete last line, as after a crash, is
/// ignored.
Result<ReportTape> loadTape(const std::filesystem::path& file);
/// The same for text from another source; messages show `name` in place of the file.
Result<ReportTape> parseTape(std::string_view text, const std::string& name);

/// The header lines and the line of an entry, in the format of parseTape().
std::string tapeHead(const ReportTape& tape);
std::string tapeLine(TapeEvent event, std::int64_t time, std::int64_t took,
                     const RawReport& report);

}  // namespace perilymph::device
