// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Content of a report on one recorded insertion, computed in the background.

#include <QString>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "gui/report/ReportFile.h"
#include "gui/run/PlannedForce.h"
#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/analysis/ContactPositions.h"
#include "perilymph/analysis/PassedStop.h"
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
  bool mayGoOn =
      false;  ///< The insertion is still in the window: what it does next is recorded, too.
  session::Scenario scenario;
  analysis::ComparedInsertion insertion;
  std::optional<analysis::InsertionScore> score;
  session::Verification verification;
  std::optional<analysis::PassedStop> passedStop;  ///< See analysis::stopToPass().
  std::optional<PlannedForce> plan;                ///< What a plan expects of this insertion.
  std::optional<analysis::PrintedRange> rupture;   ///< Rupture forces of the cochlear partition.

  std::shared_ptr<const anatomy::ScalaTympani> anatomy;
  std::vector<analysis::Measure> measures;          ///< Measures of the cochlea.
  std::vector<double> bands;                        ///< Their uncertainty, or empty.
  haptics::Snapshot deepest{};                      ///< At maximum depth.
  haptics::TickOutput last{};                       ///< At the end of the recording.
  std::vector<analysis::ContactPosition> contacts;  ///< At maximum depth, from the tip.

  /// The saved patient with these measures: a recording keeps the measures, not where they are from.
  std::optional<anatomy::Patient> measured;

  /// The patient of the insertion, with the origin of the measures where it is known.
  const anatomy::Patient& patient() const { return measured ? *measured : scenario.patient(); }
  /// For a DICOM object; its series is that in which the saved patient was measured.
  ReportIdentity identity() const;
  /// True if the cochlea is scaled by the measures of a patient, not of the published model.
  bool hasPatient() const
  {
    return isScaledBy(scenario.anatomy(), scenario.patient()) &&
           scenario.patient().label != anatomy::Patient().label;
  }
};

/// Replays the recording, in about a tenth of its duration. The plan is newestPlannedForce().
Result<ReportContent> gatherReport(const std::filesystem::path& file, const std::stop_token& stop);

}  // namespace perilymph::gui
