// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/ReplayPlayer.h"

#include "gui/text/DataText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stop_token>

namespace perilymph::gui {

namespace {

constexpr std::array<double, 6> speeds = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0};
constexpr int ordinary = 3;

// Maximum number of ticks computed per frame, if they are not computed yet.
constexpr std::uint64_t maxAhead = 300;

}  // namespace

ReplayPlayer::ReplayPlayer(QObject* parent)
    : QObject(parent), opening_(this), checking_(this), speed_(ordinary)
{
}

ReplayPlayer::~ReplayPlayer() { close(); }

double ReplayPlayer::speed() const { return speeds[std::size_t(speed_)]; }

void ReplayPlayer::slower() { speed_ = std::max(speed_ - 1, 0); }

void ReplayPlayer::faster() { speed_ = std::min(speed_ + 1, int(speeds.size()) - 1); }

void ReplayPlayer::open(const std::filesystem::path& file)
{
  close();
  opening_.run(
      "The recording " + file.string(),
      [file](const std::stop_token&) { return session::Playback::open(file); },
      [this](Result<std::unique_ptr<session::Playback>> playback) {
        if (!playback) return failed(dataText(playback.error().message));
        playback_ = *std::move(playback);
        isPlaying_ = false;
        speed_ = ordinary;
        seek(playback_->beginning());
        check();
        Q_EMIT opened();
      });
}

void ReplayPlayer::close()
{
  opening_.cancel();
  checking_.cancel();
  playback_.reset();
  isPlaying_ = false;
  verdict_.clear();
  isError_ = false;
}

void ReplayPlayer::check()
{
  verdict_ = tr("verifying…");
  isError_ = false;
  checking_.run(
      "The replay",
      [playback = playback_](const std::stop_token& stop) { return playback->compute(stop); },
      [this](const Result<session::Verification>& verified) {
        if (!verified) {
          verdict_ = dataText(verified.error().message);
          isError_ = true;
        } else if (!verified->damage.empty()) {
          verdict_ =
              tr("differs from the recording: %1").arg(QString::fromStdString(verified->damage));
          isError_ = true;
        } else if (verified->difference) {
          verdict_ = tr("differs from sample %1 (%2)")
                         .arg(verified->difference->tick)
                         .arg(QString::fromStdString(verified->difference->field));
          isError_ = true;
        } else if (verified->ticksCompared < playback_->ticks()) {
          verdict_ = tr("verified up to sample %1").arg(verified->ticksCompared);
        } else {
          verdict_ = tr("verified: identical replay");
        }
        Q_EMIT checked();
      });
}

void ReplayPlayer::play()
{
  if (!isOpen()) return;
  // at the end, start from the beginning
  if (place_ + 1 >= playback_->ticks()) seek(playback_->beginning());
  isPlaying_ = true;
}

std::uint64_t ReplayPlayer::ready() const
{
  return isOpen() ? std::max(playback_->computedTicks(), place_ + 1) : 0;
}

void ReplayPlayer::seek(std::uint64_t place)
{
  if (!isOpen()) return;
  const std::uint64_t last = playback_->ticks() - 1;
  const std::uint64_t reachable = std::max(playback_->computedTicks(), place_) + maxAhead;
  place_ = std::min({place, last, reachable});
  position_ = double(place_);
  isNew_ = true;
}

void ReplayPlayer::stepBy(std::int64_t ticks)
{
  pause();
  const auto wanted = std::max<std::int64_t>(0, std::int64_t(place_) + ticks);
  seek(std::uint64_t(wanted));
}

bool ReplayPlayer::advance(double elapsed_s)
{
  if (!isOpen()) return false;
  if (isPlaying_) {
    const double position = position_ + elapsed_s * speed() / playback_->timeStep();
    seek(std::uint64_t(position));
    if (place_ == std::uint64_t(position)) position_ = position;  // keeps the fraction
    if (place_ + 1 >= playback_->ticks()) pause();
  }
  if (!isNew_) return false;
  isNew_ = false;
  const auto shown = playback_->show(place_, now_);
  if (!shown) {
    verdict_ = dataText(shown.error().message);
    isError_ = true;
    pause();
  }
  return bool(shown);
}

}  // namespace perilymph::gui
