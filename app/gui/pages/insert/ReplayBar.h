// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The bottom bar of a replay: play, step, speed, and position.

#include <QWidget>

class QLabel;
class QPushButton;

namespace perilymph::gui {

class ReplayPlayer;

/// A slider for the position of the replay, with the range that is ready.
class Scrubber : public QWidget {
  Q_OBJECT
public:
  explicit Scrubber(QWidget* parent);
  void setFractions(double here, double ready);
  double fraction() const { return here_; }
  QSize sizeHint() const override { return {240, 28}; }

Q_SIGNALS:
  void draggedTo(double fraction);

protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

private:
  double here_ = 0.0, ready_ = 0.0;
};

class ReplayBar : public QWidget {
  Q_OBJECT
public:
  explicit ReplayBar(QWidget* parent);

  /// Shows the position of a replay.
  void showPlace(const ReplayPlayer& replay);

Q_SIGNALS:
  void playAsked();
  void stepAsked(int ticks);
  void slowerAsked();
  void fasterAsked();
  void draggedTo(double fraction);
  void closeAsked();

private:
  QPushButton* addButton(const QString& text, const char* name, int width, const QString& tip);

  QPushButton *play_, *back_, *forth_, *slower_, *faster_, *close_;
  QLabel *speed_, *time_, *status_;
  Scrubber* scrubber_;
};

}  // namespace perilymph::gui
