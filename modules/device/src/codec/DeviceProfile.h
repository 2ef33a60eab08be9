// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Description of a device: a text file in plugins/devices.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "codec/FixedReport.h"
#include "codec/LinkageKinematics.h"
#include "codec/ReportDescriptor.h"
#include "perilymph/device/HapticDevice.h"
#include "perilymph/device/HidNodes.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::device {

/// Criteria of a profile: all given ones must match.
struct DeviceMatch {
  std::optional<std::uint16_t> vendor;
  std::optional<std::uint16_t> product;
  std::optional<int> interfaceNumber;
  std::optional<Usage> usage;     ///< Usage of one of the device's application collections.
  std::optional<Usage> contains;  ///< Usage of any collection in the descriptor.
};

/// How reports are decoded.
enum class CodecKind : std::uint8_t {
  encoders,    ///< Encoder counts and motor currents of a linkage, at positions given by the
               ///< profile.
  vector,      ///< Position and force along three axes, at positions given by the profile.
  pid,         ///< USB physical interface devices: axes and constant-force effects, by usage.
  spaceMouse,  ///< Six axes without force, by usage.
  joystick,    ///< Axes without force, by usage.
};

/// Three numbers of equal width in a report of a known layout.
struct VectorLayout {
  std::uint8_t report = 0;  ///< Report number; 0 if reports are not numbered.
  std::size_t bytes = 0;    ///< Size of the whole report without its number.
  std::array<std::uint32_t, 3> firstBits{};
  std::uint32_t bits = 16;
};

/// Devices whose reports contain plain numbers: `encoders` and `vector`.
struct PlainLayout {
  VectorLayout input;
  VectorLayout output;  ///< Layout of the force report; no bytes if no force is rendered.
  std::array<double, 3> inputQuantum{};     ///< `vector`: [m] a count.
  std::array<double, 3> outputQuantum{};    ///< `vector`: [N] a count; `encoders`: [A] a count.
  std::optional<ReportSlot> counter;        ///< The device's report counter.
  std::optional<ReportSlot> buttons;        ///< One bit each.
  std::optional<ReportSlot> calibration;    ///< Nonzero while the device requests its counts.
  std::optional<ReportSlot> command;        ///< In the output report.
  std::int64_t calibrateCommand = 0;        ///< Value of `command` that sets the counts.
  std::array<ReportSlot, 3> countsToSet{};  ///< Position of the counts in that report.
  Linkage linkage;                          ///< `encoders` only.
};

/// The device axis that drives one of D's six axes.
struct AxisSource {
  Usage usage;        ///< Page 0 if none drives this axis.
  double sign = 1.0;  ///< 1 or -1.
};

/// Devices whose axes are found by usage: `pid`, `spacemouse`, `joystick`.
struct AxesLayout {
  /// Whether a deflection is a position or a velocity.
  enum class Motion : std::uint8_t { place, rate };
  Motion motion = Motion::place;
  std::array<AxisSource, 6> axes{};  ///< Translation along and rotation about D's x, y, z.
  double travel = 0.0;               ///< `place`: at full deflection [m].
  double turn = 0.0;                 ///< `place`: [rad]
  double speed = 0.0;                ///< `rate`: at full deflection [m/s].
  double turnSpeed = 0.0;            ///< `rate`: [rad/s]
  double deadZone = 0.0;             ///< Fraction of full deflection around the center read as 0.
  std::int64_t fullCounts = 0;       ///< Counts at full deflection; 0: from the descriptor.
};

/// How the direction of a force is sent to a PID device: the direction that the force comes from,
/// clockwise, with 0 away from the user. 0 pushes toward the user, a quarter turn to the left.
struct PidLayout {
  enum class Effects : std::uint8_t {
    axes,       ///< One constant-force effect per axis, each with that axis enabled.
    polar,      ///< One effect per axis, each with a fixed polar direction.
    direction,  ///< One effect with a variable direction: a plane only.
  };
  Effects effects = Effects::axes;
  std::array<double, 3>
      directions{};  ///< `polar`: direction that each axis's positive force comes from [rad].
  std::array<double, 3> signs{1, 1, 1};  ///< Sign of the magnitude along each axis: 1 or -1.
  double gain = 1.0;                     ///< Device gain, as a fraction of its maximum.
  bool resetFirst = true;                ///< Send "reset" before effects are created.
};

struct DeviceProfile {
  std::string name;
  std::string file;  ///< Path of the file.
  std::string maker;
  std::string note;
  std::string source;
  std::string confidence;  ///< high, medium or low
  std::vector<DeviceMatch> matches;
  CodecKind kind = CodecKind::joystick;
  DeviceTraits traits;
  /// Rotation from the device's axes to D, row by row.
  std::array<double, 9> mount_DB{1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::uint32_t graspButton = 1;  ///< Number of the device's grasp button, from 1.
  double forceScale = 1.0;        ///< Correction of the force: rendered over requested, as
                                  ///< measured.
  PlainLayout plain;
  AxesLayout axes;
  PidLayout pid;
  std::vector<FixedReport> onOpen;
  std::vector<FixedReport> onClose;
};

/// Reads a profile; an error names file, line, key, value and the allowed range.
Result<DeviceProfile> loadProfile(const std::filesystem::path& file);
/// The same for text from another source; messages show `name` in place of the file.
Result<DeviceProfile> parseProfile(std::string_view text, const std::string& name);

/// A file that is no valid profile.
struct BrokenProfile {
  std::string error;
  std::vector<DeviceMatch> matches;  ///< The devices it is meant for; empty if they are unknown.
};

/// Profiles, sorted by file, and the files that cannot be read.
struct ProfileCatalog {
  std::vector<DeviceProfile> profiles;
  std::vector<BrokenProfile> broken;
};
ProfileCatalog shippedProfiles();
/// The user's own profiles, then the shipped ones.
ProfileCatalog allProfiles();
/// The profile of a file, or of a file's name without ending: the user's own, else a shipped one.
Result<DeviceProfile> namedProfile(const std::string& nameOrFile);

/// Quality of the best match: 0 for none; 16 and more if product and vendor match.
int fitOf(std::span<const DeviceMatch> matches, const HidIdentity& identity,
          const ReportDescriptor& descriptor) noexcept;

/// The best match of a device: product before vendor before usage, the first of equal ones; null if
/// none matches. Pass an empty descriptor if it cannot be read.
const DeviceProfile* matchingProfile(std::span<const DeviceProfile> profiles,
                                     const HidIdentity& identity,
                                     const ReportDescriptor& descriptor) noexcept;

/// Capabilities of a device with this profile; with its descriptor also its resolution and number
/// of buttons.
DeviceTraits traitsOf(const DeviceProfile& profile, const ReportDescriptor& descriptor = {});

}  // namespace perilymph::device
