// SPDX-License-Identifier: BSD-3-Clause
#include "ParserTrial.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <new>
#include <stop_token>

#include "../SharedMemory.h"
#include "../UntrustedRead.h"
#include "DicomDirectory.h"
#include "DicomHeader.h"
#include "StudyIdentity.h"

namespace perilymph::imaging {
namespace {

constexpr std::size_t maxBytes = std::size_t{512} << 20;
/// Files for one child, so that neither its start nor its minute counts.
constexpr std::size_t filesAtOnce = 64;
/// Chosen: far above what these headers take, and a quarter of the minute of a second child.
constexpr std::chrono::seconds patience{15};

/// Chosen: a header of a thousand frames takes a tenth of it.
constexpr double slow_s = 3.0;

/// Parses a file with each query that is asked here: another one reads other elements.
void parseAsHere(const std::filesystem::path& file)
{
  if (!readDicomHeader(file)) return;
  readDicomDirectory(file);
  identityIn(file);
}

/// Time of computing that this process has taken.
double taken_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// What a child reports while it works, in memory that it shares.
struct Report {
  volatile std::size_t place = 0;  ///< File that it parses.
  volatile std::size_t slow = 0;   ///< One that took too long, plus one; it ends behind it.
};

}  // namespace

std::optional<std::set<std::filesystem::path>> filesThatEndTheParser(
    const std::vector<std::filesystem::path>& files, const std::stop_token& stop,
    std::chrono::milliseconds longest)
{
  std::set<std::filesystem::path> found;
  const SharedMemory memory(sizeof(Report));
  if (!memory.isThere()) return std::set<std::filesystem::path>{files.begin(), files.end()};
  auto& report = *new (memory.start()) Report;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t begin = 0; begin < files.size();) {
    if (std::chrono::steady_clock::now() - start > longest) return std::nullopt;
    const std::size_t end = std::min(begin + filesAtOnce, files.size());
    report.place = begin;
    report.slow = 0;
    const auto work = [&] {
      for (std::size_t i = begin; i < end; ++i) {
        report.place = i;
        const double before_s = taken_s();
        parseAsHere(files[i]);
        if (taken_s() - before_s < slow_s) continue;
        report.slow = i + 1;
        return 0;
      }
      return 0;
    };
    const int status = runInChild(work, {maxBytes, stop, patience});
    if (status == 0 && report.slow == 0) {
      begin = end;
      continue;
    }
    if (stop.stop_requested()) break;
    found.insert(files[report.place]);
    begin = report.place + 1;
  }
  return found;
}

}  // namespace perilymph::imaging
