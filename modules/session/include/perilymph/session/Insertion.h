// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The common way to run an insertion: scenario -> model -> engine -> recorder, by the clock or in
// virtual time. Used by the window, the command line, validation and tests.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/device/HapticDevice.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/HapticLoop.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::session {

/// One insertion, ready to run.
class Insertion {
public:
  /// Prepares an insertion.
  ///
  /// @param hand    The device that moves the array; opened here, closed with the insertion. Who keeps a
  ///                share of it may still command it.
  /// @param record  File of the recording (`.insertion`); not recorded if empty.
  /// @param anatomy The scenario's cochlea if already built, to share it between insertions.
  /// @param model   The scenario's model in that cochlea, likewise.
  static Result<std::unique_ptr<Insertion>> prepare(
      const Scenario& scenario, std::shared_ptr<device::HapticDevice> device,
      std::optional<std::filesystem::path> record,
      std::shared_ptr<const anatomy::ScalaTympani> anatomy = nullptr,
      std::shared_ptr<const mechanics::InsertionModel> model = nullptr);
  /// Prepares an insertion that is not recorded, with parameters that come from no text.
  static Result<std::unique_ptr<Insertion>> prepare(
      const InsertionParameters& parameters, std::shared_ptr<device::HapticDevice> device,
      std::shared_ptr<const anatomy::ScalaTympani> anatomy = nullptr,
      std::shared_ptr<const mechanics::InsertionModel> model = nullptr);
  ~Insertion();  ///< Stops, closes the recording, closes the device.

  // --- virtual time: the caller's thread is the loop ---
  /// Arms, then runs until the insertion has ended (and is withdrawn, if the scenario sets it and
  /// the stop travel was reached), has faulted, or `maxTicks` ticks have passed. `each` receives every record and returns false to
  /// stop.
  Result<void> runToEnd(const std::function<bool(const haptics::TickRecord&)>& each,
                        std::uint64_t maxTicks = 10'000'000);

  // --- by the clock: a haptic thread and a recorder thread ---
  /// Starts both. Refuses, at a device that renders force, a model of which a tick can take longer than
  /// its time step on this machine (haptics::checkTickBound()).
  Result<void> start();
  /// A sentence about memory that start() could not lock in RAM; empty if all is.
  Sentence memoryNote() const;
  void stop() noexcept;
  bool send(const haptics::Command& command) noexcept;
  /// HapticLoop::requestStop(), requestStopAt() and cancelStopAt().
  void requestStop() noexcept;
  void requestStopAt(std::int64_t time) noexcept;
  void cancelStopAt() noexcept;
  bool refresh() noexcept;
  const haptics::Snapshot& latest() const noexcept;
  /// A message if the recording failed (disk full); empty if there is no error.
  Sentence recordingError() const;
  /// Closes the recording within some milliseconds while the loop continues, so that it can be read; the
  /// ticks of a withdrawal that follows are added to it.
  void concludeRecording() noexcept;
  /// It is closed, and no tick has followed.
  bool isRecordingConcluded() const noexcept;
  /// Ends the recording and merges its log into one file, while nothing runs. Returns the error of
  /// recordingError() if it failed. Otherwise the destructor closes it silently.
  Result<void> closeRecording();

  /// A message if the device cannot render the requested coupling: what it renders, and why.
  const std::string& couplingText() const noexcept;

  const InsertionParameters& parameters() const noexcept;
  const anatomy::ScalaTympani& anatomy() const noexcept;
  std::shared_ptr<const anatomy::ScalaTympani> sharedAnatomy() const noexcept;
  const mechanics::InsertionModel& model() const noexcept;
  std::shared_ptr<const mechanics::InsertionModel> sharedModel() const noexcept;
  device::HapticDevice& device() noexcept;
  const haptics::HapticLoop& loop() const noexcept;
  const std::optional<std::filesystem::path>& recording() const noexcept;

private:
  Insertion();
  /// @param text  Text of the scenario, for the recording.
  static Result<std::unique_ptr<Insertion>> prepare(
      const InsertionParameters& parameters, const std::string& text,
      std::shared_ptr<device::HapticDevice> device, std::optional<std::filesystem::path> record,
      std::shared_ptr<const anatomy::ScalaTympani> anatomy,
      std::shared_ptr<const mechanics::InsertionModel> model);
  struct Content;
  std::unique_ptr<Content> content_;
};

/// Ticks after which an insertion by a script has ended: the tweezers have reached the bone, and
/// come back if the array is withdrawn; twice that, and a second to start.
std::uint64_t maxTicks(const InsertionParameters& parameters,
                       const mechanics::InsertionModel& model) noexcept;

}  // namespace perilymph::session
