// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Control of an insertion by the window's buttons and keys, for every input device.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "gui/run/CochleaStore.h"
#include "gui/run/Conclusion.h"
#include "perilymph/device/DeviceRegistry.h"
#include "perilymph/device/PointerDevice.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/InsertionEnd.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::gui {

/// The device that moves the array.
enum class InputSource { scripted, pointer, device };

/// What an insertion and its recording do, for every page that states it.
enum class Progress {
  ready,      ///< It was not started.
  underway,   ///< Inserting, held on the way, or withdrawing.
  resting,    ///< It has ended, and what follows is recorded as its rest.
  concluded,  ///< It has ended, and its recording is closed and can be read.
};

/// Owns one insertion at a time, controls its device and sends its commands. It computes nothing:
/// it sends requests, and the haptic loop decides. UI thread only.
class InsertionControl {
public:
  /// @param record  File of the first insertion; the next ones are stored beside it. If empty, in
  ///                the folder of recordings, named by the time of day.
  /// @param cochleae  Where cochleae are built and kept; shared by the windows of a program.
  InsertionControl(session::Scenario scenario, std::optional<std::filesystem::path> record,
                   std::shared_ptr<CochleaStore> cochleae = std::make_shared<CochleaStore>());
  ~InsertionControl();

  /// The model of an insertion, built beforehand because that takes a tenth of a second or more.
  struct Parts {
    std::shared_ptr<const anatomy::ScalaTympani> anatomy;
    std::shared_ptr<const mechanics::InsertionModel> model;
  };

  /// Sets the scenario and its parts from the next prepare() on; without parts, those of the
  /// previous scenario are used.
  void use(session::Scenario scenario, const std::optional<Parts>& parts);

  /// Prepares a new insertion with the array at its start and a new recording. The previous one is
  /// stopped and its recording closed, or removed if it never ran. If its recording cannot be
  /// created, an insertion runs without one, except the first with a requested file name.
  Result<void> prepare(InputSource input);

  /// Disables recording from the next prepare() on.
  void disableRecording() { keepsNothing_ = true; }

  /// Makes a device that is not yet open.
  struct DeviceFactory : std::function<Result<std::unique_ptr<device::HapticDevice>>()> {
    using Made = Result<std::unique_ptr<device::HapticDevice>>;
    using function::function;
    /// One that may take seconds to make and open, as a plug-in: not in the window's thread.
    static DeviceFactory slow(std::string name, std::function<Made(const std::stop_token&)> make);

    std::string slowName = {};                         ///< Empty of others.
    std::function<Made(const std::stop_token&)> make;  ///< The same, and can be stopped.
  };

  /// Sets the device that the next prepare(InputSource::device) opens.
  void choose(DeviceFactory device) { chosen_ = std::move(device); }
  /// Sets a device that was made and opened elsewhere, for the next prepare(InputSource::device) alone.
  void takeOpened(std::shared_ptr<device::HapticDevice> device) { opened_ = std::move(device); }
  const DeviceFactory& chosen() const noexcept { return chosen_; }
  void choose(const device::FoundDevice& found);
  /// The same for the device of a plug-in (a shared library).
  void choose(const std::filesystem::path& plugin);

  /// Starts the loop; a scripted device inserts, for the pointer the array is armed. A stopped
  /// device continues, and its force fades in.
  Result<void> begin();
  /// Releases the array, which keeps its position. A device is stopped: the haptic loop removes its
  /// force within the safety chain's off time, even if this thread is blocked afterwards, and it
  /// moves the array again only after begin() or withdraw().
  void pause();
  /// The same for a device after a time, unless continueDevice() is called before.
  void stopDeviceAfter(Duration time);
  void continueDevice();
  /// Withdraws the array.
  void withdraw();
  /// Withdraws the stylet while the array keeps its position.
  void pullStylet();
  /// Sends a command to the loop. False if its queue is full.
  bool ask(haptics::Command::Kind kind, double value = 0.0);

