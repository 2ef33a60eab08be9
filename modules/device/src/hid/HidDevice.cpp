// SPDX-License-Identifier: BSD-3-Clause
#include "hid/HidDevice.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>
#include <utility>

#include "guard/DeviceGuard.h"
#include "hid/ForceWriter.h"
#include "hid/Intervals.h"
#include "hid/OpeningMeasurement.h"
#include "perilymph/foundation/RealTime.h"
#include "perilymph/realtime/Pacer.h"

namespace perilymph::device {

namespace {

constexpr std::int64_t betweenLooks = 20'000'000;  // of the supervisor [ns]
// A device that accepted no force for this long is blocked, unless its period is longer.
constexpr double blockedTime = 5e-3;  // [s]
// Longer than the writer's own timeout for the haptic thread: the guard is the last resort.
constexpr double patienceOfGuard = 50e-3;  // [s]

/// A device opened twice, because a hidapi handle is used by one thread.
struct Handles {
  std::unique_ptr<Transport> reading;
  std::unique_ptr<Transport> writing;  ///< Null for a device that is never written.
};

}  // namespace

struct HidDevice::Content {
  Content(DeviceTraits profileTraits, std::unique_ptr<DeviceCodec> profileCodec,
          std::unique_ptr<HidPort> devicePort, Clock testClock)
      : clock(testClock != nullptr ? testClock : realtime::monotonicNanoseconds),
        profile(std::move(profileTraits)),
        codec(std::move(profileCodec)),
        port(std::move(devicePort)),
        traits(profile),
        reader(*codec, profile.nominalPeriod, clock)
  {
  }

  bool needsWriter() const noexcept
  {
    return traits.rendersForce || traits.reporting == Reporting::onWrite ||
           traits.reporting == Reporting::polled;
  }
  Result<void> openHandles(Handles& handles);
  void listen(const Handles& handles);
  void lend(Handles handles);
  void supervise();
  bool hasHandlesBack();
  void lose() noexcept;
  void watchWriter(std::int64_t now) noexcept;
  void showFigures(std::int64_t now) noexcept;
  void setError(std::string sentence);

  Clock clock;
  DeviceTraits profile;
  std::unique_ptr<DeviceCodec> codec;
  std::unique_ptr<HidPort> port;
  DeviceTraits traits;  ///< With the values measured on opening.
  bool isOpen = false;
  bool isPeriodMeasured = false;
  double roundTrip = 0.0;  // [s]
  bool isRoundTripMeasured = false;
  std::int64_t staleTime = 0;     // [ns]
  std::int64_t blockedAfter = 0;  // [ns]

  std::unique_ptr<DeviceChannels> channels;
  std::unique_ptr<ForceWriter> writer;
  std::thread writerThread, supervisorThread;

  // Owned by the haptic thread.
  ReportReader reader;
  Transport* reading = nullptr;
  std::int64_t figuresShown = 0;
  std::int64_t listeningSince = 0;  // [ns]
  realtime::TripleBuffer<ReadingFigures> figures;

