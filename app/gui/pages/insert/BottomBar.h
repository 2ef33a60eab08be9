// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The bottom bar: start, pause, withdraw, reset; progress; status line.

#include <QWidget>

class QLabel;
class QPushButton;

namespace perilymph::gui {

/// Progress of an insertion along its travel, as a line.
class ProgressLine : public QWidget {
  Q_OBJECT
public:
  explicit ProgressLine(QWidget* parent);
  /// @param fraction  0 at the start, 1 at full depth.
  void setFraction(double fraction);
  double fraction() const { return fraction_; }
  QSize sizeHint() const override { return {240, 28}; }

protected:
  void paintEvent(QPaintEvent*) override;

private:
  double fraction_ = 0.0;
};

/// Buttons, progress and status.
class BottomBar : public QWidget {
  Q_OBJECT
public:
  explicit BottomBar(QWidget* parent);

  /// Function of the main button.
  enum class Main { start, pause };
  void setMain(Main action, bool isEnabled);
  /// Disables the main button with a reason; empty enables it.
  void setWait(const QString& reason);
  void setWithdrawEnabled(bool isEnabled);
  void setProgress(double fraction, double time_s);
  /// @param isError  Highlighted, because of an error of the recording or the haptic loop.
  void setStatus(const QString& label, bool isError);

Q_SIGNALS:
  void startRequested();
  void pauseRequested();
  void withdrawRequested();
  void resetRequested();

protected:
  /// The pause precedes the painting of its button, which may take tens of milliseconds.
  bool eventFilter(QObject* target, QEvent* event) override;

private:
  QPushButton* addButton(const QString& text, const char* name, int width);

  Main main_ = Main::start;
  bool hasPaused_ = false;  ///< The click that follows was handled.
  QPushButton* start_;
  QPushButton* withdraw_;
  QPushButton* reset_;
  ProgressLine* progress_;
  QLabel* time_;
  QLabel* status_;
};

}  // namespace perilymph::gui
