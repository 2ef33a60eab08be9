// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Content of a report on one recorded insertion, computed in the background.

#include <QImage>
#include <QString>
#include <atomic>
#include <filesystem>
#include <optional>

#include "perilymph/analysis/Score.h"
#include "perilymph/session/Recording.h"
#include "perilymph/session/Replay.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

struct ReportContent {
  std::filesystem::path file;
  std::uint64_t bytes = 0;
  QString sha256;  ///< SHA-256 of the recording, in hexadecimal digits.
  session::RecordingFacts facts;
  std::uint64_t lostRecords = 0;
  bool wasClosed = true;
  session::Scenario scenario;
  analysis::ComparedInsertion insertion;
  std::optional<analysis::InsertionScore> score;
  session::Verification verification;
  std::optional<analysis::Reference> published;
  QImage picture;         ///< At maximum depth.
  double depth_mm = 0.0;  ///< Depth of the tip in the picture.
};

/// Replays the recording, in about a tenth of its duration.
Result<ReportContent> gatherReport(const std::filesystem::path& file,
                                   const std::atomic<bool>& isCanceled);

}  // namespace perilymph::gui