  // Owned by the supervisor.
  bool isReadingLent = false, isWritingLent = false;
  std::atomic<std::uint64_t> reconnections{0};
  std::atomic<bool> isGuarded{false};
  mutable std::mutex errorMutex;  // between supervisor and UI thread
  std::string error;
  std::string guardObstacle;
};

HidDevice::HidDevice(DeviceTraits traits, std::unique_ptr<DeviceCodec> codec,
                     std::unique_ptr<HidPort> port, Clock clock)
    : content_(
          std::make_unique<Content>(std::move(traits), std::move(codec), std::move(port), clock))
{
}

HidDevice::~HidDevice() { close(); }

DeviceTraits HidDevice::traits() const { return content_->traits; }

Result<void> HidDevice::open()
{
  close();
  Content& content = *content_;
  content.traits = content.profile;
  content.channels = std::make_unique<DeviceChannels>();
  content.reader = ReportReader(*content.codec, content.profile.nominalPeriod, content.clock);
  content.writer = std::make_unique<ForceWriter>(*content.channels, *content.codec, content.traits,
                                                 content.clock);
  content.setError({});
  content.reconnections = 0;
  Handles handles;
  if (const auto done = content.openHandles(handles); !done) return done;
  content.listen(handles);
  content.lend(std::move(handles));

  content.staleTime = nanoseconds(std::clamp(3.0 * content.traits.nominalPeriod, 3e-3, 30e-3));
  content.blockedAfter = std::max(content.staleTime, nanoseconds(blockedTime));
  content.isOpen = true;
  if (content.needsWriter())
    content.writerThread = std::thread([&content] {
      declareThread(ThreadRole::deviceWriter);
      content.writer->run();
    });
  content.supervisorThread = std::thread([&content] {
    declareThread(ThreadRole::deviceSupervisor);
    content.supervise();
  });
  return {};
}

/// Opens and prepares the device, while no other thread uses the codec's writing side.
Result<void> HidDevice::Content::openHandles(Handles& handles)
{
  auto forReading = port->open();
  if (!forReading) return forReading.error();
  handles.reading = *std::move(forReading);
  if (!needsWriter()) return {};

  auto forWriting = port->open();
  if (!forWriting) return forWriting.error();
  handles.writing = *std::move(forWriting);
  const auto begun = codec->begin(*handles.writing);
  if (!begun) codec->end(*handles.writing);
  if (!begun || !traits.rendersForce) return begun;

  // The device works without a guard, too; `perilymph-cli devices` and the recording report it.
  GuardedHandle watched = guarded(std::move(handles.writing), port->fileForGuard(),
                                  codec->shutdownReports(), Duration::fromSi(patienceOfGuard));
  handles.writing = std::move(watched.handle);
  isGuarded = watched.obstacle.empty();
  const std::lock_guard lock(errorMutex);
  guardObstacle = std::move(watched.obstacle);
  return {};
}

void HidDevice::Content::listen(const Handles& handles)
{
  const OpeningMeasurement heard =
      measureOnOpening(*handles.reading, handles.writing.get(), profile, *writer, clock);
  isPeriodMeasured = heard.period > 0.0;
  if (isPeriodMeasured) traits.nominalPeriod = heard.period;
  // Without answers the delay of a report is assumed equal to that of a write.
  isRoundTripMeasured = heard.answerTime > 0.0;
  const double way = isRoundTripMeasured ? heard.answerTime : 2.0 * heard.writeTime;
  traits.transportDelay = std::max(profile.transportDelay, way);
  const double longest = std::max(heard.writeTime, profile.transportDelay) + traits.nominalPeriod;
  roundTrip = !needsWriter() ? 0.0 : isRoundTripMeasured ? heard.answerTime : longest;
  reader = ReportReader(*codec, traits.nominalPeriod, clock);
}

void HidDevice::Content::lend(Handles handles)
{
  isReadingLent = true;
  isWritingLent = handles.writing != nullptr;
  channels->isBlocked = false;
  channels->isGone = false;
  channels->reading.offer(std::move(handles.reading));
  if (isWritingLent) channels->writing.offer(std::move(handles.writing));
  channels->writerBell.ring();
}

void HidDevice::close() noexcept
{
  Content& content = *content_;
  if (!content.isOpen) return;
  content.isOpen = false;
  content.channels->isStopping = true;
  content.channels->writerBell.ring();
  content.channels->supervisorBell.ring();
  if (content.supervisorThread.joinable()) content.supervisorThread.join();
  if (content.writerThread.joinable()) content.writerThread.join();
  delete std::exchange(content.reading, nullptr);
  content.writer.reset();
  content.channels.reset();
  content.traits = content.profile;
}

DeviceSample HidDevice::read() noexcept
{
  Content& content = *content_;
  DeviceSample sample = content.reader.newest();
  sample.isValid = 0;
  if (!content.isOpen) return sample;

  DeviceChannels& channels = *content.channels;
  if (channels.isGone && content.reading != nullptr) {
    channels.reading.giveBack(std::exchange(content.reading, nullptr));
    channels.supervisorBell.ring();
  }
  if (content.reading == nullptr) {
    content.reading = channels.reading.take();
    content.reader.reset();
    content.listeningSince = content.clock();
  }
  if (content.reading == nullptr) return sample;

  const std::int64_t now = content.clock();
  const bool isPolled = content.traits.reporting == Reporting::polled;
  if (isPolled && channels.polled.refresh()) content.reader.accept(channels.polled.latest());
  if (content.reader.drain(*content.reading) == Transfer::gone) content.lose();
  content.watchWriter(now);
  content.showFigures(now);

  if (content.traits.reporting == Reporting::onChange) content.reader.repeat();
  sample = content.reader.newest();
  sample.isValid = channels.isGone || channels.isBlocked ? 0 : 1;
  return sample;
}

void HidDevice::write(const Wrench& wrench_D) noexcept
{
  Content& content = *content_;
  if (!content.isOpen || !content.needsWriter()) return;
  DeviceChannels& channels = *content.channels;
  const std::int64_t heard = content.reader.lastFresh();
  const bool isStale = heard == 0 || content.clock() - heard >= content.staleTime;
  const bool isOff = isStale || channels.isGone || channels.isBlocked || content.reading == nullptr;
  channels.wrenches.publish(isOff || !content.traits.rendersForce ? Wrench{} : wrench_D);
  channels.writerBell.ring();
}

Awaited HidDevice::await(Duration timeout) noexcept
{
  Content& content = *content_;
  const bool isPeriodic = content.traits.reporting == Reporting::periodic;
  if (!content.isOpen || !isPeriodic || content.reading == nullptr || content.channels->isGone)
    return Awaited::cannot;
  const Transfer transfer = content.reader.await(*content.reading, timeout);
  if (transfer == Transfer::gone) content.lose();
  if (transfer == Transfer::gone || transfer == Transfer::failed) return Awaited::cannot;
  return transfer == Transfer::done ? Awaited::fresh : Awaited::nothing;
}

void HidDevice::Content::lose() noexcept
{
  if (channels->isGone.exchange(true)) return;
  channels->writerBell.ring();
  channels->supervisorBell.ring();
}

void HidDevice::Content::watchWriter(std::int64_t now) noexcept
{
  const std::int64_t since = channels->busySince;
  if (since == 0 || now - since < blockedAfter) return;
  if (!channels->isBlocked.exchange(true)) ++channels->blockedWrites;
}

void HidDevice::Content::showFigures(std::int64_t now) noexcept
{
  if (now - figuresShown < statisticsInterval) return;
  figuresShown = now;
  ReadingFigures& shown = figures.draft();
  shown = reader.figures();
  const std::int64_t heard = reader.lastFresh();
  shown.silence = static_cast<double>(now - (heard == 0 ? listeningSince : heard)) * 1e-9;
  figures.publishDraft();
}

void HidDevice::Content::supervise()
{
  while (!channels->isStopping) {
    channels->supervisorBell.waitUntil(realtime::monotonicNanoseconds() + betweenLooks);
    if (!channels->isGone || channels->isStopping) continue;
    if (!hasHandlesBack()) continue;
    Handles handles;
    const auto done = openHandles(handles);
    if (done) {
      ++reconnections;
      setError({});
      lend(std::move(handles));
      continue;
    }
    setError(done.error().message +
             " The force is off. Plug it in again; it is taken up by "
             "itself.");
    port->awaitChange(Duration::fromSi(0.05));
  }
}

/// Takes back the lent handles once they are released, and closes them.
bool HidDevice::Content::hasHandlesBack()
{
  const bool hasReading = channels->reading.withdraw() || channels->reading.reclaim();
  const bool hasWriting = channels->writing.withdraw() || channels->writing.reclaim();
  if (hasReading) isReadingLent = false;
  if (hasWriting) isWritingLent = false;
  return !isReadingLent && !isWritingLent;
}

void HidDevice::Content::setError(std::string sentence)
{
  const std::lock_guard lock(errorMutex);
  error = std::move(sentence);
}

std::optional<DeviceHealth> HidDevice::health()
{
  Content& content = *content_;
  if (!content.isOpen) return std::nullopt;
  DeviceHealth health;
  health.isConnected = !content.channels->isGone;
  health.isBlocked = content.channels->isBlocked;
  content.figures.refresh();
  health.reading = content.figures.latest();
  health.writing = content.writer->latestFigures();
  health.period = content.traits.nominalPeriod;
  health.isPeriodMeasured = content.isPeriodMeasured;
  health.delay = content.traits.transportDelay;
  health.roundTrip = content.roundTrip;
  health.isRoundTripMeasured = content.isRoundTripMeasured;
  health.reconnections = content.reconnections;
  health.blockedWrites = content.channels->blockedWrites;
  health.isGuarded = content.isGuarded;
  const std::lock_guard lock(content.errorMutex);
  health.guardObstacle = content.guardObstacle;
  health.error = content.error;
  if (health.isConnected && health.reading.silence > 0.1)
    health.error = content.profile.name +
                   (health.reading.fresh == 0 ? " has sent no report since it was opened, "
                                              : " has sent nothing for ") +
                   std::to_string(health.reading.silence).substr(0, 4) + " s" +
                   (health.reading.fresh == 0 ? " ago" : "") +
                   ". The force is off. Move it, then check its cable.";
  if (health.isBlocked)
    health.error = content.profile.name + " takes no force. The force is off. Check its cable.";
  return health;
}

}  // namespace perilymph::device
