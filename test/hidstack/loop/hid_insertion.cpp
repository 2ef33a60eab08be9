// The host's side of the wire:
//   hid_insertion stream LOG REPORTS   takes so many reports
//   hid_insertion device LOG           inserts at the device's own beat, until it is unplugged
//   hid_insertion clock LOG UNPLUGS    inserts on the loop's own thread, through so many unplugs

#include <cstdlib>
#include <iostream>
#include <string>

#include "DirectHand.h"
#include "ReportBell.h"
#include "TickLog.h"
#include "insertions.h"
#include "perilymph/realtime/Pacer.h"

namespace {

using namespace perilymph;
using namespace perilymph::hidstack;

constexpr int patience_ms = 2000;
const std::string node = "/dev/hidraw0";

Result<Done> takeStream(const std::string& log, std::size_t wanted)
{
  DirectHand hand(node);
  if (const auto opened = hand.open(); !opened) return opened;
  ReportBell bell;
  if (const auto opened = bell.open(node); !opened) return opened;
  std::vector<ReportRow> rows;
  while (rows.size() < wanted && bell.wait(patience_ms) == ReportBell::Ring::report)
    while (const auto report = hand.take())
      rows.push_back({realtime::monotonicNanoseconds(), report->sequence});
  return write(log, rows);
}

Result<Done> insert(const std::string& how, const std::string& log, int unplugs)
{
  DirectHand hand(node);
  if (const auto opened = hand.open(); !opened) return opened;
  const auto ticks =
      how == "clock" ? insertByTheClock(hand, unplugs) : insertAtDevicesBeat(hand, node);
  if (!ticks) return ticks.error();
  return write(log, *ticks);
}

Result<Done> run(const std::string& what, const std::string& log, int number)
{
  if (what == "stream" && number > 0) return takeStream(log, static_cast<std::size_t>(number));
  if (what == "device" || (what == "clock" && number > 0)) return insert(what, log, number);
  return Error{"hid_insertion knows stream LOG REPORTS, device LOG and clock LOG UNPLUGS; '" +
               what + "' with " + std::to_string(number) + " was given."};
}

}  // namespace

int main(int count, char** words)
{
  if (count < 3 || count > 4) {
    std::cerr
        << "hid_insertion needs what to do, a file for its log and, but for device, a number.\n";
    return 2;
  }
  const int number = count == 4 ? std::atoi(words[3]) : 0;
  if (const auto done = run(words[1], words[2], number); !done) {
    std::cerr << done.error().message << '\n';
    return 1;
  }
  return 0;
}
