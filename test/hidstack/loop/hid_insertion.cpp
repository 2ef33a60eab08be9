// The host's side of the wire:
//   hid_insertion stream PROFILE LOG REPORTS   takes so many reports
//   hid_insertion insert PROFILE LOG UNPLUGS   inserts until the device was unplugged so many
//   times;
//                                              the log's name is the scene's

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include "TickLog.h"
#include "insertion.h"
#include "perilymph/device/HidTransport.h"
#include "perilymph/realtime/Pacer.h"
#include "virtualDevice.h"

namespace {

using namespace perilymph;
using namespace perilymph::hidstack;

constexpr double patience = 5.0;  // for the device to be plugged in [s]

/// Every report through the transport and the codec, one by one.
Result<Done> takeStream(const std::string& profile, const std::string& log, std::size_t wanted)
{
  const auto found = findVirtualDevice(profile, patience);
  if (!found) return found.error();
  const auto transport = device::openHidTransport(found->node.path, device::ReportNumbers::inFront);
  if (!transport) return transport.error();

  std::vector<ReportRow> rows;
  rows.reserve(wanted);
  device::RawReport report;
  device::DeviceSample sample;
  while (rows.size() < wanted &&
         (*transport)->read(report, milliseconds(100)) == device::Transfer::done) {
    const std::int64_t now = realtime::monotonicNanoseconds();
    if (const auto counter = found->codec->decode(report, sample))
      rows.push_back({now, static_cast<std::int64_t>(*counter)});
  }
  return write(log, rows);
}

/// What the hand says of itself.
void print(const std::string& scene, const device::HandHealth& health)
{
  const auto measure = [&scene](const char* name, auto value) {
    std::cout << "measure " << scene << ".hand_" << name << ' ' << value << '\n';
  };
  measure("lost", health.reading.lost);
  measure("repeated", health.reading.duplicates);
  measure("old", health.reading.old);
  measure("period_ms", health.period * 1e3);
  measure("delay_ms", health.delay * 1e3);
  measure("reconnections", health.reconnections);
  measure("blocked_writes", health.blockedWrites);
}

Result<Done> insert(const std::string& profile, const std::filesystem::path& log, int unplugs)
{
  const auto hand = virtualHand(profile, patience);
  if (!hand) return hand.error();
  if (const auto opened = (*hand)->open(); !opened) return opened;
  const auto ticks = insertUntilUnplugged(**hand, unplugs);
  if (const auto health = (*hand)->health()) print(log.stem(), *health);
  if (!ticks) return ticks.error();
  return write(log, *ticks);
}

Result<Done> run(const std::string& what, const std::string& profile, const std::string& log,
                 int number)
{
  if (what == "stream" && number > 0)
    return takeStream(profile, log, static_cast<std::size_t>(number));
  if (what == "insert" && number > 0) return insert(profile, log, number);
  return Error{"hid_insertion knows stream and insert with a number above 0; '" + what + "' with " +
               std::to_string(number) + " was given."};
}

}  // namespace

int main(int count, char** words)
{
  if (count != 5) {
    std::cerr << "hid_insertion needs what to do, a profile, a file for its log and a number.\n";
    return 2;
  }
  if (const auto done = run(words[1], words[2], words[3], std::atoi(words[4])); !done) {
    std::cerr << done.error().message << '\n';
    return 1;
  }
  return 0;
}
