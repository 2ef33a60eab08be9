// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Queries at study and series level (C-FIND, Study Root). What is found names patients: it is
// returned to the caller, and neither logged nor written to a file.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/archive/Exchange.h"
#include "perilymph/archive/Servers.h"

namespace perilymph::archive {

/// Rows of an answer after which a query is canceled.
inline constexpr std::size_t maxFoundRows = 500;

/// What a study must match; empty fields match every study. Texts are UTF-8; * and ? are wildcards in
/// number and name.
struct StudyQuery {
  std::string patientId, patientName;
  std::string birthDate;    ///< YYYYMMDD.
  std::string from, until;  ///< Study date, YYYYMMDD, inclusive.
  std::string modality;     ///< At least one of its series has it: "CT".
};

/// A study as the server describes it, UTF-8; empty where it states nothing.
struct FoundStudy {
  std::string uid;
  std::string date;  ///< YYYYMMDD.
  std::string description;
  std::string modalities;  ///< Joined by "/".
  std::string patientName, patientId, birthDate;
};

struct FoundSeries {
  std::string uid;
  std::string number, modality, description;
  std::optional<std::size_t> images;  ///< Absent where the server does not count them.
};

/// Rows of an answer.
template <class Row>
struct Found {
  std::vector<Row> rows;
  bool isCut = false;  ///< The server had more than maxFoundRows.
};

/// Finds studies, in the order of the server. Refuses a query without any condition, and dates that
/// are none.
Result<Found<FoundStudy>> findStudies(const Server& server, const StudyQuery& query,
                                      const Exchange& exchange = {});

/// Finds the series of a study.
Result<Found<FoundSeries>> findSeries(const Server& server, const std::string& studyUid,
                                      const Exchange& exchange = {});

}  // namespace perilymph::archive
