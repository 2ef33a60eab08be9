// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The page CT: from the patient's scan to the patient's cochlea.

#include <QElapsedTimer>
#include <QTimer>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "gui/pages/Page.h"
#include "gui/pages/ct/CtBone.h"
#include "gui/pages/ct/CtStudy.h"
#include "gui/pages/ct/CtWork.h"
#include "gui/run/InsertionControl.h"
#include "gui/setup/CtRequest.h"
#include "gui/setup/Setup.h"
#include "perilymph/broadcast/CtImage.h"

class QStackedLayout;

namespace perilymph::gui {

class ArchiveView;
class CtPanel;
class MarkupBar;
class PlaneView;
class SurfaceView;

/// Opens a scan, shows it in three linked planes, measures the cochlea, and offers it for insertion.
class CtPage : public Page {
  Q_OBJECT
public:
  /// @param control  The insertion, shown in the pictures if it is in the cochlea measured here.
  CtPage(const InsertionControl& control, QWidget* parent);
  ~CtPage() override;  ///< Keeps what was marked.

  /// Opens a folder or a file with a CT; the series that suits a cochlea best is read, and its cochlea
  /// is measured. Esc ends that; the CT stays.
  void open(const std::filesystem::path& path) override;
  /// A .zip, a DICOMDIR and a folder with one on every page; here any file, for which files hold a CT
  /// is known after reading only.
  Acceptance accepts(const std::filesystem::path& file) const override;
  /// Shows itself for a patient, with the series of the request if it is still where it was read;
  /// else says that it is not.
  void begin(const CtRequest& request);
  bool isBusy() const override;
  bool cancel() override;
  /// D, A, N choose a tool, Return places its next point at the crosshair, K keeps a key image, Del removes the chosen
  /// markup, Ctrl+Z undoes.
  bool takeKey(const QKeyEvent& event) override;
  /// Shows the array where it is now.
  void onShown() override;
  /// Keeps what was marked.
  void onHidden() override { keepMarkups(); }

  /// The CT and the cochlea in it, if that is the scenario's.
  std::optional<broadcast::PlacedCt> placedCt(const session::Scenario& scenario) const;

  /// Bone of the CT in frame W of a patient's cochlea; null if it is not measured in the CT that is
  /// shown.
  std::shared_ptr<const visualization::BoneModel> boneOf(const anatomy::Patient& patient) const;

  /// The insertion's setup, for the line of approach in the cochlea that is measured here.
  struct InsertionSetup {
    std::function<const session::Scenario&()> scenario;
    std::function<bool()> mayChange;
    std::function<void(const SetupChange&)> change;
  };
  void setInsertionSetup(InsertionSetup setup) { insertionSetup_ = std::move(setup); }
  /// Shows the line of approach of the insertion's setup, if that is into the cochlea measured here.
  void followSetup();
  /// The approach of a patient's cochlea that is measured here; empty for any other.
  std::optional<anatomy::Approach> approachOf(const anatomy::Patient& patient) const;

  /// The folder of the CT that is shown, if it is this series of DICOM files.
  std::optional<std::filesystem::path> placeOf(const std::string& seriesKey) const;

  CtStudy& study() { return study_; }
  CtBone& bone() { return bone_; }
  /// Replaces the measurement, by default ct::measureCochlea().
  void setMeasurement(CtWork::Measurement measurement)
  {
    work_.setMeasurement(std::move(measurement));
  }

