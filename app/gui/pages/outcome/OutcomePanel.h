// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The panel beside the CT after surgery, in three steps: surgery, CT, record.

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "gui/setup/PatientLibrary.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace perilymph::gui {

class CtSource;
class Selector;
class SurgeryForm;

/// What is written out of an outcome.
enum class OutcomeExport { table, json, markups, picture };

/// Shows patient, form and buttons, and emits their requests.
class OutcomePanel : public QWidget {
  Q_OBJECT
public:
  explicit OutcomePanel(QWidget* parent);

  /// Reads the patients again; the chosen one stays.
  void refresh();
  /// The chosen patient; empty before one is chosen.
  const std::optional<SavedPatient>& patient() const { return patient_; }
  /// Chooses a saved patient by its file. False if there is none with A and B.
  bool choosePatient(const std::filesystem::path& file);
  /// Shows which of the saved outcomes is open.
  void showVersion(std::size_t place);
  SurgeryForm& form() { return *form_; }
  CtSource& source() { return *source_; }

  /// Shows a task with its progress, 0 to 1, and a button to cancel it.
  void showTask(const QString& task, double fraction);
  /// Ends the display of a task; an empty sentence shows nothing.
  void showIdle(const QString& sentence, bool isError = false);
  /// Shows what has room in one sentence after an export.
  struct State {
    bool hasCt = false, hasFound = false, canUndo = false, canRedo = false;
    bool isSaved = false;   ///< As it is shown.
    QString obstacle = {};  ///< Why it cannot be saved, a sentence; else empty.
  };
  void showState(const State& state);

Q_SIGNALS:
  /// Another patient is wanted; the chosen one stays until choosePatient().
  void patientWanted(const std::filesystem::path& file);
  void patientChosen();
  /// A saved outcome is wanted, by its place in the patient's record.
  void versionWanted(std::size_t place);
  void findRequested();
  void cancelRequested();
  void undoRequested();
  void redoRequested();
  void saveRequested();
  void exportRequested(perilymph::gui::OutcomeExport kind);
  void reportRequested();

private:
  void choose(const QString& key);
  void listVersions();
  void showPatient();
  void addFoot(QVBoxLayout& column);
  void showButtons();

  std::vector<SavedPatient> patients_;
  std::optional<SavedPatient> patient_;
  State state_;
  QString version_;  ///< Place of the saved outcome that is open; empty if none is.
  bool isBusy_ = false;
  Selector *patientList_, *versions_;
  SurgeryForm* form_;
  CtSource* source_;
  QLabel* status_;
  QProgressBar* progress_;
  QPushButton *find_, *cancel_, *undo_, *redo_, *save_, *export_, *report_;
};

}  // namespace perilymph::gui
