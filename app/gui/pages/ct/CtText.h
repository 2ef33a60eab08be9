// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Texts of the page CT.

#include <QString>
#include <cstddef>
#include <optional>

#include "gui/pages/ct/CtStudy.h"

namespace perilymph::gui {

/// "Cochlear view", "Axial"; `plane` from 0 to 2.
QString planeName(PlaneFrame frame, std::size_t plane);
/// "Round window"
QString markName(ct::Mark mark);
/// "Facial nerve"
QString structureName(ct::MarkupKind structure);
/// How the points of a structure are found in the pictures.
QString structureGuide(ct::MarkupKind structure);
/// "3.1 ± 0.6 mm": distance from the line of approach and its 95 % interval.
QString distanceText(const ct::DistanceToLine& distance);
/// How a landmark is found in the pictures.
QString markGuide(ct::Mark mark);
/// "9.12 ± 0.21 mm": value and 95 % interval.
QString measureText(const ct::Measure& measure, int decimals = 2);
/// Sources of the error: statistical, model, definition of 0 degrees.
QString errorText(const ct::Measure& measure);
/// "9.12 mm", a dash if not measured.
QString lengthText(const std::optional<double>& value_mm);
/// "512 x 512 x 200 · 0.40 x 0.40 x 0.60 mm · maker and model"
QString seriesText(const imaging::CtSeries& series);
/// What the formula of A alone gives, in the interval of the duct length.
QString ductLengthDetail(const ct::CochleaMeasures& measures);
/// What the duct length is, and from what.
QString ductLengthText(const ct::CochleaMeasures& measures);

}  // namespace perilymph::gui
