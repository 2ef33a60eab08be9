// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A strip below the top bar with a message; the page gives way to it, so that it covers nothing.

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

  /// Shows a message for some seconds; nothing if it is empty.
  void showMessage(const QString& sentence);
  /// Shows a message with an action for half a minute.
  void offer(const QString& sentence, const QString& action, std::function<void()> act);
  /// Asks a question that stays until one of its buttons answers it.
  /// @param refusal  Text of the button that changes nothing.
  void ask(const QString& question, const QString& action, const QString& refusal,
           std::function<void()> act);
  /// Hides an offer; a question stays.
  void dropOffer();
  /// Hides a question that needs no answer any more, unless another message is shown.
  void dropQuestion(const QString& question);
  QString sentence() const;

private:
  void show(const QString& sentence, const QString& action, const QString& refusal,
            std::function<void()> act);

  QLabel* label_;
  QPushButton* act_;
  QPushButton* dismiss_;
  std::function<void()> action_;
  QTimer timer_;
};

}  // namespace perilymph::gui