  /// Pointer: grasps (the dead-man's button) or releases the array.
  void hold(bool isHeld);
  bool isHeld() const noexcept { return isHeld_; }
  /// Pointer: moves the array while it is grasped; positive into the cochlea.
  void advanceBy(Length distance);
  /// Pointer: moves the array at a constant speed while it is grasped, up to the stop travel,
  /// positive into the cochlea. To be repeated in every frame; the haptic loop times the motion.
  void driveAt(Speed speed);

  /// Sends pending commands and takes the newest snapshot. True if there is a new one.
  bool update();
  /// The newest snapshot; the initial one before the loop runs.
  const haptics::Snapshot& now() const noexcept { return now_; }

  /// The cochlea; only after a successful prepare().
  const anatomy::ScalaTympani& anatomy() const noexcept { return insertion_->anatomy(); }
  std::shared_ptr<const anatomy::ScalaTympani> sharedAnatomy() const noexcept { return anatomy_; }
  const std::shared_ptr<CochleaStore>& cochleae() const noexcept { return cochleae_; }
  InputSource input() const noexcept { return input_; }
  bool isRunning() const noexcept { return isRunning_; }
  /// The array is at or beyond the stop travel.
  bool isAtDepth() const noexcept;
  /// The event that ended the insertion before its stop travel; none after the withdrawal.
  haptics::InsertionEnd earlyEnd() const noexcept;
  /// An insertion ends at its stop travel, early, withdrawn or by a fault; only a withdrawal continues.
  Progress progress() const noexcept;
  /// The device has a command to move, or is grasped.
  bool isMoving() const noexcept;
  /// The input is a device that moves the array or may do so as soon as its button is pressed.
  bool isDeviceActive() const noexcept;
  /// The input is a device that was stopped: no force until begin() or withdraw().
  bool isStopped() const noexcept;
  /// The input is a device that renders force.
  bool rendersForce() const;
  bool isStyletPulled() const noexcept { return styletTarget_.has_value(); }
  const session::Scenario& scenario() const noexcept { return scenario_; }
  std::string inputName() const;
  /// Health of the device; empty without hardware.
  std::optional<device::DeviceHealth> deviceHealth() const;
  /// Stops the loop and returns its timing statistics. Ends the insertion.
  haptics::LoopStatistics halt();
  /// A message if the device cannot render the requested coupling; else empty.
  std::string couplingText() const;
  /// The current recording file; empty if there is none.
  std::optional<std::filesystem::path> recording() const;
  /// The same while ticks may be added to it, so that it cannot be read yet.
  std::optional<std::filesystem::path> openRecording() const;
  /// A message if the insertion is not being recorded; empty if there is no error.
  Sentence recordingError() const;

private:
  enum class PendingRequest { rest, insert, withdraw };

  Result<void> prepareOnce(InputSource input);
  std::filesystem::path nextRecording();
  void discard();
  Result<void> build(InputSource input, std::optional<std::filesystem::path> file);
  void applyPendingRequest();
  void pursueWithdrawal();
  void pursueResumption();
  void moveScripted(device::ScriptedMotion motion);

  session::Scenario scenario_;
  std::shared_ptr<CochleaStore> cochleae_;
  std::shared_ptr<const anatomy::ScalaTympani> anatomy_;    ///< Null until built.
  std::shared_ptr<const mechanics::InsertionModel> model_;  ///< Null until built.
  std::optional<std::filesystem::path> record_;
  int prepared_ = 0;
  bool keepsNothing_ = false;

  std::unique_ptr<session::Insertion> insertion_;
  std::shared_ptr<device::PointerDevice> pointer_;  ///< The insertion's device, if it is one.
  DeviceFactory chosen_;
  std::shared_ptr<device::HapticDevice> opened_;
  InputSource input_ = InputSource::scripted;
  PendingRequest wish_ = PendingRequest::rest;
  bool isRunning_ = false;
  bool isHeld_ = false;
  bool isStopAwaited_ = false;          ///< Requested, not yet in a snapshot.
  bool isResuming_ = false;             ///< The user requested that a stopped device continues.
  std::optional<double> styletTarget_;  ///< [m]
  bool styletRequested_ = false;
  std::uint64_t askedAt_ = 0;  ///< Tick of the snapshot at the last request.
  Conclusion conclusion_;
  Sentence recordingError_;
  haptics::Snapshot now_{};
};

}  // namespace perilymph::gui
