#pragma once

// Every report of a device with its time, in a text file: to look at later, and to play back where
// the device is not.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "perilymph/device/DeviceProfile.h"
#include "perilymph/device/Transport.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::device {

/// What happened on the wire.
enum class TapeEvent : std::uint8_t {
  input,       ///< An input report was taken.
  written,     ///< An output report was taken by the device.
  refused,     ///< An output report was not taken.
  featureSet,  ///< A feature report was taken by the device.
  featureGot,  ///< The device answered with a feature report.
  gone,        ///< The device was unplugged.
};

struct TapeEntry {
  std::int64_t time = 0;  ///< When it began, since the tape did [ns].
  std::int64_t took = 0;  ///< Duration of what the device was told or asked [ns].
  TapeEvent event = TapeEvent::input;
  std::vector<std::uint8_t> bytes;  ///< The report's number first, 0 if it has none.
};

/// A file of lines, each a letter, a colon and words:
///
///     # anything
///     D: 0                               of hid-recorder: the first device; there is one only
///     N: name    I: bus vendor product   R: size descriptor       of hid-recorder
///     E: seconds size bytes              an input report, as hid-recorder writes it
///     W, F, S, G: seconds seconds size bytes    written, refused, feature set, feature got; the
///                                               second time is how long it took
///     U: seconds                         unplugged
///
/// Bytes and identity are hexadecimal; bytes are as on the wire: with the report's number in front
/// where the device numbers its reports. A capture of hid-recorder (hid-tools) is a tape too.
struct ReportTape {
  std::string name;
  std::uint32_t bus = 0;
  HidIdentity identity;
  std::vector<std::uint8_t> descriptor;
  std::vector<TapeEntry> entries;  ///< In the order of their times.
  std::uint64_t lost = 0;          ///< Reports that were not kept: the disk was too slow.
};

/// Reads a tape; the sentence names file and line of what makes no sense. A last line that was cut
/// off, as by a crash, is left out.
Result<ReportTape> loadTape(const std::filesystem::path& file);
/// The same for text that came another way; `name` stands for the file in messages.
Result<ReportTape> parseTape(std::string_view text, const std::string& name);

/// The lines before the entries, and that of an entry, as parseTape() reads them.
std::string tapeHead(const ReportTape& tape);
std::string tapeLine(TapeEvent event, std::int64_t time, std::int64_t took,
                     const RawReport& report);

}  // namespace perilymph::device
