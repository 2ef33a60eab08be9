// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The page CT: from the patient's scan to the patient's cochlea.

#include <QWidget>
#include <array>
#include <filesystem>
#include <optional>

#include "gui/pages/ct/CtStudy.h"
#include "gui/pages/ct/CtWork.h"
#include "gui/setup/Setup.h"
#include "perilymph/broadcast/CtImage.h"
#include "perilymph/haptics/Snapshot.h"

namespace perilymph::gui {

class CtPanel;
class PlaneView;
class SurfaceView;

/// Opens a scan, shows it in three linked planes, measures the cochlea, and offers it for insertion.
class CtPage : public QWidget {
  Q_OBJECT
public:
  explicit CtPage(QWidget* parent);

  /// Opens a folder or a file with a CT; the series that suits a cochlea best is read.
  void open(const std::filesystem::path& path);
  /// Cancels the current task. False if there was none.
  bool cancel();

  /// Shows the array of an insertion in the pictures if it is in the cochlea measured here.
  void showInsertion(const session::Scenario& scenario, const anatomy::ScalaTympani& scala,
                     const haptics::Snapshot& now);
  /// The CT and the cochlea in it, if that is the scenario's.
  std::optional<broadcast::PlacedCt> placedCt(const session::Scenario& scenario) const;

  CtStudy& study() { return study_; }
  bool isBusy() const { return work_.isBusy(); }

Q_SIGNALS:
  /// An insertion into the measured cochlea was asked for.
  void setupChosen(const perilymph::gui::Setup& setup);
  /// A plan for the measured cochlea was asked for. The patient is saved.
  void planAsked(const perilymph::anatomy::Patient& patient);

protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  bool isInMeasuredCochlea(const session::Scenario& scenario) const;
  void connectWork();
  void connectPanel();
  void measure(bool isAtCrosshair);
  /// Shows one view alone, or all again.
  void maximize(QWidget* chosen);
  void saveSurface();
  void saveMarks();
  void loadMarks();
  void showDone(const Result<Done>& done, const QString& file);

  CtStudy study_;
  CtWork work_;
  CtWork thumbnails_;
  imaging::CtSeriesList list_;
  std::optional<anatomy::Patient> patient_;  ///< Whose cochlea was offered for insertion or a plan.
  QString task_;
  CtPanel* panel_;
  QWidget* pictures_;
  std::array<PlaneView*, 3> views_{};
  SurfaceView* surface_;
};

}  // namespace perilymph::gui
