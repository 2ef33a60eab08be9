// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A collapsible section of the panel.

#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace perilymph::gui {

/// A line, a title, an optional note at its right, and rows below. A click on the title collapses
/// them.
class Section : public QWidget {
  Q_OBJECT
public:
  /// @param name  Object name of the title's button, for tests.
  Section(const QString& title, const char* name, QWidget* parent);

  QVBoxLayout& rows() { return *rows_; }
  QWidget* body() { return body_; }
  void setNote(const QString& note, const QString& tip = {});
  void setFolded(bool isFolded);
  bool isFolded() const;

private:
  QString title_;
  QPushButton* head_;
  QLabel* note_;
  QWidget* body_;
  QVBoxLayout* rows_;
};

/// A row of the panel: a name on the left, a control on the right.
QWidget* namedRow(const QString& name, QWidget* control, QWidget* parent);

}  // namespace perilymph::gui
