#pragma once

// A quiet line over the foot of the window that says what was done, and goes by itself.

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

  /// Says something for some seconds.
  void say(const QString& sentence);
  /// Says something and offers to do something about it; stays until it is answered.
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
