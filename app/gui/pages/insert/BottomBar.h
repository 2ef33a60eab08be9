#pragma once

// The bar at the bottom: start, pause, withdraw, reset; how far the array is; one status line.

#include <QWidget>

class QLabel;
class QPushButton;

namespace perilymph::gui {

/// How far an insertion is along its travel: a line that fills.
class ProgressLine : public QWidget {
  Q_OBJECT
public:
  explicit ProgressLine(QWidget* parent);
  /// @param share  0 at the start, 1 at full depth.
  void setFraction(double fraction);
  double fraction() const { return fraction_; }
  QSize sizeHint() const override { return {240, 28}; }

protected:
  void paintEvent(QPaintEvent*) override;

private:
  double fraction_ = 0.0;
};

/// The verbs, the progress and the status.
class BottomBar : public QWidget {
  Q_OBJECT
public:
  explicit BottomBar(QWidget* parent);

  /// What the first button does now.
  enum class Main { start, pause };
  void setMain(Main action, bool isEnabled);
  /// Why the main button has to wait; empty where it has not.
  void setWait(const QString& reason);
  void setWithdrawEnabled(bool isEnabled);
  void setProgress(double fraction, double time_s);
  /// @param isError  Stands out, because the recording or the haptic loop is in trouble.
  void setStatus(const QString& label, bool isError);

Q_SIGNALS:
  void startAsked();
  void pauseAsked();
  void withdrawAsked();
  void resetAsked();

private:
  QPushButton* addButton(const QString& text, const char* name, int width);

  Main main_ = Main::start;
  QPushButton* start_;
  QPushButton* withdraw_;
  QPushButton* reset_;
  ProgressLine* progress_;
  QLabel* time_;
  QLabel* status_;
};

}  // namespace perilymph::gui
