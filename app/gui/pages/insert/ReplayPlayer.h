// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Player of a recorded insertion: position, speed, and verification.

#include <QObject>
#include <filesystem>
#include <memory>

#include "gui/run/Background.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/session/Playback.h"

namespace perilymph::gui {

/// Advances a playback with the window's time. No device is involved.
class ReplayPlayer : public QObject {
  Q_OBJECT
public:
  explicit ReplayPlayer(QObject* parent);
  ~ReplayPlayer() override;

  /// Opens a recording in the background; emits opened() or failed(). Then the recording is
  /// verified; emits checked().
  void open(const std::filesystem::path& file);
  void close();
  bool isOpening() const { return opening_.isBusy(); }
  bool isOpen() const { return playback_ != nullptr; }
  /// Only while a recording is open.
  const session::Playback& playback() const { return *playback_; }

  void play();
  void pause() { isPlaying_ = false; }
  bool isPlaying() const { return isPlaying_; }
  /// Relative to real time: 0.1, 0.25, 0.5, 1, 2 or 4.
  double speed() const;
  void slower();
  void faster();

  void seek(std::uint64_t place);
  /// Pauses, and moves by a number of ticks.
  void stepBy(std::int64_t ticks);

  /// Advances the time. True if there is a new snapshot.
  bool advance(double elapsed_s);
  std::uint64_t place() const { return place_; }
  /// Number of ticks that can be shown at once.
  std::uint64_t ready() const;
  const haptics::Snapshot& now() const { return now_; }

  /// Result of the verification as text: in progress, identical, or the first different tick.
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
  // Declared after the playback, so that their threads end first.
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
