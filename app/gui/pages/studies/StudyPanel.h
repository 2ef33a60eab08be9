// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What of a study is plotted: axes, groups and filter.

#include <QWidget>
#include <vector>

#include "gui/pages/studies/StudyPlot.h"

class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace perilymph::gui {

class CheckBox;
class Selector;

/// Lists for the axes, and a check box for each value of each setting.
class StudyPanel : public QWidget {
  Q_OBJECT
public:
  explicit StudyPanel(QWidget* parent);

  /// Offers what a study has, without filters. The axes stay where it has them, too.
  void offer(const study::StudyColumns& columns);
  StudyPlot::Axes axes() const;
  study::StudyFilter filter() const;
  /// What is wrong with the limits as typed, which filter() leaves out; empty if nothing.
  QString problem() const;
  /// Which of the shown insertions tables and lines are of.
  study::StudySelection selection() const;
  /// Selects all insertions.
  void reset();

Q_SIGNALS:
  void newRequested();
  void openRequested();
  void axesChanged();
  void filterChanged();
  void selectionChanged();

private:
  void addAxes(QVBoxLayout& column);
  void addSize(QVBoxLayout& column);
  QLineEdit* addLimit(const char* name, const QString& title);
  void offerFilters(const study::StudyColumns& columns);

  Selector* x_;
  Selector* y_;
  Selector* group_;
  Selector* selection_;
  QLineEdit* minA_ = nullptr;
  QLineEdit* maxA_ = nullptr;
  QVBoxLayout* filters_;
  QWidget* boxesOfStudy_ = nullptr;
  std::vector<std::vector<CheckBox*>> boxes_;  ///< One per factor and level.
};

}  // namespace perilymph::gui
