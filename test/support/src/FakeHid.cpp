// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/FakeHid.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>

namespace perilymph::test {

namespace {

using device::RawReport;
using device::Transfer;

constexpr std::size_t queueLength = 63;
constexpr std::size_t inputSize = 10, outputSize = 7;  // including the report number

void put(RawReport& report, std::size_t at, std::int16_t value)
{
  const auto bits = static_cast<std::uint16_t>(value);
  report.bytes[at] = static_cast<std::uint8_t>(bits & 0xff);
  report.bytes[at + 1] = static_cast<std::uint8_t>(bits >> 8);
}

std::int16_t get(const RawReport& report, std::size_t at)
{
  return static_cast<std::int16_t>(report.bytes[at] | (report.bytes[at + 1] << 8));
}

using Queue = std::deque<RawReport>;

}  // namespace

struct FakeHid::State {
  mutable std::mutex mutex;
  std::condition_variable changed;
  bool isPlugged = true;
  int generation = 0;  // incremented when connected
  bool holdsWrites = false;
  bool refusesWrites = false;
  bool refusesActuators = false;
  int maxHandles = 1000;
  bool isActuated = false;
  int waitingWrites = 0;
  int opened = 0;
  std::function<void(Duration)> passTime;
  std::function<Transfer(RawReport&)> answer;
  std::vector<std::weak_ptr<Queue>> queues;
  std::vector<RawReport> written;
};

class FakeTransport final : public device::Transport {
public:
  FakeTransport(std::shared_ptr<FakeHid::State> state, std::shared_ptr<Queue> queue, int generation)
      : state_(std::move(state)), queue_(std::move(queue)), generation_(generation)
  {
  }

  Transfer read(RawReport& report, Duration timeout) noexcept override
  {
    std::unique_lock lock(state_->mutex);
    if (timeout.si() > 0.0 && queue_->empty() && !isGone()) {
      const auto passTime = state_->passTime;
      if (passTime) {
        lock.unlock();
        passTime(timeout);
        lock.lock();
      } else {
        state_->changed.wait_for(lock, std::chrono::duration<double>(timeout.si()),
                                 [this] { return isGone() || !queue_->empty(); });
      }
    }
    if (isGone()) return Transfer::gone;
    if (queue_->empty()) return Transfer::nothing;
    report = queue_->front();
    queue_->pop_front();
    return Transfer::done;
  }

  Transfer write(const RawReport& report) noexcept override
  {
    std::unique_lock lock(state_->mutex);
    ++state_->waitingWrites;
    state_->changed.notify_all();
    state_->changed.wait(lock, [this] { return isGone() || !state_->holdsWrites; });
    --state_->waitingWrites;
    if (isGone()) return Transfer::gone;
    if (state_->refusesWrites) return Transfer::failed;
    state_->written.push_back(report);
    state_->changed.notify_all();
    return Transfer::done;
  }

  Transfer setFeature(const RawReport& report) noexcept override
  {
    const std::lock_guard lock(state_->mutex);
    if (isGone()) return Transfer::gone;
    if (state_->refusesActuators) return Transfer::failed;
    state_->isActuated = report.bytes[1] != 0;
    return Transfer::done;
  }

  Transfer getFeature(RawReport& report) noexcept override
  {
    std::unique_lock lock(state_->mutex);
    if (isGone()) return Transfer::gone;
    const auto answer = state_->answer;
    lock.unlock();
    return answer ? answer(report) : Transfer::failed;
  }

private:
  bool isGone() const { return !state_->isPlugged || state_->generation != generation_; }

  std::shared_ptr<FakeHid::State> state_;
  std::shared_ptr<Queue> queue_;
  int generation_;
};

class FakePort final : public device::HidPort {
public:
  explicit FakePort(std::shared_ptr<FakeHid::State> state) : state_(std::move(state)) {}

  Result<std::unique_ptr<device::Transport>> open() override
  {
    const std::lock_guard lock(state_->mutex);
    if (!state_->isPlugged) return Error{"The fake device is not plugged in."};
    if (state_->opened >= state_->maxHandles) return Error{"The fake device is held by another."};
    auto queue = std::make_shared<Queue>();
    state_->queues.push_back(queue);
    ++state_->opened;
    return std::unique_ptr<device::Transport>(
        std::make_unique<FakeTransport>(state_, std::move(queue), state_->generation));
  }

