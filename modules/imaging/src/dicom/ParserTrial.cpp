// SPDX-License-Identifier: BSD-3-Clause
#include "ParserTrial.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <new>

#include "../SharedMemory.h"
#include "../UntrustedRead.h"
#include "DicomHeader.h"
#include "StudyIdentity.h"

namespace perilymph::imaging {
namespace {

constexpr std::size_t maxBytes = std::size_t{512} << 20;
/// Files for one child, so that neither its start nor its minute counts.
constexpr std::size_t filesAtOnce = 64;
/// Chosen: far above what these headers take, and a quarter of the minute of a second child.
constexpr std::chrono::seconds patience{15};

/// Parses a file with each query that is asked here: another one reads other elements.
void parseAsHere(const std::filesystem::path& file)
{
  if (!readDicomHeader(file)) return;
  parseWholeHeader(file);
  identityIn(file);
}

}  // namespace

std::set<std::filesystem::path> filesThatEndTheParser(
    const std::vector<std::filesystem::path>& files, const std::function<bool()>& isCanceled)
{
  std::set<std::filesystem::path> found;
  const SharedMemory memory(sizeof(std::size_t));
  if (!memory.isThere()) return {files.begin(), files.end()};
  auto& place = *new (memory.start()) volatile std::size_t(0);
  for (std::size_t begin = 0; begin < files.size();) {
    const std::size_t end = std::min(begin + filesAtOnce, files.size());
    place = begin;
    const auto work = [&] {
      for (std::size_t i = begin; i < end; ++i) {
        place = i;
        parseAsHere(files[i]);
      }
      return 0;
    };
    if (runInChild(work, {maxBytes, isCanceled, patience}) == 0) {
      begin = end;
      continue;
    }
    if (isCanceled && isCanceled()) break;
    found.insert(files[place]);
    begin = place + 1;
  }
  return found;
}

}  // namespace perilymph::imaging
