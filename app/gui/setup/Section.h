#pragma once

// A part of the panel under a title that folds it away.

#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace perilymph::gui {

/// A line, a title, perhaps a note at its right, and rows below. A click on the title folds them.
class Section : public QWidget {
  Q_OBJECT
public:
  /// @param name  Of the title's button: what tests find it by.
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

/// A row of the panel: a name at the left, something at the right.
QWidget* namedRow(const QString& name, QWidget* control, QWidget* parent);

}  // namespace perilymph::gui
