// SPDX-License-Identifier: BSD-3-Clause
#include "recording/Recorder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>

#include "perilymph/foundation/RealTime.h"

namespace perilymph::session {

namespace {

/// Interval of drains: a crash loses at most this plus the duration of a drain.
constexpr std::chrono::milliseconds drainPeriod{20};

}  // namespace

Recorder::Recorder(haptics::HapticLoop& loop, std::unique_ptr<Recording> recording, double timeStep)
    : loop_(loop), recording_(std::move(recording))
{
  const double ticks = std::chrono::duration<double>(drainPeriod).count() / timeStep;
  batch_ = static_cast<std::size_t>(std::max(1.0, std::round(ticks)));
  waiting_.reserve(2 * batch_);
}

Recorder::~Recorder()
{
  stop();
  close();
}

void Recorder::start()
{
  if (thread_.joinable()) return;
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void Recorder::run(const std::stop_token& stop)
{
  declareThread(ThreadRole::recorder);
  while (!stop.stop_requested()) {
    {
      std::unique_lock lock(sleepMutex_);
      sleep_.wait_for(lock, stop, drainPeriod, [] { return false; });
    }
    drain();
    concludeIfRequested();
  }
}

void Recorder::conclude(std::uint64_t lostRecords) noexcept
{
  lostAtConclusion_ = static_cast<std::int64_t>(lostRecords);
}

void Recorder::concludeIfRequested()
{
  std::int64_t lost = lostAtConclusion_;
  if (lost == notRequested || !recording_) return;
  const auto merged = recording_->conclude(static_cast<std::uint64_t>(lost));
  if (merged && !*merged) return;  // somebody reads it: at the next drain
  if (!merged) {
    setError(merged.error().message);
    recording_.reset();
  }
  isConcluded_ = static_cast<bool>(merged);
  lostAtConclusion_.compare_exchange_strong(lost, notRequested);
}

void Recorder::stop() noexcept
{
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
  drain();
}

void Recorder::drain()
{
  try {
    haptics::TickRecord record;
    while (loop_.take(record)) keep(record);
    flush();
  } catch (const std::exception& error) {
    setError(Sentence("The recording stopped: %1.", std::string(error.what())));
  }
}

void Recorder::keep(const haptics::TickRecord& record)
{
  if (!recording_) return;
  waiting_.push_back(record);
  if (waiting_.size() >= batch_) flush();
}

void Recorder::flush()
{
  if (recording_ && !waiting_.empty()) {
    isConcluded_ = false;
    if (const auto done = recording_->append(waiting_); !done) {
      setError(done.error().message);
      // Closing may still merge the written part into one file; the error is kept.
      recording_.reset();
    }
  }
  waiting_.clear();
}

void Recorder::close() noexcept
{
  try {
    flush();
    if (!recording_) return;
    if (const auto done = recording_->close(loop_.statistics().lostRecords, deviceReport_); !done)
      setError(done.error().message);
    recording_.reset();
  } catch (const std::exception& error) {
    setError(Sentence("The recording could not be closed: %1.", std::string(error.what())));
  }
}

void Recorder::setError(const Sentence& sentence)
{
  const std::lock_guard lock(errorMutex_);
  if (error_.empty()) error_ = sentence;
}

Sentence Recorder::error() const
{
  const std::lock_guard lock(errorMutex_);
  return error_;
}

}  // namespace perilymph::session
