// SPDX-License-Identifier: BSD-3-Clause

// Prints the measures of one scene's logs: hid_measures SCENE HANDLE.log LOOP.log

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>

#include "FlatWallScene.h"
#include "HandleReports.h"
#include "StackMeasures.h"
#include "StopWays.h"

namespace {

using namespace perilymph;
using namespace perilymph::hidstack;

/// "measure contact.penetration_mm 0.4535"
void print(const std::string& scene, const std::string& name, double value)
{
  std::cout << "measure " << scene << '.' << name << ' ' << std::setprecision(9) << value << '\n';
}

void printSpread(const std::string& scene, const std::string& name, const Spread& spread)
{
  print(scene, name + "_p50_us", spread.median * 1e6);
  print(scene, name + "_p99_us", spread.p99 * 1e6);
  print(scene, name + "_p999_us", spread.p999 * 1e6);
  print(scene, name + "_max_us", spread.maximum * 1e6);
}

Result<void> measureStream(const std::string& scene, const std::string& log)
{
  const auto rows = readReportLog(log);
  if (!rows) return rows.error();
  const StreamMeasure stream = streamIn(*rows);
  print(scene, "reports", static_cast<double>(stream.reports));
  print(scene, "lost", static_cast<double>(stream.lost));
  print(scene, "repeated", static_cast<double>(stream.repeated));
  print(scene, "rate_Hz", stream.rate);
  return {};
}

void printRest(const std::string& scene, const std::string& passage,
               const std::vector<HandleTick>& handle)
{
  const auto rest = restIn(handle, passage);
  if (!rest) return;
  print(scene, passage + "_penetration_mm", (rest->mean - freeWay) * 1e3);
  print(scene, passage + "_swing_mm", rest->swing * 1e3);
}

void printSilence(const std::string& scene, const std::string& passage,
                  const std::vector<HandleTick>& handle, const std::vector<LoopTick>& loop)
{
  const SilenceMeasure silence = silenceIn(handle, loop, passage, forceQuantum);
  print(scene, passage + "_force_before_N", silence.before);
  if (silence.written) print(scene, passage + "_zero_written_ms", *silence.written * 1e3);
  if (silence.heard) print(scene, passage + "_zero_heard_ms", *silence.heard * 1e3);
}

Result<void> measureInsertion(const std::string& scene, const std::string& handleLog,
                              const std::string& loopLog)
{
  const auto handle = readHandleLog(handleLog);
  if (!handle) return handle.error();
  const auto loop = readLoopLog(loopLog);
  if (!loop) return loop.error();
  const AnswerMeasure answers = answersIn(*handle, *loop, {"grasp", "slide", "rest"}, forceQuantum);
  print(scene, "ticks", static_cast<double>(answers.ticks));
  print(scene, "answered", static_cast<double>(answers.answered));
  print(scene, "caused", static_cast<double>(answers.caused));
  printSpread(scene, "tick_to_force", answers.fromTick);
  printSpread(scene, "report_to_force", answers.fromReport);
  printSpread(scene, "engine", answers.engine);
  printSpread(scene, "besides_engine", answers.besides);
  printRest(scene, "rest", *handle);
  printRest(scene, "rest_again", *handle);
  for (const char* passage : {"silence", "unplugged", "pause"})
    if (restIn(*handle, passage)) printSilence(scene, passage, *handle, *loop);
  return {};
}

/// Time from the last force of a killed host to the first zero force.
Result<void> measureDeath(const std::string& scene, const std::string& handleLog)
{
  const auto handle = readHandleLog(handleLog);
  if (!handle) return handle.error();
  std::int64_t lastForce = 0, zero = 0;  // [ns]; 0: none came
  double force = 0.0;
  for (const HandleTick& tick : *handle) {
    if (tick.outputs == 0) continue;
    if (tick.force != 0) {
      lastForce = tick.answered;
      force = static_cast<double>(std::abs(tick.force)) * forceQuantum;
      zero = 0;
    } else if (lastForce != 0 && zero == 0) {
      zero = tick.answered;
    }
  }
  print(scene, "force_before_N", force);
  if (zero != 0) print(scene, "zero_heard_ms", static_cast<double>(zero - lastForce) * 1e-6);
  return {};
}

/// The force around each stop.
Result<void> measureStops(const std::string& scene, const std::string& handleLog,
                          const std::string& stopLog)
{
  const auto handle = readHandleLog(handleLog);
  if (!handle) return handle.error();
  const auto stops = readReportLog(stopLog);
  if (!stops) return stops.error();
  constexpr std::int64_t allowed = 5'000'000;  // [ns]
  for (const ReportRow& stop : *stops) {
    const std::string way = stopWays.at(static_cast<std::size_t>(stop.sequence));
    double before = 0.0, after = 0.0;  // [N]
    std::int64_t zero = 0;             // [ns]; 0: none came, or not for good
    for (const HandleTick& tick : *handle) {
      if (tick.outputs == 0 || tick.passage != way) continue;
      const double force = static_cast<double>(std::abs(tick.force)) * forceQuantum;
      if (tick.answered < stop.read) before = force;
      if (tick.answered <= stop.read + allowed) after = force;
      if (tick.answered < stop.read) continue;
      if (tick.force != 0) zero = 0;
      if (tick.force == 0 && zero == 0) zero = tick.answered;
    }
    print(scene, way + "_force_before_N", before);
    print(scene, way + "_force_after_5ms_N", after);
    if (zero != 0)
      print(scene, way + "_zero_heard_ms", static_cast<double>(zero - stop.read) * 1e-6);
  }
  return {};
}

}  // namespace

int main(int count, char** text)
{
  if (count != 4) {
    std::cerr << "hid_measures needs the name of a scene and two logs.\n";
    return 2;
  }
  const std::string scene = text[1];
  const bool isStream = scene == "stream" || scene == "lost" || scene == "repeated";
  const auto done = scene == "killed"  ? measureDeath(scene, text[2])
                    : scene == "stops" ? measureStops(scene, text[2], text[3])
                    : isStream         ? measureStream(scene, text[3])
                                       : measureInsertion(scene, text[2], text[3]);
  if (done) return 0;
  std::cerr << done.error().message << '\n';
  return 1;
}
