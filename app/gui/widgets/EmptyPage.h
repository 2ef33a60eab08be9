// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Explanation of a page that has no content yet.

#include <QWidget>

class QLabel;
class QMenu;
class QPushButton;

namespace perilymph::gui {

/// A title and a sentence in the center of a page.
class EmptyPage : public QWidget {
  Q_OBJECT
public:
  EmptyPage(const QString& title, const QString& sentence, QWidget* parent);

  void showMessage(const QString& title, const QString& sentence);
  /// Shows a button under the sentence; none if empty.
  void offer(const QString& action);
  /// Shows a second, plain button under the first.
  void offerAlso(const QString& action);
  /// Shows a button with a menu below them.
  void offerMenu(const QString& title, QMenu* menu);

Q_SIGNALS:
  void actionRequested();
  void otherRequested();

private:
  QLabel* title_;
  QLabel* sentence_;
  QPushButton* action_;
  QPushButton* other_;
};

}  // namespace perilymph::gui
