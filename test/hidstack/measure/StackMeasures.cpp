// SPDX-License-Identifier: BSD-3-Clause
#include "StackMeasures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace perilymph::hidstack {

namespace {

double seconds(std::int64_t nanoseconds) { return static_cast<double>(nanoseconds) * 1e-9; }

/// The first loop tick that read after `time`.
std::vector<LoopTick>::const_iterator firstReadAfter(const std::vector<LoopTick>& loop,
                                                     std::int64_t time)
{
  return std::upper_bound(loop.begin(), loop.end(), time,
                          [](std::int64_t t, const LoopTick& tick) { return t < tick.read; });
}

std::vector<HandleTick>::const_iterator firstOf(const std::vector<HandleTick>& handle,
                                                const std::string& passage)
{
  return std::find_if(handle.begin(), handle.end(),
                      [&](const HandleTick& tick) { return tick.passage == passage; });
}

}  // namespace

StreamMeasure streamIn(const std::vector<ReportRow>& rows)
{
  StreamMeasure stream;
  stream.reports = static_cast<std::int64_t>(rows.size());
  if (rows.size() < 2) return stream;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    // Difference to the previous one, modulo 2^16, as a signed number.
    const auto ahead = static_cast<std::int16_t>(
        static_cast<std::uint16_t>(rows[i].sequence - rows[i - 1].sequence));
    if (ahead <= 0) ++stream.repeated;
    if (ahead > 1) stream.lost += ahead - 1;
  }
  const std::int64_t fresh = stream.reports - 1 - stream.repeated;
  stream.rate = static_cast<double>(fresh) / seconds(rows.back().read - rows.front().read);
  return stream;
}

Spread spreadOf(std::vector<double> values)
{
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&values](double fraction) {
    const double rank = std::ceil(fraction * static_cast<double>(values.size()));
    return values[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
  };
  return {at(0.5), at(0.99), at(0.999), values.back()};
}

AnswerMeasure answersIn(const std::vector<HandleTick>& handle, const std::vector<LoopTick>& loop,
                        const std::vector<std::string>& passages, double quantum)
{
  AnswerMeasure measure;
  std::vector<double> fromTick, fromReport, engine, besides;
  for (std::size_t i = 1; i + 1 < handle.size(); ++i) {
    const HandleTick& tick = handle[i];
    const bool isRequested =
        std::find(passages.begin(), passages.end(), tick.passage) != passages.end();
    if (!isRequested || tick.sent == 0 || handle[i - 1].passage != tick.passage) continue;
    ++measure.ticks;
    if (tick.answered == 0 || tick.outputs != 1) continue;
    ++measure.answered;
    fromTick.push_back(seconds(tick.answered - tick.due));
    fromReport.push_back(seconds(tick.answered - tick.sent));

    // Causality: the loop read after the report and wrote before the answer, and the written force
    // was received.
    const auto cause = firstReadAfter(loop, tick.sent);
    if (cause == loop.end() || cause->written >= tick.answered) continue;
    const bool isSame = std::abs(cause->force / quantum - static_cast<double>(tick.force)) <= 1.0;
    if (!isSame) continue;
    ++measure.caused;
    const std::int64_t computing = cause->written - cause->read;
    engine.push_back(seconds(computing));
    besides.push_back(seconds(tick.answered - tick.due - computing));
  }
  measure.fromTick = spreadOf(std::move(fromTick));
  measure.fromReport = spreadOf(std::move(fromReport));
  measure.engine = spreadOf(std::move(engine));
  measure.besides = spreadOf(std::move(besides));
  return measure;
}

std::optional<RestMeasure> restIn(const std::vector<HandleTick>& handle, const std::string& passage)
{
  double sum = 0.0;
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -minimum;
  std::int64_t count = 0;
  for (const HandleTick& tick : handle) {
    if (tick.passage != passage) continue;
    sum += tick.position;
    minimum = std::min(minimum, tick.position);
    maximum = std::max(maximum, tick.position);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return RestMeasure{sum / static_cast<double>(count), maximum - minimum};
}

SilenceMeasure silenceIn(const std::vector<HandleTick>& handle, const std::vector<LoopTick>& loop,
                         const std::string& passage, double quantum)
{
  SilenceMeasure measure;
  const auto begin = firstOf(handle, passage);
  if (begin == handle.begin() || begin == handle.end()) return measure;
  const auto last = std::find_if(std::make_reverse_iterator(begin), handle.rend(),
                                 [](const HandleTick& tick) { return tick.sent != 0; });
  if (last == handle.rend()) return measure;

  const auto after = firstReadAfter(loop, last->sent);
  if (after != loop.begin()) measure.before = std::prev(after)->force;
  const auto zero = std::find_if(after, loop.end(), [quantum](const LoopTick& tick) {
    return std::abs(tick.force) < 0.5 * quantum;
  });
  if (zero != loop.end()) measure.written = seconds(zero->written - last->sent);
  const auto heard = std::find_if(begin, handle.end(), [](const HandleTick& tick) {
    return tick.answered != 0 && tick.force == 0;
  });
  if (heard != handle.end()) measure.heard = seconds(heard->answered - last->sent);
  return measure;
}

}  // namespace perilymph::hidstack
