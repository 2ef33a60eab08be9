// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Positions of the fields of a PID device that constant forces need ("Device Class Definition for
// Physical Interface Devices 1.0").

#include "codec/CodecParts.h"

namespace perilymph::device {

/// Positions found in the report descriptor, and the reports built with them. Fields that are not
/// set are zero.
class PidReports {
public:
  /// Commands for the actuators; their encoding follows the order in which the device lists them.
  enum class Control : std::uint8_t { enable, disable, stopAll, reset };
  /// The device's answer to the allocation of an effect.
  enum class Load : std::uint8_t { done, full, failed };

  /// @return the positions, or an error naming the missing report.
  static Result<PidReports> find(const DeviceProfile& profile, const ReportDescriptor& descriptor);

  /// Empty for a control that the device does not list. These are output reports.
  std::optional<RawReport> control(Control what) const noexcept;
  std::optional<RawReport> gain(double fraction) const noexcept;
  /// An effect of infinite duration along one axis, several or a direction; see PidLayout::Effects.
  /// @param axes       Bits of D's axes that are enabled.
  /// @param direction  Direction that the force comes from [rad]; empty if axes are enabled
  /// instead.
  void setEffect(RawReport& report, std::int64_t block, unsigned axes,
                 std::optional<double> direction) const noexcept;
  /// @param fraction  Of the maximum magnitude, -1 to 1.
  void constantForce(RawReport& report, std::int64_t block, double fraction) const noexcept;
  RawReport start(std::int64_t block) const noexcept;
  RawReport free(std::int64_t block) const noexcept;

  /// Feature reports.
  RawReport createEffect() const noexcept;
  RawReport blockLoad() const noexcept;
  Load loadStatus(const RawReport& answer) const noexcept;
  std::int64_t loadedBlock(const RawReport& answer) const noexcept;

  /// Maximum value of the magnitude [counts].
  std::int64_t maxMagnitude() const noexcept { return magnitude_.high; }

private:
  /// One report and its length.
  struct Place {
    ReportSlot slot;
    std::size_t bytes = 0;  ///< Size of the report without its number.
  };
  struct Said {
    UsageChoice choice;
    std::size_t bytes = 0;
  };

  RawReport blank(std::uint8_t report, std::size_t bytes) const noexcept;

  Said createType_;
  Place loadBlock_;
  std::optional<UsageChoice> loadDone_;
  std::optional<UsageChoice> loadFull_;
  Place effectBlock_;
  std::optional<UsageChoice> effectType_;
  std::optional<ReportSlot> duration_;
  std::optional<ReportSlot> effectGain_;
  std::optional<ReportSlot> trigger_;
  std::array<std::optional<ReportSlot>, 3> axisEnable_;
  std::optional<ReportSlot> directionEnable_;
  std::optional<ReportSlot> direction_;
  Place forceBlock_;
  ReportSlot magnitude_;
  Place operationBlock_;
  UsageChoice operationStart_;
  std::optional<ReportSlot> loops_;
  Place freeBlock_;
  std::optional<Place> deviceGain_;
  std::array<std::optional<Said>, 4> controls_;
};

}  // namespace perilymph::device
