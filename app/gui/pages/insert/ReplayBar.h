// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The bottom bar of a replay: play, step, speed, and position.

#include <QWidget>
#include <vector>

class QLabel;
class QPushButton;

namespace perilymph::gui {

class ReplayPlayer;

/// An event on the line of a replay.
struct ReplayMark {
  double fraction = 0.0;  ///< Place on the line, 0 to 1.
  QString text;           ///< "3.21 s: rupture of the partition".
  bool isAlarm = false;   ///< An injury, or an end before the stop.
};

/// A slider for the position of the replay, with the range that is ready and the events. A mark names
/// its event as a tool tip; a press close to it goes there.
class Scrubber : public QWidget {
  Q_OBJECT
public:
  explicit Scrubber(QWidget* parent);
  void setFractions(double here, double ready);
  void setMarks(std::vector<ReplayMark> marks);
  const std::vector<ReplayMark>& marks() const { return marks_; }
  double fraction() const { return here_; }
  QSize sizeHint() const override { return {240, 28}; }

Q_SIGNALS:
  void draggedTo(double fraction);

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

private:
  double xOf(double fraction) const;
  /// The mark within 4 px of a place; null if there is none.
  const ReplayMark* markAt(double x) const;

  double here_ = 0.0, ready_ = 0.0;
  std::vector<ReplayMark> marks_;
};

class ReplayBar : public QWidget {
  Q_OBJECT
public:
  explicit ReplayBar(QWidget* parent);

  /// Shows the position of a replay.
  void showPlace(const ReplayPlayer& replay);
  /// Shows the events of a replay that was opened.
  void showEvents(const ReplayPlayer& replay);

Q_SIGNALS:
  void playRequested();
  void stepRequested(int ticks);
  void slowerRequested();
  void fasterRequested();
  void draggedTo(double fraction);
  void closeRequested();

private:
  QPushButton* addButton(const QString& text, const char* name, int width, const QString& tip);

  QPushButton *play_, *back_, *forth_, *slower_, *faster_, *close_;
  QLabel *speed_, *time_, *status_;
  Scrubber* scrubber_;
};

}  // namespace perilymph::gui