  /// Reads the list of archives again.
  void showServers();

Q_SIGNALS:
  /// A plan for the measured cochlea was asked for. The patient is saved.
  void planRequested(const perilymph::anatomy::Patient& patient);
  /// The line of approach is another one.
  void approachChanged();
  /// The archives in the settings are to be shown.
  void serversRequested();

protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  bool isInMeasuredCochlea(const session::Scenario& scenario) const;
  bool isMeasured(const anatomy::Patient& patient) const;
  void connectWork();
  void connectPanel();
  void connectArchive();
  void beginTask(const QString& task);
  /// @param series  SHA-256 of the series that is read; empty for the one that suits best.
  void openSeries(const std::filesystem::path& path, const std::string& series);
  /// The same, and the next CT is not looked for beside it.
  void read(const std::filesystem::path& path, const std::string& series);
  void showCt(imaging::LoadedCt&& loaded);
  /// Shows no scan while another one is read, and no code: that was of the former one's patient.
  void leaveScan();
  /// Ends a task with what the reader of the CT remarked.
  void showNotes();
  /// Shows the search in archives, or ends it.
  void showArchive(bool isShown);
  void showProgress(double fraction);
  /// @param then  Called if the new fit belongs to the landmarks and does not contradict them.
  void measure(bool isAtCrosshair, std::function<void()> then = {});
  /// Calls `then` with a fit of the landmarks as they are now: measures first if they moved.
  void withFreshMeasures(std::function<void()> then);
  /// Calls `then`, after a question if another measurement is saved under this code.
  void withFreeCode(const QString& code, std::function<void()> then);
  void insert(const QString& code);
  /// Gives the line of approach to an insertion into the measured cochlea.
  void giveApproach();
  void plan(const QString& code);
  /// Shows one view alone, or all again.
  void maximize(QWidget* chosen);
  /// Keeps a picture of the measured cochlea for the reports of its patient.
  void keepKeyImage();
  void saveSurface();
  /// Offers measures, lumen and picture to an archive.
  void send();
  void saveMarks();
  void loadMarks();
  void connectMarkups();
  void toggleTool(ct::MarkupKind tool);
  /// Shows the markups that are kept of the CT: with a patient, or since the program was started.
  void showKeptMarkups();
  /// Keeps them with the patient, if there is one.
  void keepMarkups();
  void showKeeping();
  /// Keeps the picture of the active view for the reports.
  void takeKeyImage();
  void saveMarkups(bool isTable);
  void loadMarkups();
  void showDone(const Result<void>& done, const QString& file);

  const InsertionControl& control_;
  CtStudy study_;
  CtBone bone_;
  CtWork work_;
  CtWork thumbnails_;
  imaging::CtSeriesList list_;
  CtRequest wanted_;        ///< Series that is opened again; else empty.
  CtRequest sought_;        ///< The same until a scan was shown, whoever found its place.
  std::string codeOf_;      ///< Series whose patient's code is typed; empty: that of the next one.
  QString leftCode_;        ///< The code that leaveScan() removed.
  bool isOpening_ = false;  ///< A folder or file is read.
  bool isReopening_ = false;  ///< The cochlea is looked for before landmarks by hand correct it.
  std::optional<anatomy::Side> side_;  ///< Ear that the next search looks for.
  ct::Marks atRequest_;                ///< Landmarks by hand when the measurement began.
  std::function<void()> then_;         ///< What was asked for and waits for the measurement.
  InsertionSetup insertionSetup_;
  std::optional<anatomy::Patient> patient_;  ///< Whose cochlea was offered for insertion or a plan.
  QString task_;
  QElapsedTimer since_;  ///< Begin of the task.
  QString notes_;        ///< What the reader of the CT remarked.
  CtPanel* panel_;
  QStackedLayout* stages_;
  QWidget* pictures_;
  MarkupBar* markupBar_;
  ArchiveView* archive_;
  std::array<PlaneView*, 3> views_{};
  SurfaceView* surface_;
  QWidget* active_ = nullptr;  ///< The view that was clicked or had the focus last.
  std::filesystem::path
      markupFile_;  ///< Patient's file with whom markups are kept; empty: none yet.
  std::map<std::string, std::vector<ct::Markup>>
      markupsOfSeries_;  ///< Markups of the CTs that were open, by series.
  bool isShowingKept_ = false;
  QTimer keeping_;  ///< Runs from a change of markups until they are kept.
};

}  // namespace perilymph::gui
