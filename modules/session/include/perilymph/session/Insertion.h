#pragma once

// The only way to run an insertion: scenario -> model -> engine -> recorder, by the clock or in
// virtual time. The window, the command line, validation and tests share it.

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
  /// @param hand    Who moves the array; opened here.
  /// @param record  Where to keep it (an `.insertion` file); nothing is kept without.
  /// @param anatomy The scenario's cochlea if it is built already, to share it between insertions.
  /// @param model   The scenario's model in that cochlea, the same way.
  static Result<std::unique_ptr<Insertion>> prepare(
      const Scenario& scenario, std::unique_ptr<device::HapticDevice> hand,
      std::optional<std::filesystem::path> record,
      std::shared_ptr<const anatomy::ScalaTympani> anatomy = nullptr,
      std::shared_ptr<const mechanics::InsertionModel> model = nullptr);
  ~Insertion();  ///< Stops, closes the recording, closes the hand.

  // --- virtual time: the caller's thread is the loop ---
  /// Arms, then runs tick after tick until the insertion is finished (and withdrawn, if the
  /// scenario says so), has faulted, or `maxTicks` ticks have passed. `each` sees every record; false
  /// stops.
  Result<Done> runToEnd(const std::function<bool(const haptics::TickRecord&)>& each,
                        std::uint64_t maxTicks = 10'000'000);

  // --- by the clock: a haptic thread and a recorder thread ---
  Result<Done> start();
  void stop() noexcept;
  bool send(const haptics::Command& command) noexcept;
  bool refresh() noexcept;
  const haptics::Snapshot& latest() const noexcept;
  /// A sentence once the recording could not be kept (disk full); empty while all is well.
  std::string recordingError() const;
  /// Ends the recording and folds it into one file, while nothing runs. The sentence of
  /// recordingError() if it could not be kept. Without a call the destructor does it silently.
  Result<Done> closeRecording();

  /// A sentence where the device cannot render the coupling asked for: what it renders, and why.
  const std::string& couplingText() const noexcept;

  const Scenario& scenario() const noexcept;
  const anatomy::ScalaTympani& anatomy() const noexcept;
  std::shared_ptr<const anatomy::ScalaTympani> sharedAnatomy() const noexcept;
  const mechanics::InsertionModel& model() const noexcept;
  std::shared_ptr<const mechanics::InsertionModel> sharedModel() const noexcept;
  device::HapticDevice& hand() noexcept;
  const haptics::HapticLoop& loop() const noexcept;
  const std::optional<std::filesystem::path>& recording() const noexcept;

private:
  Insertion();
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace perilymph::session
