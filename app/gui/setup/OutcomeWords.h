// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Words of an implanted array that was found in a CT, in window and report: the same in both.

#include <QString>
#include <QStringList>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/outcome/FoundArray.h"
#include "perilymph/outcome/Surgery.h"
#include "perilymph/planning/PlanResult.h"

namespace perilymph::gui {

/// "1 (E22)": its number from the tip and that of its maker's fitting software, if that is known.
QString contactText(const outcome::FoundContact& contact);
/// "421 (409–433)°": a value with its 95 % interval; a dash for a contact outside.
QString angleText(const outcome::FoundContact& contact);
/// "98 %": the probability that a contact lies below the basilar membrane.
QString scalaText(const outcome::FoundContact& contact);
/// "singly", "by spacing", "by hand": how a contact was placed.
QString placementText(const outcome::FoundContact& contact);
/// "0.35 (0.30–0.41) kHz"; a dash where none is known.
QString frequencyText(const std::array<double, 3>& frequency_Hz);

/// "5 (3–7)" semitones: the place's frequency on the spiral ganglion above the contact's default filter, with the interval of
/// that frequency; a dash without a filter.
QString mismatchText(const outcome::FoundContact& contact);

/// The share of a plan's simulations below a value, from the quantiles of its band: linear between
/// them. None below the lowest or above the highest quantile that the band states.
std::optional<double> percentileIn(const planning::Band& band, double value);

/// "37 %": where a value is in a band; "below 5 %", "above 95 %" outside of it.
QString percentileText(const planning::Band& band, double value);

/// "37 %": the place of a value with its error among a plan's simulations, as the page Outcomes states it; from the
/// quantiles of the band where the simulations are not there.
QString percentileText(const std::vector<double>& simulated, const planning::Band& band,
                       const outcome::Uncertain& found);

/// "421 (380–455)°": the median of a plan's band, and the band.
QString bandWords(const planning::Band& band, int decimals, const QString& unit);

/// "FLEX28": the title of an array by its shipped name; that name where it is no shipped one.
QString arrayTitle(const std::string& name);

/// "resistance was felt"
QString textOf(outcome::StopReason reason);
QString textOf(outcome::Opening opening);
QString textOf(outcome::Tool tool);

/// "421 (409–433)°" of the most apical contact inside.
QString depthText(const outcome::FoundArray& found);
/// "27.1 (26.5–27.7) mm" of the array past the opening.
QString insertedText(const outcome::FoundArray& found);
/// "12 of 12"
QString insideText(const outcome::FoundArray& found);
/// How the ear was found: "carried over from the CT before surgery, residual 0.12 mm".
QString earSourceText(const outcome::FoundArray& found);
/// Why a plan is no prediction of an outcome, a sentence; empty if it was made before surgery.
/// @param ctDay  Day of the CT after surgery: "2026-11-20"; empty where it is not known.
QString predictionDoubt(const std::string& planMadeUtc, const std::string& ctDay,
                        const outcome::Surgery& surgery);
/// What is doubtful, a sentence each.
QStringList flagTexts(const outcome::FoundArray& found);
/// Where the surgeon's answers and the CT contradict each other, a sentence each.
QStringList contradictionTexts(const outcome::Surgery& surgery, const outcome::FoundArray& found);

}  // namespace perilymph::gui
