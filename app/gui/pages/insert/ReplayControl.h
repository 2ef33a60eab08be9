// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Display of a replay in place of the live insertion.

#include <QObject>

class QKeyEvent;

namespace perilymph::gui {

class InsertionViews;
class ReplayBar;
class ReplayPlayer;

/// Shows a player in the views of the insertion, with its own bar and keys.
class ReplayControl : public QObject {
  Q_OBJECT
public:
  /// @param page  Becomes the parent of the bar.
  ReplayControl(ReplayPlayer& player, InsertionViews& views, QWidget* page);

  ReplayBar* bar() const { return bar_; }

  /// Starts at its beginning. The insertion must have ended.
  void begin();

  /// One timer event. Pauses while the page is not visible.
  void step(double elapsed_s, bool isSeen);
  void updateReadouts();
  /// Handles a key while a recording is open; Escape emits closeRequested(). False if the key is not
  /// handled.
  bool takeKey(const QKeyEvent& event);

Q_SIGNALS:
  void closeRequested();

private:
  void connectBar();
  void togglePlaying();

  ReplayPlayer& player_;
  InsertionViews& views_;
  ReplayBar* bar_;
  std::size_t charted_ = 0;  ///< Number of samples in the charts.
};

}  // namespace perilymph::gui
