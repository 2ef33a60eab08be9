// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The values of one insertion of a study.

#include <QWidget>

#include "perilymph/study/StudyFile.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace perilymph::gui {

/// Lists the values of the chosen insertion, and offers to run it again and replay it.
class StudyDetails : public QWidget {
  Q_OBJECT
public:
  explicit StudyDetails(QWidget* parent);

  void show(const study::StudyResult& result);
  void showNone();
  /// While an insertion runs, none can be asked for.
  void setBusy(bool isBusy);

Q_SIGNALS:
  void replayRequested();

private:
  void clear();

  QLabel* hint_;
  QWidget* list_;
  QGridLayout* grid_;
  QPushButton* replay_;
  bool isShown_ = false, isBusy_ = false;
};

}  // namespace perilymph::gui
