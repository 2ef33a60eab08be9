// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A temporary message at the bottom of the window.

#include <QFrame>
#include <QTimer>
#include <functional>

class QLabel;
class QPushButton;

namespace perilymph::gui {

class Notice : public QFrame {
  Q_OBJECT
public:
  explicit Notice(QWidget* parent);

  /// Shows a message for some seconds.
  void say(const QString& sentence);
  /// Shows a message with an action; stays until it is answered.
  void offer(const QString& sentence, const QString& action, std::function<void()> act);
  QString sentence() const;

protected:
  bool eventFilter(QObject* target, QEvent* event) override;

private:
  void place();

  QLabel* label_;
  QPushButton* act_;
  QPushButton* dismiss_;
  std::function<void()> action_;
  QTimer timer_;
};

}  // namespace perilymph::gui
