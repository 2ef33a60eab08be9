// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Retrieval of one series into a private folder.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "perilymph/archive/Exchange.h"
#include "perilymph/archive/Servers.h"

namespace perilymph::archive {

/// A series on a server.
struct SeriesAddress {
  std::string studyUid, seriesUid;
};

/// Beyond these a series is refused: the numbers that imaging reads (maxCtFiles, maxCtVoxels of two
/// bytes), doubled for headers and what is not the CT itself.
struct FetchLimits {
  std::size_t images = 20'000;
  std::uint64_t bytes = 4'000'000'000;
};

struct FetchedSeries {
  std::size_t images = 0;   ///< Files in the folder.
  std::size_t resumed = 0;  ///< Those among them that an earlier, interrupted call had received.
};

/// Retrieves a series by the server's way (Server::retrieval). Its files arrive in `folder` +
/// ".partial" (mode 0700), each whole or not at all, named by digits of a hash; once all images that
/// the server lists are there, the folder gets its name. After an error or a kill they stay, and the
/// next call requests only what is missing.
///
/// @param folder  Does not exist yet.
/// @return        Refuses a series that the server does not list, one beyond the limits, an object of
///                another series, study or patient, and a series that arrived in part, with its count.
Result<FetchedSeries> fetchSeries(const Server& server, const SeriesAddress& series,
                                  const std::filesystem::path& folder,
                                  const Exchange& exchange = {}, const FetchLimits& limits = {});

}  // namespace perilymph::archive
