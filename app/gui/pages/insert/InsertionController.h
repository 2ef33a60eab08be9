// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What happens on the insertion page: the insertion, its setup, its safety, and replays. No widget.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "gui/pages/insert/GraspControl.h"
#include "gui/pages/insert/SetupControl.h"
#include "gui/report/ReportContent.h"
#include "gui/run/Background.h"
#include "gui/run/InsertionControl.h"
#include "gui/run/ReferenceInsertion.h"
#include "gui/run/SafetyStop.h"
#include "gui/setup/InsertionRequest.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

class ReplayPlayer;

/// Requests the steps of an insertion and keeps what belongs together in step: setup and model, array
/// and input device, insertion and replay. It continues while other pages are shown. During a replay no
/// loop runs and no device is open.
class InsertionController : public QObject {
  Q_OBJECT
public:
  InsertionController(session::Scenario scenario, std::optional<std::filesystem::path> record,
                      std::shared_ptr<CochleaStore> cochleae);
  ~InsertionController() override;

  InsertionControl& control() { return control_; }
  const InsertionControl& control() const { return control_; }
  SafetyStop& safety() { return safety_; }
  GraspControl& held() { return held_; }
  SetupControl& setup() { return *setup_; }
  const SetupHistory& history() const { return setup_->history(); }
  ReplayPlayer& replay() { return *replay_; }
  const ReplayPlayer& replay() const { return *replay_; }

  /// Builds the cochlea and prepares the insertion.
  Result<void> open();
  /// Loads another setup, whose cochlea is built meanwhile.
  void load(const InsertionRequest& request);
  /// The same with a patient's cochlea, where a change is possible: all else as it is for the patient
  /// shown, or as for surgery where none is shown.
  void loadPatient(const anatomy::Patient& patient);

  /// The scenario that load() builds; null once it is shown, failed or canceled. Until then nothing of
  /// the scenario before is to be shown as if it were this one.
  const session::Scenario* loading() const { return loading_ ? &*loading_ : nullptr; }

  /// The scenario on the page if it is not the insertion's: the one being built, or that of a replay.
  const session::Scenario* shownInstead() const;

  /// What a new window with the same scenario continues.
  struct Memory {
    SetupHistory::Memory setup;
    std::optional<ReferenceInsertion> ghost;
    InputSource input = InputSource::scripted;
    InsertionControl::DeviceFactory device;
    std::optional<PlannedForce> plan = {};
  };
  Memory memory() const;
  /// Before open(), which uses the input.
  void resume(const Memory& memory);

  /// Commits values that are being edited and returns an error message if one is invalid. Called
  /// before a start.
  void commitBy(std::function<QString()> commit) { commit_ = std::move(commit); }
  void start();
  /// Releases the array, which keeps its position.
  void pause();
  /// Pauses motion. False if nothing moves.
  bool rest();
  void withdraw();
  /// Prepares a new insertion with the array at its start and the same device.
  void reset();
  /// The key Space: grasps the array, or starts or pauses.
  void pressSpace();
  /// Removes a device's force at once: Esc, the Stop button, a locked screen. True if there was one.
  bool stopDevice();
  /// The window lost the keyboard focus.
  void loseKeyboard();

  /// The setup may be changed now: not during an insertion, nor a replay.
  bool maySetUp() const;
  /// Have no effect where the setup may not be changed now.
  void change(const SetupChange& change);
  void restore();
  void undo();
  void redo();

  void chooseInput(InputSource input);
  /// Uses a device as input; if it cannot be opened, the script remains, and there is an error. One that may
  /// take seconds is opened in the background.
  /// @param chosen  A found device, a factory, or the library of a plug-in.
  template <class Device>
  void useDevice(const Device& chosen)
  {
    control_.choose(chosen);
    prepare(InputSource::device);
  }

  /// The device that is being opened in the background, and for how long; empty if none is.
  QString openingText() const;
  /// Keeps the script as the input. True if a device was being opened.
  bool cancelOpening();

  /// Opens a recording in place of the insertion; emits replayOpened() or replayFailed().
  void openReplay(const std::filesystem::path& file);
  void closeReplay();

  /// An earlier insertion drawn behind the next ones; empty to remove it.
  void setReference(const std::optional<ReferenceInsertion>& reference);
  const std::optional<ReferenceInsertion>& reference() const { return reference_; }
  /// The force expected by a plan, drawn behind insertions of its array into its cochlea.
  const std::optional<PlannedForce>& plan() const { return plan_; }

  /// The insertion that has ended, read from its recording; null until then, and from the next
  /// motion or insertion on.
  const std::shared_ptr<const ReportContent>& result() const { return result_; }
  /// The recording of the insertion before, if there is one.
  const std::optional<std::filesystem::path>& recordingBefore() const { return before_; }
  /// Inserts once more: with a script at once, else from a new start.
  void again();
  /// Reads the insertion once it has ended. To be called in every frame.
  void followEnd();

  /// Shows an error until the next reset.
  void showError(const QString& sentence);
  /// The error in the banner; empty if there is none.
  QString error() const;

Q_SIGNALS:
  /// open() has prepared the first insertion.
  void opened();
  /// A new insertion with the array at its start, and another recording: control().recording().
  void prepared();
  /// The cochlea will be destroyed, and then another one, or another array, is there.
  void cochleaEnding();
  void cochleaChanged();
  /// The setup of the panel is another one.
  void setupChanged();
  /// Another scenario or setup applies, is being built, or a replay of one.
  void subjectChanged();
  /// What the insertion does, or may do, is different.
  void stateChanged();
  void referenceChanged();
  void planChanged();
  void errorChanged();
  void resultChanged();
  /// openingText() is another one.
  void openingChanged();
  void replayOpened();
  void replayClosed();
  void replayFailed(const QString& sentence);
  /// A message that needs no answer; empty if there is none.
  void noted(const QString& sentence);

private:
  void connectSetup();
  void prepare(InputSource input);
  void prepareNow(InputSource input);
  void openInBackground();
  void endOpening();
  void use(const session::Scenario& scenario, const std::optional<InsertionControl::Parts>& parts);
  void beginReplay();
  void setLoading(const std::optional<session::Scenario>& scenario);
  void discardResult();

  InsertionControl control_;
  SafetyStop safety_;
  SetupControl* setup_;
  ReplayPlayer* replay_;
  GraspControl held_;
  std::optional<session::Scenario> loading_;
  std::function<QString()> commit_;
  std::optional<ReferenceInsertion> reference_;
  std::optional<PlannedForce> plan_;
  Background reading_;
  bool isResultRequested_ = false;
  double readUpTo_ =
      0.0;  ///< Time of the insertion when it was asked, which stands still at rest [s].
  std::shared_ptr<const ReportContent> result_;
  std::optional<std::filesystem::path> before_;
  QString error_;
  Background opening_;
  QString openingName_;  ///< Name of the device that is being opened; else empty.
  QElapsedTimer openingSince_;
  QTimer openingTimer_;
  bool isDeviceMissing_ = false;  ///< The script is the input because the device cannot be opened.
  InputSource inputBefore_ = InputSource::scripted;  ///< Before the replay, or in the last window.
};

}  // namespace perilymph::gui
