#pragma once

// A recorded insertion looked at again, in the place of the one that runs.

#include <QObject>
#include <filesystem>

#include "perilymph/session/Playback.h"

class QKeyEvent;

namespace perilymph::gui {

class InsertionViews;
class ReplayBar;
class ReplayPlayer;

/// Shows a replay in the views of the insertion, with a bar and keys of its own.
class ReplayControl : public QObject {
  Q_OBJECT
public:
  /// @param page  Becomes the parent of the bar.
  ReplayControl(InsertionViews& views, QWidget* page);

  ReplayBar* bar() const { return bar_; }

  /// Opens a recording beside this thread; opened() or failed() follows.
  void open(const std::filesystem::path& file);
  /// Shows it from its beginning. The insertion must have ended before.
  void begin();
  void close();
  bool isOpen() const;
  /// While it is open.
  const session::Playback& playback() const;

  /// One turn of the window. It pauses while the page is not seen.
  void step(double elapsed_s, bool isSeen);
  void stepSlowly();
  /// Does what a key asks for while it is open; closeAsked() follows Escape. False if the key is
  /// for others.
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
  std::size_t charted_ = 0;  ///< Samples that are in the charts.
};

}  // namespace perilymph::gui
