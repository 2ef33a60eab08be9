// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Names of a study's quantities and settings in the window's language.

#include <QString>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/study/StudySummary.h"

namespace perilymph::gui {

/// "angular insertion depth, °" for "angle_deg". Unknown keys are returned unchanged.
QString quantityTitle(const std::string& key);
/// "array" for "array"; "outcome" for "ending". Unknown keys are returned unchanged.
QString settingTitle(const std::string& key);
/// "advance off-stylet" for "aos", "folded tip" for "folded_tip". Unknown values, such as names
/// of arrays, are returned unchanged.
QString levelText(const std::string& level);
/// The value of a setting in the unit of its title: "100" for "0.1" of "stop_force_N"; else levelText().
QString valueText(const std::string& key, const std::string& value);
/// "all that ran", "complete only".
QString selectionText(study::StudySelection selection);

/// "mN" for "peak_mN"; empty of a quantity without a unit.
QString unitOf(const std::string& key);
/// "Simulated cochlea 4" for "virtual 4"; names of patients are returned unchanged.
QString cochleaText(const std::string& name);
/// "40 s", "12 min", "3.5 h".
QString durationText(double seconds);
/// The words with a capital, as entries of lists have it.
QString inTheList(const QString& words);

/// All values of an insertion, with their names.
std::vector<std::pair<QString, QString>> valuesOf(const study::StudyResult& result);

}  // namespace perilymph::gui
