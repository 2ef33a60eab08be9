// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/StudyEstimate.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <stop_token>

#include "perilymph/analysis/InsertionRun.h"
#include "perilymph/foundation/InParallel.h"

namespace perilymph::study {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t maxMeasured = 3;

double secondsSince(Clock::time_point begin)
{
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Bytes of a row of each table, in the shard and in the merged file and table.
double bytesOf(const Study& study, const analysis::InsertionRun& found)
{
  const double contacts = study.keepsContacts() ? static_cast<double>(found.contacts.size()) : 0.0;
  return 2.0 * (330.0 + 55.0 * contacts + 30.0 * static_cast<double>(found.profile.size())) + 250.0;
}

}  // namespace

Result<StudyEstimate> estimate(const Study& study, const std::stop_token& stop)
{
  const std::size_t measured = std::min(study.casesPerCochlea(), maxMeasured);
  double buildTime = 0.0, insertionTime = 0.0, bytes = 0.0;
  // one after the other, in a thread that may run insertions
  const auto measure = [&](std::size_t, const std::stop_token& ending) -> Result<void> {
    std::shared_ptr<const anatomy::ScalaTympani> anatomy;
    for (std::size_t i = 0; i < measured && !ending.stop_requested(); ++i) {
      const auto parameters =
          study.parametersOf(study.caseAt(i * (study.casesPerCochlea() / measured)));
      if (!parameters) return parameters.error();
      auto begin = Clock::now();
      if (!anatomy) {
        auto built = session::buildAnatomy(*parameters);
        if (!built) return built.error();
        anatomy = *built;
        buildTime = secondsSince(begin);
        begin = Clock::now();
      }
      const analysis::InsertionRun found =
          analysis::runInsertion(*parameters, anatomy, study.profileSpacing(), ending);
      insertionTime += secondsSince(begin) / static_cast<double>(measured);
      bytes += bytesOf(study, found) / static_cast<double>(measured);
    }
    return {};
  };
  if (const auto done = doInParallel(1, 1, measure, {}, stop); !done) return done.error();
  const auto cases = static_cast<double>(study.size());
  return StudyEstimate{
      static_cast<double>(study.cochleae().size()) * buildTime + cases * insertionTime,
      cases * bytes, measured};
}

}  // namespace perilymph::study