  void awaitChange(Duration timeout) noexcept override
  {
    std::unique_lock lock(state_->mutex);
    state_->changed.wait_for(lock, std::chrono::duration<double>(timeout.si()),
                             [this] { return state_->isPlugged; });
  }

private:
  std::shared_ptr<FakeHid::State> state_;
};

RawReport FakeReport::raw() const
{
  RawReport report;
  put(report, 1, static_cast<std::int16_t>(counter));
  for (std::size_t i = 0; i < 3; ++i) put(report, 3 + 2 * i, place_10um[i]);
  report.bytes[9] = buttons;
  report.size = inputSize;
  return report;
}

FakeHid::FakeHid() : state_(std::make_shared<State>()) {}

std::unique_ptr<device::HidPort> FakeHid::port() { return std::make_unique<FakePort>(state_); }

std::unique_ptr<device::Transport> FakeHid::open() { return *FakePort(state_).open(); }

void FakeHid::send(const RawReport& report)
{
  const std::lock_guard lock(state_->mutex);
  if (!state_->isPlugged) return;
  for (const auto& listener : state_->queues) {
    const auto queue = listener.lock();
    if (queue && queue->size() < queueLength) queue->push_back(report);
  }
  state_->changed.notify_all();
}

void FakeHid::unplug()
{
  const std::lock_guard lock(state_->mutex);
  state_->isPlugged = false;
  state_->isActuated = false;
  state_->queues.clear();
  state_->changed.notify_all();
}

void FakeHid::plugIn()
{
  const std::lock_guard lock(state_->mutex);
  state_->isPlugged = true;
  ++state_->generation;
  state_->changed.notify_all();
}

void FakeHid::holdWrites(bool isHeld)
{
  const std::lock_guard lock(state_->mutex);
  state_->holdsWrites = isHeld;
  state_->changed.notify_all();
}

void FakeHid::refuseWrites(bool isRefused)
{
  const std::lock_guard lock(state_->mutex);
  state_->refusesWrites = isRefused;
}

void FakeHid::refuseActuators(bool isRefused)
{
  const std::lock_guard lock(state_->mutex);
  state_->refusesActuators = isRefused;
}

void FakeHid::maxOpen(int handles)
{
  const std::lock_guard lock(state_->mutex);
  state_->maxHandles = handles;
}

void FakeHid::whenRequested(std::function<Transfer(RawReport&)> answer)
{
  const std::lock_guard lock(state_->mutex);
  state_->answer = std::move(answer);
}

void FakeHid::whenWaiting(std::function<void(Duration)> passTime)
{
  const std::lock_guard lock(state_->mutex);
  state_->passTime = std::move(passTime);
}

std::vector<RawReport> FakeHid::written() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->written;
}

std::vector<std::array<double, 3>> FakeHid::forces() const
{
  std::vector<std::array<double, 3>> forces;
  for (const RawReport& report : written())
    forces.push_back({get(report, 1) * 1e-3, get(report, 3) * 1e-3, get(report, 5) * 1e-3});
  return forces;
}

bool FakeHid::areActuatorsOn() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->isActuated;
}

bool FakeHid::isWriteWaiting() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->waitingWrites > 0 && state_->holdsWrites;
}

int FakeHid::opened() const
{
  const std::lock_guard lock(state_->mutex);
  return state_->opened;
}

std::optional<std::uint64_t> FakeCodec::decode(const RawReport& report,
                                               device::DeviceSample& hand) noexcept
{
  if (report.size != inputSize) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) hand.position_D[i] = get(report, 3 + 2 * i) * 1e-5;
  hand.buttons = report.bytes[9];
  return static_cast<std::uint16_t>(get(report, 1));
}

void FakeCodec::encode(const device::Wrench& wrench_D, device::ReportList& reports) noexcept
{
  reports.count = 1;
  RawReport& report = reports.reports[0];
  report.bytes[0] = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double millinewtons = std::clamp(wrench_D.force_D[i] * 1e3, -32e3, 32e3);
    put(report, 1 + 2 * i, static_cast<std::int16_t>(std::lround(millinewtons)));
  }
  report.size = outputSize;
}

Result<void> FakeCodec::begin(device::Transport& transport)
{
  RawReport on;
  on.bytes[1] = 1;
  on.size = 2;
  if (transport.setFeature(on) != Transfer::done)
    return Error{"The fake device does not turn its actuators on."};
  return {};
}

void FakeCodec::end(device::Transport& transport) noexcept
{
  RawReport off;
  off.size = 2;
  transport.setFeature(off);
}

device::DeviceTraits fakeTraits()
{
  device::DeviceTraits traits;
  traits.name = "Fake hand";
  traits.rendersForce = true;
  traits.maxForce = 3.3;
  traits.nominalPeriod = 1e-3;
  traits.actuatedTranslations = 3;
  return traits;
}

}  // namespace perilymph::test
