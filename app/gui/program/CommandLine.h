#pragma once

// The words of the call.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

namespace perilymph::gui {

/// What the workstation was asked to do.
struct CommandLine {
  std::optional<std::string> scenario;          ///< A shipped name or a file.
  bool isKiosk = false;                         ///< The booth in place of the workstation.
  bool isDemo = false;                          ///< Starts inserting by itself.
  std::optional<std::filesystem::path> record;  ///< Where to keep the insertion.
  std::optional<std::filesystem::path> plugin;  ///< A device plug-in: the hand.
  std::optional<std::filesystem::path> screenshot;
  std::optional<std::string> language;  ///< "en", "de" or "system", for this call alone.
  std::optional<std::string> quality;   ///< auto, fast, balanced or full; else what was kept.
  double after_s = 2.0;                 ///< From the first frame to the screenshot.
  bool measuresFrames = false;          ///< Prints frame times of a demonstration and exits.
  /// With measuresFrames: goes in and out until so many ticks were recorded.
  std::optional<std::uint64_t> measuredTicks;
};

/// The program ends here, with this status: help and version were printed, or the words were wrong.
struct Exit {
  int status = 0;
};

/// Reads the words; prints help, version or what is wrong with them.
std::variant<CommandLine, Exit> parseCommandLine(int argc, const char* const* argv);

}  // namespace perilymph::gui
