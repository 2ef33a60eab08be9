// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Command line of the workstation.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "perilymph/broadcast/Broadcast.h"

namespace perilymph::gui {

/// Parsed options.
struct CommandLine {
  std::optional<std::string> scenario;        ///< A shipped name or a path.
  std::optional<std::filesystem::path> file;  ///< A recording, patient, plan, study or CT to open.
  bool isKiosk = false;                       ///< The booth instead of the workstation.
  bool isDemo = false;                        ///< Starts an insertion automatically.
  std::optional<std::filesystem::path> record;  ///< File of the recording.
  std::optional<std::filesystem::path> study;   ///< A study's result to open.
  std::optional<std::filesystem::path> plan;    ///< A plan to report, without a window.
  std::optional<std::filesystem::path> report;  ///< The report's file, PDF or DICOM.
  std::optional<std::filesystem::path> ct;      ///< CT of whose study a DICOM report is a part.
  bool isCtNotCompared = false;  ///< A plan that states no series may be filed there.
  std::optional<std::filesystem::path> plugin;  ///< A device plug-in to use as input device.
  std::optional<std::string> device;  ///< Name or place of the input device, or name of a plug-in.
  std::optional<std::filesystem::path> screenshot;
  std::optional<std::string> language;      ///< "en", "de" or "system", for this call only.
  std::optional<std::string> quality;       ///< auto, fast, balanced or full; by default the stored
                                            ///< one.
  double after_s = 2.0;                     ///< Delay from the first frame to the screenshot.
  std::optional<broadcast::Endpoint> igtl;  ///< Where OpenIGTLink clients may connect.
  broadcast::Coordinates igtlCoordinates = broadcast::Coordinates::cochlea;
  std::optional<std::filesystem::path> bone;  ///< With measuresFrames: CT whose bone is turned.
  bool measuresFrames = false;                ///< Prints frame times of a demonstration and exits.
  /// With measuresFrames: inserts and withdraws until this number of ticks was recorded.
  std::optional<std::uint64_t> measuredTicks;
};

/// Ends the program with this status: help or version was printed, or the command line is invalid.
struct Exit {
  int status = 0;
};

/// Parses the command line; prints help, version or an error message.
std::variant<CommandLine, Exit> parseCommandLine(int argc, const char* const* argv);

}  // namespace perilymph::gui
