// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The measures of a patient's ear as they were saved one after the other, and how they differ.

#include <QString>
#include <QStringList>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gui/setup/PatientLibrary.h"

namespace perilymph::gui {

using session::haveSameMeasures;

/// Measures as they were saved once.
struct MeasureVersion {
  anatomy::Patient patient;
  std::string utc;  ///< When; empty if unknown.
  QString how;      ///< "automatic", "by hand: RW, LW" in a CT, or "entered".
  bool isUsed = false;
};

/// The versions of a patient, the newest first. The measures in use are always among them.
std::vector<MeasureVersion> versionsOf(const SavedPatient& patient);

/// The measures that a saved patient had before these; empty if they are the first ones.
std::optional<MeasureVersion> versionBefore(const anatomy::Patient& patient);

/// A measure with the standard deviations of its measurement and of its formula [mm].
struct ComparedMeasure {
  double value = 0.0, sd = 0.0, formula = 0.0;
};
/// A, B, H and the cochlear duct length; empty where they are not measured.
using ComparedMeasures = std::array<std::optional<ComparedMeasure>, 4>;
ComparedMeasures comparedOf(const anatomy::Patient& patient);
/// "A", "B", "H", "CDL"
std::array<QString, 4> comparedNames();

/// "9.45 ± 0.28", the 95 % interval; a dash if it is not measured.
QString comparedText(const std::optional<ComparedMeasure>& measure, std::size_t which);

/// What a measure changed by.
struct MeasureDifference {
  QString text;  ///< "+0.07 ± 0.40", between the values as shown; a dash unless both are measured.
  bool isBeyond = false;  ///< Beyond its 95 % interval.
  QString detail;         ///< Says so.
};
MeasureDifference differenceOf(const std::optional<ComparedMeasure>& before,
                               const std::optional<ComparedMeasure>& after, std::size_t which);

/// "A 9.45 → 9.52 mm, B 6.80 → 6.81 mm, H 3.90 → 3.88 mm, CDL 34.1 → 34.4 mm"
QString changeText(const anatomy::Patient& before, const anatomy::Patient& after);

/// What speaks against saving an ear that was measured in a CT series under its code, a sentence each: the
/// series is saved under another code, or this code was measured in other series. None if the ear was
/// saved from this series before.
QStringList seriesDoubts(const anatomy::Patient& measured);

/// "This plan is of A 8.85 mm; the measures in use are A 9.30 mm.", with the measures that differ from
/// the saved ones of this code and ear; empty if none does, or none are saved.
QString supersededText(const anatomy::Patient& planned);

/// "Measured again (by hand: RW; before: automatic): A 9.45 → 9.52 mm, ..."
QString remeasuredText(const anatomy::Patient& before, const anatomy::Patient& after);
/// The same from the measures that a saved patient had before these; empty if they are the first ones.
QString remeasuredText(const anatomy::Patient& patient);

}  // namespace perilymph::gui
