// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Background tasks of the page Outcome: the ear in the CT after surgery, and the array in it.

#include <QObject>
#include <QString>
#include <QTimer>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "gui/run/Background.h"
#include "perilymph/outcome/FoundArray.h"

namespace perilymph::gui {

/// What the page computes with.
struct OutcomeFinder {
  std::function<Result<ct::CochleaMeasures>(const ct::CtVolume&, const ct::MeasureRequest&)>
      measure;
  std::function<Result<outcome::Ear>(const ct::CtVolume&, const ct::CtVolume&,
                                     const ct::CochleaMeasures&, const std::stop_token&,
                                     const std::function<void(double)>&)>
      registeredEar;
  std::function<Result<outcome::Ear>(const ct::CtVolume&, const ct::MeasureRequest&)> measuredEar;
  std::function<Result<outcome::FoundArray>(const ct::CtVolume&, const outcome::Ear&,
                                            const outcome::ContactsRequest&)>
      findContacts;
};
/// That of the engine.
OutcomeFinder engineFinder();

/// What is done until the contacts are found.
enum class OutcomeStep { readBefore, measureBefore, carryOver, measureHere, findContacts };

/// The patient's CT before surgery.
struct EarlierCt {
  std::filesystem::path place;  ///< Where it was read.
  std::string series;           ///< Its SHA-256.
  ct::Marks marks;              ///< Landmarks of the measures that a person placed in it.
};

/// Runs one task at a time; a new one replaces it. Results arrive as signals in the window's thread.
class OutcomeWork : public QObject {
  Q_OBJECT
public:
  using Volume = std::shared_ptr<const ct::CtVolume>;
  using SharedEar = std::shared_ptr<const outcome::Ear>;

  explicit OutcomeWork(QObject* parent);
  void setFinder(OutcomeFinder finder) { finder_ = std::move(finder); }

  /// Finds the ear: carried over from a CT before surgery if there is one; else, or if that fails,
  /// measured in this one.
  void findEar(const Volume& after, const std::optional<EarlierCt>& before,
               std::optional<anatomy::Side> side);
  /// Finds the contacts; the request needs no hooks.
  void findContacts(const Volume& after, const SharedEar& ear, outcome::ContactsRequest request);
  void cancel();
  bool isBusy() const { return background_.isBusy(); }

Q_SIGNALS:
  /// The fraction is that of the ear, from any of its steps, or of the contacts.
  void progressed(perilymph::gui::OutcomeStep step, double fraction);
  /// @param note  Why the CT before surgery was not used; else empty.
  void earFound(std::shared_ptr<const perilymph::outcome::Ear> ear, const QString& note);
  void found(std::shared_ptr<const perilymph::outcome::FoundArray> array);
  /// A task ended without a result; empty if it was canceled.
  void failed(const QString& sentence);

private:
  /// How far a task is, shared with its thread.
  struct State {
    std::atomic<OutcomeStep> step{};
    std::atomic<double> fraction{0.0};
  };
  using Progress = std::shared_ptr<State>;

  Progress begin(OutcomeStep step);
  void end();

  OutcomeFinder finder_;
  Progress progress_;
  QTimer timer_;
  Background background_;
};

}  // namespace perilymph::gui
