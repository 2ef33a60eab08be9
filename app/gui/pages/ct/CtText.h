// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Texts of the page CT.

#include <QString>
#include <QStringList>
#include <cstddef>
#include <optional>

#include "gui/pages/ct/CtStudy.h"

namespace perilymph::gui {

/// "Cochlear view", "Axial"; `plane` from 0 to 2.
QString planeName(PlaneFrame frame, std::size_t plane);
/// "Round window"
QString markName(ct::Mark mark);
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
/// A kind of markup: "Distance".
QString markupName(ct::MarkupKind kind);

/// A markup's label: "13.00 ± 0.24 mm", the 95 % interval of placing it; "42.3 ± 1.5°"; the text of a note; the name of
/// a structure. A text of a measured one stands before the value.
QString markupText(const ct::Markup& markup, const Eigen::Matrix3d& voxelEdges_P);

/// The intensity at a point and the point, a line each: "612 HU", "LPS 12.3, −45.6, 78.9 mm". The intensity is
/// interpolated between the eight voxels around the point, as the picture is.
QStringList cursorText(const CtStudy& study, const Eigen::Vector3d& point_P);

/// "12.3, −45.6, 78.9", in LPS [mm].
QString placeText(const Eigen::Vector3d& point_P);

/// What a picture of a plane shows: "Axial · LPS 12.3, −45.6, 78.9 mm · single layer of voxels of 0.30 × 0.30 × 0.30 mm ·
/// level 700, width 4000".
QString planePlaceText(const CtStudy& study, std::size_t plane);

/// "9.12 mm", a dash if not measured.
QString lengthText(const std::optional<double>& value_mm);
/// "512 x 512 x 200 · 0.40 x 0.40 x 0.60 mm · maker and model"
QString seriesText(const imaging::CtSeries& series);
/// What the formula of A alone gives, in the interval of the duct length.
QString ductLengthDetail(const ct::CochleaMeasures& measures);
/// What the duct length is, and from what.
QString ductLengthText(const ct::CochleaMeasures& measures);

}  // namespace perilymph::gui
