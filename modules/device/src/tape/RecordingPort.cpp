// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <atomic>
#include <fstream>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "perilymph/foundation/RealTime.h"
#include "perilymph/realtime/Doorbell.h"
#include "perilymph/realtime/Pacer.h"
#include "perilymph/realtime/SpscRing.h"
#include "tape/TapePorts.h"

namespace perilymph::device {

namespace {

// A second at 1 kHz; drained every 20 ms.
constexpr std::size_t notesKept = 1024;
constexpr std::int64_t betweenDrains = 20'000'000;  // [ns]

struct Note {
  std::int64_t time = 0;  // [ns]
  std::int64_t took = 0;  // [ns]
  TapeEvent event = TapeEvent::input;
  RawReport report;
};

/// Entries of one handle: written by its thread, read by the tape's thread.
struct Notes {
  realtime::SpscRing<Note> ring{notesKept};
  std::atomic<std::uint64_t> lost{0};
};

/// The file and its writing thread.
class TapeWriter {
public:
  TapeWriter(std::ofstream file, Clock clock) : file_(std::move(file)), clock_(clock)
  {
    began_ = clock_();
    thread_ = std::thread([this] {
      declareThread(ThreadRole::tapeWriter);
      run();
    });
  }
  ~TapeWriter()
  {
    isStopping_ = true;
    bell_.ring();
    thread_.join();
  }
  TapeWriter(const TapeWriter&) = delete;
  TapeWriter& operator=(const TapeWriter&) = delete;

  std::shared_ptr<Notes> newNotes()
  {
    const std::lock_guard lock(mutex_);
    return all_.emplace_back(std::make_shared<Notes>());
  }
  std::int64_t now() const noexcept { return clock_() - began_; }

private:
  void run()
  {
    while (!isStopping_) {
      bell_.waitUntil(realtime::monotonicNanoseconds() + betweenDrains);
      drain();
    }
    drain();
    std::uint64_t lost = 0;
    for (const auto& notes : all_) lost += notes->lost;
    if (lost > 0) file_ << "# lost " << lost << " reports: the disk was too slow\n";
  }
  void drain()
  {
    std::vector<std::shared_ptr<Notes>> all;
    {
      const std::lock_guard lock(mutex_);
      all = all_;
    }
    for (const auto& notes : all)
      while (notes->ring.take(note_))
        file_ << tapeLine(note_.event, note_.time, note_.took, note_.report);
    file_.flush();
  }

  std::ofstream file_;
  Clock clock_;
  std::int64_t began_ = 0;  // [ns]
  Note note_;
  std::mutex mutex_;  // between threads that open handles and the writing thread
  std::vector<std::shared_ptr<Notes>> all_;
  realtime::Doorbell bell_;
  std::atomic<bool> isStopping_{false};
  std::thread thread_;
};

class RecordingTransport final : public Transport {
public:
  RecordingTransport(std::unique_ptr<Transport> handle, std::shared_ptr<TapeWriter> tape)
      : handle_(std::move(handle)), tape_(std::move(tape)), notes_(tape_->newNotes())
  {
  }

  Transfer read(RawReport& report, Duration timeout) noexcept override
  {
    const Transfer transfer = handle_->read(report, timeout);
    if (transfer == Transfer::done) note(TapeEvent::input, tape_->now(), report);
    return noticed(transfer);
  }
  Transfer write(const RawReport& report) noexcept override
  {
    const std::int64_t began = tape_->now();
    const Transfer transfer = handle_->write(report);
    if (transfer == Transfer::done) note(TapeEvent::written, began, report);
    if (transfer == Transfer::failed) note(TapeEvent::refused, began, report);
    return noticed(transfer);
  }
  Transfer setFeature(const RawReport& report) noexcept override
  {
    const std::int64_t began = tape_->now();
    const Transfer transfer = handle_->setFeature(report);
    if (transfer == Transfer::done) note(TapeEvent::featureSet, began, report);
    return noticed(transfer);
  }
  Transfer getFeature(RawReport& report) noexcept override
  {
    const std::int64_t began = tape_->now();
    const Transfer transfer = handle_->getFeature(report);
    if (transfer == Transfer::done) note(TapeEvent::featureGot, began, report);
    return noticed(transfer);
  }

private:
  void note(TapeEvent event, std::int64_t began, const RawReport& report) noexcept
  {
    note_.event = event;
    note_.time = began;
    note_.took = tape_->now() - began;
    note_.report = report;
    if (!notes_->ring.push(note_)) ++notes_->lost;
  }
  Transfer noticed(Transfer transfer) noexcept
  {
    if (transfer == Transfer::gone && !isGone_) note(TapeEvent::gone, tape_->now(), {});
    isGone_ = isGone_ || transfer == Transfer::gone;
    return transfer;
  }

  std::unique_ptr<Transport> handle_;
  std::shared_ptr<TapeWriter> tape_;
  std::shared_ptr<Notes> notes_;
  Note note_;
  bool isGone_ = false;
};

class RecordingPort final : public HidPort {
public:
  RecordingPort(std::unique_ptr<HidPort> port, std::shared_ptr<TapeWriter> tape)
      : port_(std::move(port)), tape_(std::move(tape))
  {
  }

  Result<std::unique_ptr<Transport>> open() override
  {
    auto handle = port_->open();
    if (!handle) return handle.error();
    return std::unique_ptr<Transport>(
        std::make_unique<RecordingTransport>(*std::move(handle), tape_));
  }
  int fileForGuard() noexcept override { return port_->fileForGuard(); }
  void awaitChange(Duration timeout) noexcept override { port_->awaitChange(timeout); }

private:
  std::unique_ptr<HidPort> port_;
  std::shared_ptr<TapeWriter> tape_;
};

}  // namespace

Result<std::unique_ptr<HidPort>> recordingPort(std::unique_ptr<HidPort> port,
                                               const std::filesystem::path& file,
                                               const ReportTape& head, Clock clock)
{
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream << tapeHead(head) << std::flush;
  if (!stream)
    return Error{
        "The tape %1 cannot be written. Check that its folder is there and may be written to.",
        file};
  auto tape = std::make_shared<TapeWriter>(
      std::move(stream), clock != nullptr ? clock : realtime::monotonicNanoseconds);
  return std::unique_ptr<HidPort>(
      std::make_unique<RecordingPort>(std::move(port), std::move(tape)));
}

}  // namespace perilymph::device
