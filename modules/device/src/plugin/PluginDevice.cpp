// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/device/PluginDevice.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>

#include "hid/Intervals.h"
#include "perilymph/realtime/Pacer.h"
#include "perilymph/realtime/TimeHistogram.h"
#include "perilymph/realtime/TripleBuffer.h"
#include "plugin/LoadingPlugin.h"
#include "plugin/PluginFile.h"
#include "plugin/PluginProcess.h"
#include "plugin/StatedTraits.h"

namespace perilymph::device {

namespace {

namespace fs = std::filesystem;
using plugin::Channel;
using plugin::PluginProcess;

// A host that publishes nothing for this long is stopped as a whole, else its own watch had ended
// it. Also counted in reads, so that a program that was stopped itself does not kill a host.
constexpr double frozenTime = 0.5;  // [s]
constexpr int frozenReads = 50;
// The delay through the host is the median of this many exchanges.
constexpr int exchanges = 32;
constexpr std::int64_t patienceForExchange = 20'000'000;  // [ns]

Error refused(const fs::path& library, const Sentence& why)
{
  return Error{"The plug-in %1 is not taken: %2", library, why};
}

/// Counters of the samples of a plug-in, for its health. Haptic thread.
class SampleFigures {
public:
  void noteFresh(std::int64_t now) noexcept
  {
    if (last_ != 0) all_.add(now - last_);
    if (last_ != 0) second_.add(now - last_);
    last_ = now;
    ++figures_.fresh;
    if (began_ == 0) began_ = secondBegan_ = now;
  }
  /// The counters, with the rate of the last full second.
  const ReadingFigures& figures(std::int64_t now, std::uint64_t faulty) noexcept
  {
    figures_.foreign = faulty;
    figures_.silence = last_ == 0 ? 0.0 : static_cast<double>(now - last_) * 1e-9;
    if (began_ == 0 || now - secondBegan_ < 1'000'000'000) return figures_;
    figures_.rate = static_cast<double>(second_.count()) / seconds(now - secondBegan_);
    figures_.intervalMedian = second_.quantile(0.5);
    figures_.intervalP99 = second_.quantile(0.99);
    figures_.intervalMax = second_.longest();
    second_.clear();
    secondBegan_ = now;
    figures_.overall = {static_cast<double>(all_.count()) / seconds(now - began_),
                        all_.quantile(0.5), all_.quantile(0.99), all_.longest()};
    return figures_;
  }

private:
  static double seconds(std::int64_t time) noexcept { return static_cast<double>(time) * 1e-9; }

  realtime::TimeHistogram second_, all_;
  std::int64_t began_ = 0, secondBegan_ = 0, last_ = 0;  // [ns]
  ReadingFigures figures_;
};

/// A plug-in's device, which runs in a process of its own.
class PluginDevice final : public HapticDevice {
public:
  PluginDevice(fs::path library, std::unique_ptr<PluginProcess> process, DeviceTraits traits,
               std::stop_token stop)
      : library_(std::move(library)),
        process_(std::move(process)),
        stop_(std::move(stop)),
        stated_(std::move(traits)),
        traits_(stated_),
        staleTime_(nanoseconds(std::clamp(3.0 * stated_.nominalPeriod, 3e-3, 30e-3)))
  {
  }
  ~PluginDevice() override { close(); }
  PluginDevice(const PluginDevice&) = delete;
  PluginDevice& operator=(const PluginDevice&) = delete;

  DeviceTraits traits() const override { return traits_; }
  Result<void> open() override;
  void close() noexcept override;
  DeviceSample read() noexcept override;
  void write(const Wrench& wrench_D) noexcept override;
  Awaited await(Duration timeout) noexcept override;
  std::optional<DeviceHealth> health() override;

private:
  void measureDelay() noexcept;
  bool absorb(std::int64_t now) noexcept;
  void lookAfterHost(std::int64_t now) noexcept;

  fs::path library_;
  std::unique_ptr<PluginProcess> process_;
  std::stop_token stop_;
  DeviceTraits stated_;
  DeviceTraits traits_;     // with the delay measured on opening
  std::int64_t staleTime_;  // [ns]
  bool isOpen_ = false;
  std::atomic<bool> isLost_{false};

