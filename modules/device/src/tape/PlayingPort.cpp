// SPDX-License-Identifier: BSD-3-Clause
#include <ctime>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

#include "perilymph/realtime/Pacer.h"
#include "tape/TapePorts.h"

namespace perilymph::device {

namespace {

/// A tape in playback, shared by its handles.
struct Playing {
  ReportTape tape;
  TapeTime time;
  std::mutex mutex;                        // between handles
  std::optional<std::int64_t> began = {};  // [ns]
  std::size_t told = 0;                    // entries up to the last written report
  std::size_t asked = 0;                   // entries up to the last requested feature

  /// Time since playback started [ns].
  std::int64_t now() noexcept
  {
    const std::lock_guard lock(mutex);
    if (!began) began = time.now();
    return time.now() - *began;
  }
};

class PlayingTransport final : public Transport {
public:
  explicit PlayingTransport(std::shared_ptr<Playing> playing) : playing_(std::move(playing)) {}

  Transfer read(RawReport& report, Duration timeout) noexcept override
  {
    const std::int64_t now = playing_->now();
    const TapeEntry* entry = nextInput();
    const std::int64_t patience = std::llround(timeout.si() * 1e9);
    const std::int64_t wait = entry == nullptr ? patience : std::min(patience, entry->time - now);
    if (wait > 0) playing_->time.advance(wait);
    if (entry == nullptr || entry->time > playing_->now()) return Transfer::nothing;
    if (entry->event == TapeEvent::gone) return Transfer::gone;
    take(*entry, report);
    ++at_;
    return Transfer::done;
  }
  Transfer write(const RawReport&) noexcept override
  {
    const TapeEntry* const entry = nextOf(playing_->told, [](TapeEvent event) {
      return event == TapeEvent::written || event == TapeEvent::refused;
    });
    return entry != nullptr && entry->event == TapeEvent::refused ? Transfer::failed
                                                                  : Transfer::done;
  }
  Transfer setFeature(const RawReport&) noexcept override { return Transfer::done; }
  Transfer getFeature(RawReport& report) noexcept override
  {
    const TapeEntry* const entry =
        nextOf(playing_->asked, [](TapeEvent event) { return event == TapeEvent::featureGot; });
    if (entry == nullptr || entry->bytes[0] != report.bytes[0]) return Transfer::failed;
    take(*entry, report);
    return Transfer::done;
  }

private:
  static void take(const TapeEntry& entry, RawReport& report) noexcept
  {
    report.size = std::min(entry.bytes.size(), longestReport);
    std::copy_n(entry.bytes.begin(), report.size, report.bytes.begin());
  }
  const TapeEntry* nextInput() noexcept
  {
    const auto& entries = playing_->tape.entries;
    while (at_ < entries.size() && entries[at_].event != TapeEvent::input &&
           entries[at_].event != TapeEvent::gone)
      ++at_;
    return at_ < entries.size() ? &entries[at_] : nullptr;
  }
  template <class Claim>
  const TapeEntry* nextOf(std::size_t& at, Claim fits) noexcept
  {
    const std::lock_guard lock(playing_->mutex);
    const auto& entries = playing_->tape.entries;
    while (at < entries.size())
      if (const TapeEntry& entry = entries[at++]; fits(entry.event)) return &entry;
    return nullptr;
  }

  std::shared_ptr<Playing> playing_;
  std::size_t at_ = 0;
};

class PlayingPort final : public HidPort {
public:
  explicit PlayingPort(std::shared_ptr<Playing> playing) : playing_(std::move(playing)) {}

  Result<std::unique_ptr<Transport>> open() override
  {
    return std::unique_ptr<Transport>(std::make_unique<PlayingTransport>(playing_));
  }
  void awaitChange(Duration timeout) noexcept override
  {
    playing_->time.advance(std::llround(timeout.si() * 1e9));
  }

private:
  std::shared_ptr<Playing> playing_;
};

void sleepFor(std::int64_t nanoseconds)
{
  const timespec length{nanoseconds / 1'000'000'000, nanoseconds % 1'000'000'000};
  ::clock_nanosleep(CLOCK_MONOTONIC, 0, &length, nullptr);
}

}  // namespace

std::unique_ptr<HidPort> playingPort(ReportTape tape, TapeTime time)
{
  auto playing = std::make_shared<Playing>();
  playing->tape = std::move(tape);
  playing->time = std::move(time);
  if (playing->time.now == nullptr) playing->time = {realtime::monotonicNanoseconds, sleepFor};
  return std::make_unique<PlayingPort>(std::move(playing));
}

}  // namespace perilymph::device
