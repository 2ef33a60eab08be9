#pragma once

// A recorded insertion being looked at: where it is, how fast it goes, whether its bits agree.

#include <QObject>
#include <filesystem>
#include <memory>

#include "gui/run/Background.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/Playback.h"

namespace perilymph::gui {

/// Moves a playback on with the time of the window. No hand and no device has a part in it.
class ReplayPlayer : public QObject {
  Q_OBJECT
public:
  explicit ReplayPlayer(QObject* parent);
  ~ReplayPlayer() override;

  /// Opens a recording beside this thread; opened() or failed() follows. Once it is open its bits
  /// are compared, and checked() says how that ended.
  void open(const std::filesystem::path& file);
  void close();
  bool isOpening() const { return opening_.isBusy(); }
  bool isOpen() const { return playback_ != nullptr; }
  /// While it is open.
  const session::Playback& playback() const { return *playback_; }

  void play();
  void pause() { isPlaying_ = false; }
  bool isPlaying() const { return isPlaying_; }
  /// Against the time it took: 0.1, 0.25, 0.5, 1, 2 or 4.
  double speed() const;
  void slower();
  void faster();

  void seek(std::uint64_t place);
  /// Stops, and goes so many ticks forward or back.
  void stepBy(std::int64_t ticks);

  /// Lets the time of the window go by. True if there is a new picture.
  bool advance(double elapsed_s);
  std::uint64_t place() const { return place_; }
  /// Up to here it can be shown at once.
  std::uint64_t ready() const;
  const haptics::Snapshot& now() const { return now_; }

  /// In words: still comparing, every bit the same, or the first tick that differs.
  QString verdict() const { return verdict_; }
  bool isError() const { return isError_; }
  bool isChecked() const { return isOpen() && !checking_.isBusy(); }

Q_SIGNALS:
  void opened();
  void failed(const QString& sentence);
  void checked();

private:
  void check();

  std::shared_ptr<session::Playback> playback_;
  // Behind the playback: their threads end first.
  Background opening_, checking_;
  haptics::Snapshot now_{};
  double position_ = 0.0;  ///< [ticks]
  std::uint64_t place_ = 0;
  int speed_ = 0;
  bool isPlaying_ = false, isNew_ = false;
  QString verdict_;
  bool isError_ = false;
};

}  // namespace perilymph::gui
