// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What follows the measurement of a cochlea: an insertion, a plan, its surface as a file.

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;

namespace perilymph::gui {

/// The patient's code, under which the measures are saved, and the buttons that need it.
class CtNextSteps : public QWidget {
  Q_OBJECT
public:
  explicit CtNextSteps(QWidget* parent);

  /// In two rows, or below each other.
  void setWide(bool isWide);
  /// @param isFree   No task runs.
  /// @param isStale  The landmarks moved, so that each way onward measures first.
  void show(bool isMeasured, bool isFree, bool isStale);

  /// A code that may stand for a patient is typed.
  bool hasCode() const;
  /// Fills the code in.
  void setCode(const QString& code);
  QString code() const;
  /// Marks the code to be typed again.
  void editCode();

Q_SIGNALS:
  void codeChanged();
  void insertRequested(const QString& code);
  void planRequested(const QString& code);
  void saveSurfaceRequested();
  void sendRequested();

private:
  void showState();

  bool isMeasured_ = false, isFree_ = false, isStale_ = false;
  QLineEdit* code_;
  QLabel* refusal_;  ///< Why the code is invalid.
  QPushButton *insert_, *plan_, *saveSurface_, *send_;
};

}  // namespace perilymph::gui
