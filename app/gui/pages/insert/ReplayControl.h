// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Replay of a recorded insertion in place of the live one.

#include <QObject>
#include <filesystem>

#include "perilymph/session/Playback.h"

class QKeyEvent;

namespace perilymph::gui {

class InsertionViews;
class ReplayBar;
class ReplayPlayer;

/// Shows a replay in the views of the insertion, with its own bar and keys.
class ReplayControl : public QObject {
  Q_OBJECT
public:
  /// @param page  Becomes the parent of the bar.
  ReplayControl(InsertionViews& views, QWidget* page);

  ReplayBar* bar() const { return bar_; }

  /// Opens a recording in the background; emits opened() or failed().
  void open(const std::filesystem::path& file);
  /// Starts at its beginning. The insertion must have ended.
  void begin();
  void close();
  bool isOpen() const;
  /// Only while a recording is open.
  const session::Playback& playback() const;
  /// The snapshot that is shown, likewise.
  const haptics::Snapshot& now() const;

  /// One timer event. Pauses while the page is not visible.
  void step(double elapsed_s, bool isSeen);
  void stepSlowly();
  /// Handles a key while a recording is open; Escape emits closeAsked(). False if the key is not
  /// handled.
  bool takeKey(const QKeyEvent& event);

Q_SIGNALS:
  void opened();
  void failed(const QString& sentence);
  void closeAsked();

private:
  void connectBar();
  void togglePlaying();

  InsertionViews& views_;
  ReplayPlayer* player_;
  ReplayBar* bar_;
  std::size_t charted_ = 0;  ///< Number of samples in the charts.
};

}  // namespace perilymph::gui
