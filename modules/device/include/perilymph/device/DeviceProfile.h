#pragma once

// What the program knows about a device: a text file below plugins/devices.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "perilymph/device/FixedReport.h"
#include "perilymph/device/HapticDevice.h"
#include "perilymph/device/LinkageKinematics.h"
#include "perilymph/device/ReportDescriptor.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::device {

/// How the system names a HID interface.
struct HidIdentity {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  int interfaceNumber = -1;  ///< -1 where the system does not say.
};

/// Which devices a profile is for: all that is given must fit.
struct DeviceMatch {
  std::optional<std::uint16_t> vendor;
  std::optional<std::uint16_t> product;
  std::optional<int> interfaceNumber;
  std::optional<Usage> usage;     ///< Usage of one of the device's application collections.
  std::optional<Usage> contains;  ///< Usage of any collection in the descriptor.
};

/// How reports become a hand.
enum class CodecKind : std::uint8_t {
  encoders,    ///< Encoder counts and motor currents of a linkage, at places the profile gives.
  vector,      ///< Position and force along three axes, at places the profile gives.
  pid,         ///< USB physical interface devices: axes and constant-force effects, by usage.
  spaceMouse,  ///< Six axes without force, by usage.
  joystick,    ///< Axes without force, by usage.
};

/// Three numbers of equal width in a report of a known layout.
struct VectorLayout {
  std::uint8_t report = 0;  ///< Its number; 0 where reports are not numbered.
  std::size_t bytes = 0;    ///< Size of the whole report after its number.
  std::array<std::uint32_t, 3> firstBits{};
  std::uint32_t bits = 16;
};

/// Devices whose reports hold bare numbers: `encoders` and `vector`.
struct PlainLayout {
  VectorLayout input;
  VectorLayout output;  ///< Layout of the force's report; no bytes where none is rendered.
  std::array<double, 3> inputQuantum{};     ///< `vector`: [m] a count.
  std::array<double, 3> outputQuantum{};    ///< `vector`: [N] a count; `encoders`: [A] a count.
  std::optional<ReportSlot> counter;        ///< The device's own count of reports.
  std::optional<ReportSlot> buttons;        ///< One bit each.
  std::optional<ReportSlot> calibration;    ///< Not 0 while the device asks to be told its counts.
  std::optional<ReportSlot> command;        ///< In the output report.
  std::int64_t calibrateCommand = 0;        ///< Value of `command` that sets the counts.
  std::array<ReportSlot, 3> countsToSet{};  ///< Where the counts stand in that report.
  Linkage linkage;                          ///< `encoders` only.
};

/// What one of D's six axes takes from the device.
struct AxisSource {
  Usage usage;        ///< Page 0 where nothing moves this axis.
  double sign = 1.0;  ///< 1 or -1.
};

/// Devices whose axes are found by usage: `pid`, `spacemouse`, `joystick`.
struct AxesLayout {
  /// Whether a deflection is a place or a speed.
  enum class Motion : std::uint8_t { place, rate };
  Motion motion = Motion::place;
  std::array<AxisSource, 6> axes{};  ///< Shift along and turn about D's x, y, z.
  double travel = 0.0;               ///< `place`: at full deflection [m].
  double turn = 0.0;                 ///< `place`: [rad]
  double speed = 0.0;                ///< `rate`: at full deflection [m/s].
  double turnSpeed = 0.0;            ///< `rate`: [rad/s]
  double deadZone = 0.0;             ///< Fraction of full deflection around the middle read as 0.
  std::int64_t fullCounts = 0;       ///< Counts at full deflection; 0: as the descriptor says.
};

/// How a PID device is told a direction: that from which a force comes, clockwise from away from
/// the user. 0 pushes toward the user, a quarter turn to the left.
struct PidLayout {
  enum class Effects : std::uint8_t {
    axes,       ///< One constant-force effect an axis, each with that axis enabled.
    polar,      ///< One effect an axis, each with a fixed polar direction.
    direction,  ///< One effect whose direction turns: a plane only.
  };
  Effects effects = Effects::axes;
  std::array<double, 3>
      directions{};  ///< `polar`: where each axis's positive force comes from [rad].
  std::array<double, 3> signs{1, 1, 1};  ///< Sign of the magnitude along each axis: 1 or -1.
  double gain = 1.0;                     ///< Device gain, as a share of the most.
  bool resetFirst = true;                ///< Send "reset" before effects are created.
};

struct DeviceProfile {
  std::string name;
  std::string file;  ///< Where it was read.
  std::string maker;
  std::string note;
  std::string source;
  std::string confidence;  ///< high, medium or low
  std::vector<DeviceMatch> matches;
  CodecKind kind = CodecKind::joystick;
  DeviceTraits traits;
  /// Rotation from the device's own axes to D, row by row.
  std::array<double, 9> mount_DB{1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::uint32_t graspButton = 1;  ///< Which of the device's buttons, counted from 1.
  double forceScale = 1.0;        ///< Shown force over asked force, for a device that errs.
  PlainLayout plain;
  AxesLayout axes;
  PidLayout pid;
  std::vector<FixedReport> onOpen;
  std::vector<FixedReport> onClose;
};

/// Reads a profile; the sentence for a mistake names file, line, key, value and what is allowed.
Result<DeviceProfile> loadProfile(const std::filesystem::path& file);
/// The same for text that came another way; `name` stands for the file in messages.
Result<DeviceProfile> parseProfile(std::string_view text, const std::string& name);

/// All shipped profiles, sorted by file, and the sentences for those that cannot be read.
struct ProfileCatalog {
  std::vector<DeviceProfile> profiles;
  std::vector<std::string> errors;
};
ProfileCatalog shippedProfiles();

/// The profile that fits a device best: a product before a vendor before a usage; nothing if none
/// fits. An unreadable descriptor is passed as an empty one.
const DeviceProfile* matchingProfile(std::span<const DeviceProfile> profiles,
                                     const HidIdentity& identity,
                                     const ReportDescriptor& descriptor) noexcept;

/// What a device of this profile can do; with its descriptor, also how fine its steps are and how
/// many buttons it has.
DeviceTraits traitsOf(const DeviceProfile& profile, const ReportDescriptor& descriptor = {});

}  // namespace perilymph::device
