// SPDX-License-Identifier: BSD-3-Clause

//The host side of the connection:
//  hid_insertion stream PROFILE LOG REPORTS   reads a number of reports
//  hid_insertion insert PROFILE LOG UNPLUGS   inserts until the device was disconnected that often
//  hid_insertion die PROFILE LOG TICKS        the same, but kills itself after a number of ticks
//  hid_insertion push PROFILE LOG TICKS       pushes to the right with a third of the maximum force
//  hid_insertion refused PROFILE LOG 1        expects that the device cannot be opened
// The log has the name of the scene.

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include "TickLog.h"
#include "hid/HidTransport.h"
#include "insertion.h"
#include "perilymph/realtime/Pacer.h"
#include "virtualDevice.h"

namespace {

using namespace perilymph;
using namespace perilymph::hidstack;

constexpr double patience = 5.0;  // until the device is connected [s]

/// Reads every report through transport and codec, one by one.
Result<void> takeStream(const std::string& profile, const std::string& log, std::size_t wanted)
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

/// Prints the health of the device.
void print(const std::string& scene, const device::DeviceHealth& health)
{
  const auto measure = [&scene](const char* name, auto value) {
    std::cout << "measure " << scene << ".hand_" << name << ' ' << value << '\n';
  };
  measure("lost", health.reading.lost);
  measure("repeated", health.reading.duplicates);
  measure("old", health.reading.old);
  measure("period_ms", health.period * 1e3);
  measure("delay_ms", health.delay * 1e3);
  measure("round_trip_ms", health.roundTrip * 1e3);
  measure("round_trip_measured", health.isRoundTripMeasured ? 1 : 0);
  measure("guarded", health.isGuarded ? 1 : 0);
  measure("writer_real_time", health.writing.hasRealTimePriority ? 1 : 0);
  measure("reconnections", health.reconnections);
  measure("blocked_writes", health.blockedWrites);
}

Result<void> insert(const std::string& profile, const std::filesystem::path& log, int unplugs)
{
  const auto hand = openVirtualDevice(profile, patience);
  if (!hand) return hand.error();
  if (const auto opened = (*hand)->open(); !opened) return opened;
  const auto ticks = insertUntilUnplugged(**hand, unplugs);
  if (const auto health = (*hand)->health()) print(log.stem(), *health);
  if (!ticks) return ticks.error();
  return write(log, *ticks);
}

/// Like `insert`, until this process is killed.
Result<void> die(const std::string& profile, int ticks)
{
  const auto hand = openVirtualDevice(profile, patience);
  if (!hand) return hand.error();
  if (const auto opened = (*hand)->open(); !opened) return opened;
  return insertUntilKilled(**hand, static_cast<std::size_t>(ticks));
}

/// Without an engine: what a codec sends to a device, from opening to closing.
Result<void> push(const std::string& profile, const std::filesystem::path& log, int ticks)
{
  const auto hand = openVirtualDevice(profile, patience);
  if (!hand) return hand.error();
  if (const auto opened = (*hand)->open(); !opened) return opened;
  const double force = (*hand)->traits().maxForce / 3.0;
  for (int i = 0; i < ticks; ++i) {
    (*hand)->await(milliseconds(10));
    (*hand)->read();
    (*hand)->write({{force, 0.0, 0.0}, {}});
  }
  if (const auto health = (*hand)->health()) print(log.stem(), *health);
  (*hand)->close();
  return {};
}

Result<void> beRefused(const std::string& profile, const std::filesystem::path& log)
{
  const auto hand = openVirtualDevice(profile, patience);
  if (!hand) return hand.error();
  const std::int64_t began = realtime::monotonicNanoseconds();
  if ((*hand)->open()) return Error{"The device was opened, though it answers nothing."};
  const std::int64_t took = realtime::monotonicNanoseconds() - began;
  std::cout << "measure " << log.stem().string() << ".opening_s "
            << static_cast<double>(took) * 1e-9 << '\n';
  return {};
}

Result<void> run(const std::string& what, const std::string& profile, const std::string& log,
                 int number)
{
  if (what == "stream" && number > 0)
    return takeStream(profile, log, static_cast<std::size_t>(number));
  if (what == "insert" && number > 0) return insert(profile, log, number);
  if (what == "die" && number > 0) return die(profile, number);
  if (what == "push" && number > 0) return push(profile, log, number);
  if (what == "refused") return beRefused(profile, log);
  return Error{
      "hid_insertion knows stream, insert, die, push and refused with a number above 0; '" + what +
      "' with " + std::to_string(number) + " was given."};
}

}  // namespace

int main(int count, char** text)
{
  if (count != 5) {
    std::cerr << "hid_insertion needs what to do, a profile, a file for its log and a number.\n";
    return 2;
  }
  if (const auto done = run(text[1], text[2], text[3], std::atoi(text[4])); !done) {
    std::cerr << done.error().message << '\n';
    return 1;
  }
  return 0;
}
