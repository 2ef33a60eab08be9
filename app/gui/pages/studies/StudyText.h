// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Names of a study's quantities and settings in the window's language.

#include <QString>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/study/StudyFile.h"

namespace perilymph::gui {

/// "angular insertion depth, °" for "angle_deg". Unknown keys are returned unchanged.
QString quantityTitle(const std::string& key);
/// "array" for "array"; "how it ended" for "ending". Unknown keys are returned unchanged.
QString settingTitle(const std::string& key);
/// "advance off stylet" for "aos", "folded tip" for "folded_tip". Unknown values, such as names
/// of arrays, are returned unchanged.
QString levelText(const std::string& level);

/// All values of an insertion, with their names.
std::vector<std::pair<QString, QString>> valuesOf(const study::StudyResult& result);

}  // namespace perilymph::gui
