// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The panel beside the planes of the CT, in three steps: scan, check, use.

#include <QWidget>
#include <array>
#include <string>
#include <vector>

#include "gui/pages/ct/CtStudy.h"

class QBoxLayout;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace perilymph::gui {

class Choice;
class CtNextSteps;
class CtSource;
class MarkGuide;
class VersionQuestion;

/// Shows a study's numbers and emits the requests of its buttons.
class CtPanel : public QWidget {
  Q_OBJECT
public:
  CtPanel(CtStudy& study, QWidget* parent);

  CtSource& source() { return *source_; }
  /// Shows a task with its progress, 0 to 1, and a button to cancel it.
  void showTask(const QString& task, double fraction);
  /// Ends the display of a task; an empty sentence shows nothing.
  void showIdle(const QString& sentence, bool isError = false);
  /// Guides to a landmark that is being placed; none ends it.
  void showMark(const std::optional<ct::Mark>& mark);
  /// Ends the marking of a structure; false if none was marked.
  bool endStructure();
  /// In two columns, so that numbers and landmarks need no scrolling, or in one.
  void setWide(bool isWide);
  /// Asked before other measures are saved under a code that exists.
  VersionQuestion& question() { return *question_; }
  /// Fills the patient's code in.
  void setCode(const QString& code);
  QString code() const;
  /// Updates numbers and buttons.
  void refresh();

Q_SIGNALS:
  /// @param isAtCrosshair  From the crosshair; else the volume is searched.
  void measureRequested(bool isAtCrosshair);
  void cancelRequested();
  void markRequested(perilymph::ct::Mark mark);
  /// Points are to be added to a structure; none ends it.
  void structureRequested(std::optional<perilymph::ct::MarkupKind> structure);
  void insertRequested(const QString& code);
  void planRequested(const QString& code);
  void saveSurfaceRequested();
  void sendRequested();
  void saveMarksRequested();
  void loadMarksRequested();

private:
  void addStep(QVBoxLayout& column, const QString& title);
  void addSource(QVBoxLayout& column);
  void addView(QVBoxLayout& column);
  void addMeasurement(QVBoxLayout& column);
  void addMeasures(QVBoxLayout& column);
  void addMarks(QVBoxLayout& column);
  void addApproach(QVBoxLayout& column);
  void addStructures(QVBoxLayout& column);
  void addOnward(QVBoxLayout& column);
  /// Marks the step that is to be taken next.
  void showStep();
  void showMeasures();
  void showApproach();

  CtStudy& study_;
  std::vector<QLabel*> steps_;  ///< Headings of the three steps.
  QBoxLayout* columns_;
  CtSource* source_;
  Choice *patientPlanes_, *cochleaPlanes_;
  QComboBox *window_, *slab_;
  QPushButton *search_, *measureHere_, *cancel_;
  QProgressBar* progress_;
  QLabel* status_;
  QLabel *side_, *fittedHeading_, *stale_, *change_, *flags_, *duct_;
  std::array<QLabel*, 4> fitted_{}, marked_{};
  std::array<QPushButton*, ct::markCount> marks_{};
  MarkGuide* guide_;
  QPushButton *undo_, *redo_;
  std::vector<QWidget*> approach_;  ///< What is shown of a line of approach.
  QLabel *inPlane_, *outOfPlane_, *approachLimit_;
  QPushButton* resetApproach_;
  /// A structure of the approach: begins to mark it, its distance, removes it.
  struct StructureRow {
    QPushButton* mark;
    QLabel* distance;
    QPushButton* remove;
  };
  std::array<StructureRow, ct::approachStructures.size()> structures_{};
  QLabel* structureGuide_;
  CtNextSteps* onward_;
  VersionQuestion* question_;
  QPushButton *saveMarks_, *loadMarks_;
  bool isBusy_ = false;
};

}  // namespace perilymph::gui