  // Owned by the haptic thread while it runs.
  plugin::HostedSample newest_;
  std::uint64_t seen_ = 0;
  std::uint64_t forces_ = 0;
  std::int64_t heard_ = 0, fresh_ = 0;  // [ns]
  std::int64_t shown_ = 0;              // [ns]
  int silentReads_ = 0;
  SampleFigures counted_;
  realtime::TripleBuffer<ReadingFigures> figures_;
};

Result<void> PluginDevice::open()
{
  if (isOpen_ && !isLost_) return {};
  close();
  if (process_->hasEnded()) {
    // Not one that was changed since.
    auto started = plugin::beginToLoad(library_);
    if (!started) return started.error();
    if (const auto loaded = started->process->load(patienceForLoading, stop_); !loaded)
      return refused(library_, loaded.error().message);
    process_ = std::move(started->process);
  }
  if (const auto opened = process_->open(patienceForLoading, stop_); !opened) {
    if (!opened.error().message.empty()) return opened;
    return Error{"The %1 cannot be opened, and its plug-in does not say why.", stated_.name};
  }
  newest_ = {};
  seen_ = 0;
  silentReads_ = 0;
  heard_ = realtime::monotonicNanoseconds();
  fresh_ = shown_ = 0;
  counted_ = {};
  figures_.publish({});
  isLost_ = false;
  isOpen_ = true;
  measureDelay();
  return {};
}

/// Measures the time from a force to the answer of the host, which includes the plug-in's write.
void PluginDevice::measureDelay() noexcept
{
  Channel& channel = process_->channel();
  realtime::TimeHistogram times;
  for (int i = 0; i < exchanges; ++i) {
    const std::int64_t began = realtime::monotonicNanoseconds();
    channel.forces.publish({++forces_, {}, {}, 1});
    channel.forHost.ring();
    bool isRung = true;
    while (isRung && newest_.written < forces_) {
      isRung = channel.forProgram.waitUntil(began + patienceForExchange);
      absorb(realtime::monotonicNanoseconds());
    }
    if (newest_.written >= forces_) times.add(realtime::monotonicNanoseconds() - began);
  }
  traits_ = stated_;
  traits_.transportDelay += times.quantile(0.5);
}

void PluginDevice::close() noexcept
{
  if (!isOpen_) return;
  isOpen_ = false;
  if (!process_->hasEnded()) process_->close();
  traits_ = stated_;
}

/// Takes the newest sample of the host. True if it is fresh.
bool PluginDevice::absorb(std::int64_t now) noexcept
{
  const std::uint64_t before = newest_.sample.sequence;
  if (!process_->channel().samples.take(newest_, seen_)) return false;
  heard_ = now;
  silentReads_ = 0;
  const bool isFirst = fresh_ == 0 && newest_.sample.isValid != 0;
  if (newest_.sample.sequence == before && !isFirst) return false;
  fresh_ = now;
  counted_.noteFresh(now);
  return true;
}

DeviceSample PluginDevice::read() noexcept
{
  if (!isOpen_) return {};
  const std::int64_t now = realtime::monotonicNanoseconds();
  absorb(now);
  if (now - heard_ >= staleTime_) lookAfterHost(now);
  if (now - shown_ >= statisticsInterval) {
    shown_ = now;
    figures_.publish(counted_.figures(now, newest_.faulty));
  }
  DeviceSample sample = newest_.sample;
  if (isLost_) sample.isValid = 0;
  return sample;
}

/// The host is silent: it ended, hangs, or is late.
void PluginDevice::lookAfterHost(std::int64_t now) noexcept
{
  if (isLost_) return;
  ++silentReads_;
  const bool isFrozen = silentReads_ >= frozenReads && now - heard_ >= nanoseconds(frozenTime);
  if (isFrozen) process_->kill();
  if (!isFrozen && !process_->hasEnded()) return;
  process_->killGroup();
  isLost_ = true;
}

void PluginDevice::write(const Wrench& wrench_D) noexcept
{
  if (!isOpen_ || isLost_) return;
  const bool isStale = realtime::monotonicNanoseconds() - fresh_ >= staleTime_;
  plugin::Force force{++forces_, {}, {}, 0};
  if (!isStale && stated_.rendersForce) force.force_D = wrench_D.force_D;
  if (!isStale && stated_.maxTorque > 0.0) force.torque_D = wrench_D.torque_D;
  process_->channel().forces.publish(force);
  process_->channel().forHost.ring();
}

Awaited PluginDevice::await(Duration timeout) noexcept
{
  if (!isOpen_ || isLost_) return Awaited::cannot;
  const std::int64_t end = realtime::monotonicNanoseconds() + nanoseconds(timeout.si());
  while (!absorb(realtime::monotonicNanoseconds()))
    if (!process_->channel().forProgram.waitUntil(end)) return Awaited::nothing;
  return Awaited::fresh;
}

std::optional<DeviceHealth> PluginDevice::health()
{
  if (!isOpen_) return std::nullopt;
  DeviceHealth health;
  health.isConnected = !isLost_;
  health.isGuarded = true;
  figures_.refresh();
  health.reading = figures_.latest();
  health.period = stated_.nominalPeriod;
  health.delay = traits_.transportDelay;
  health.roundTrip = traits_.rendersForce ? traits_.transportDelay + stated_.nominalPeriod : 0.0;
  constexpr double noticed = 0.1;  // [s]
  const bool isSilent = health.reading.silence > noticed;
  if (isLost_)
    health.error = process_->obituary();
  else if (isSilent && health.reading.foreign > 0)
    health.error = stated_.name +
                   " sends values that are not numbers. The force is off. Reset it; if that "
                   "recurs, tell the maker of its plug-in.";
  else if (isSilent)
    health.error = stated_.name + " has sent nothing for " +
                   std::to_string(health.reading.silence).substr(0, 4) +
                   " s. The force is off. Move it, then check its cable.";
  return health;
}

}  // namespace

Result<plugin::LoadingPlugin> plugin::beginToLoad(const fs::path& file)
{
  // An absolute path: a bare name would be searched in the system's library folders.
  auto library = checkedFile(file);
  if (!library) return refused(file, library.error().message);
  auto process = PluginProcess::start(*library);
  if (!process) return refused(file, process.error().message);
  return LoadingPlugin{file, *std::move(process)};
}

Result<std::unique_ptr<HapticDevice>> plugin::awaitDevice(LoadingPlugin loading, Duration patience,
                                                          const std::stop_token& stop)
{
  if (const auto loaded = loading.process->load(patience, stop); !loaded)
    return refused(loading.file, loaded.error().message);
  Result<DeviceTraits> traits = checkedTraits(loading.process->traits());
  if (!traits) return refused(loading.file, traits.error().message);
  return std::unique_ptr<HapticDevice>(std::make_unique<PluginDevice>(
      std::move(loading.file), std::move(loading.process), *std::move(traits), stop));
}

Result<std::unique_ptr<HapticDevice>> loadPluginDevice(const fs::path& file, Duration patience,
                                                       const std::stop_token& stop)
{
  auto loading = plugin::beginToLoad(file);
  if (!loading) return loading.error();
  return plugin::awaitDevice(*std::move(loading), patience, stop);
}

}  // namespace perilymph::device
