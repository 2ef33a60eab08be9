#pragma once

// What the window does with an insertion: the verbs of its buttons and keys, whoever the hand is.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "perilymph/device/DeviceRegistry.h"
#include "perilymph/device/PointerDevice.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::gui {

/// Who moves the array.
enum class InputSource { scripted, pointer, device };

/// Holds one insertion at a time, drives its hand and sends its commands. It computes nothing: it
/// asks, and the haptic loop decides. UI thread only.
class InsertionControl {
public:
  /// @param record  Where the first insertion is kept; the next ones beside it. Without a file, in
  ///                the folder of sessions under the time of day.
  InsertionControl(session::Scenario scenario, std::optional<std::filesystem::path> record);
  ~InsertionControl();

  /// What an insertion runs in, built beforehand: that takes a tenth of a second and more.
  struct Parts {
    std::shared_ptr<const anatomy::ScalaTympani> anatomy;
    std::shared_ptr<const mechanics::InsertionModel> model;
  };

  /// From the next prepare() on, insertions are of another scenario, made of these parts; without
  /// any, of the same as before.
  void use(session::Scenario scenario, const std::optional<Parts>& parts);

  /// Prepares a fresh insertion with the array at its start and a recording of its own. The one
  /// before is stopped and its recording closed, or removed if it never ran. An insertion whose
  /// recording cannot be opened runs without one, but for the first with a file asked for by name.
  Result<Done> prepare(InputSource hand);

  /// From the next prepare() on, nothing is recorded.
  void keepNothing() { keepsNothing_ = true; }

  /// Makes a device, which is not yet open.
  using DeviceFactory = std::function<Result<std::unique_ptr<device::HapticDevice>>()>;

  /// Which device the next prepare(InputSource::device) opens.
  void choose(DeviceFactory device) { chosen_ = std::move(device); }
  void choose(const device::FoundDevice& found);
  /// The same for the device of a plug-in, a shared library.
  void choose(const std::filesystem::path& plugin);

  /// Lets the loop run and the scripted hand insert; arms the array for the pointer.
  Result<Done> begin();
  /// Lets go of the array: it stays where it is.
  void pause();
  /// Pulls the array out again.
  void withdraw();
  /// Pulls the stylet out of the array, which stays where it is.
  void pullStylet();

  /// Pointer hand: holds the array (the dead-man's button) or lets go of it.
  void hold(bool isHeld);
  bool isHeld() const noexcept { return isHeld_; }
  /// Pointer hand: moves the array while it is held; positive into the cochlea.
  void advanceBy(Length distance);

  /// Sends what is waiting to be asked and takes the newest picture. True if there is a new one.
  bool update();
  /// The newest picture; of the array at its start before the loop runs.
  const haptics::Snapshot& now() const noexcept { return now_; }

  /// The cochlea; after a prepare() that succeeded.
  const anatomy::ScalaTympani& anatomy() const noexcept { return insertion_->anatomy(); }
  std::shared_ptr<const anatomy::ScalaTympani> sharedAnatomy() const noexcept { return anatomy_; }
  InputSource hand() const noexcept { return hand_; }
  bool isRunning() const noexcept { return isRunning_; }
  /// The array is at the stop travel or beyond.
  bool isAtDepth() const noexcept;
  /// The hand is asked to move, or held.
  bool isMoving() const noexcept;
  bool isStyletPulled() const noexcept { return styletTarget_.has_value(); }
  const session::Scenario& scenario() const noexcept { return scenario_; }
  std::string handName() const;
  /// How the hand's device is doing; nothing for a hand without hardware.
  std::optional<device::DeviceHealth> deviceHealth();
  /// Stops the loop where it is and says how it kept its time. Ends the insertion.
  haptics::LoopStatistics halt();
  /// A sentence where the device cannot render the coupling asked for; else empty.
  std::string couplingText() const;
  /// The file being written; none if it could not be.
  std::optional<std::filesystem::path> recording() const;
  /// A sentence while the insertion is not being kept; empty while all is well.
  std::string recordingError() const;

private:
  enum class Wish { rest, insert, withdraw };

  std::filesystem::path nextRecording();
  void discard();
  Result<Done> build(InputSource hand, std::optional<std::filesystem::path> file);
  bool ask(haptics::Command::Kind kind, double value = 0.0);
  void pursue();
  void pursueWithdrawal();
  void moveHand(device::ScriptedDevice::Motion motion);

  session::Scenario scenario_;
  std::shared_ptr<const anatomy::ScalaTympani> anatomy_;    ///< Once it is built.
  std::shared_ptr<const mechanics::InsertionModel> model_;  ///< Once it is built.
  std::optional<std::filesystem::path> record_;
  int prepared_ = 0;
  bool keepsNothing_ = false;

  std::unique_ptr<session::Insertion> insertion_;
  device::ScriptedDevice* scripted_ = nullptr;  ///< Owned by the insertion.
  device::PointerDevice* pointer_ = nullptr;    ///< Owned by the insertion.
  DeviceFactory chosen_;
  InputSource hand_ = InputSource::scripted;
  Wish wish_ = Wish::rest;
  bool isRunning_ = false;
  bool isHeld_ = false;
  std::optional<double> styletTarget_;  ///< [m]
  bool styletAsked_ = false;
  std::uint64_t askedAt_ = 0;  ///< Tick of the picture at the last request.
  std::string recordingError_;
  haptics::Snapshot now_{};
};

}  // namespace perilymph::gui
