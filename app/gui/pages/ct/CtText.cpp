// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/CtText.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>

#include "gui/text/Numbers.h"
#include "perilymph/anatomy/DuctLength.h"
#include "perilymph/foundation/Normal.h"

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

/// A length with its 95 % interval.
QString intervalText(double value_mm, double sd_mm, int decimals)
{
  return tr("%1 ± %2 mm")
      .arg(numberText(value_mm, decimals), numberText(halfWidth95 * sd_mm, decimals));
}

}  // namespace

QString planeName(PlaneFrame frame, std::size_t plane)
{
  if (frame == PlaneFrame::cochlea)
    return plane == 0   ? tr("Cochlear view")
           : plane == 1 ? tr("Mid-modiolar, along A")
                        : tr("Mid-modiolar, along B");
  return plane == 0 ? tr("Axial") : plane == 1 ? tr("Coronal") : tr("Sagittal");
}

QString markName(ct::Mark mark)
{
  switch (mark) {
    case ct::Mark::roundWindow:
      return tr("Round window");
    case ct::Mark::farWall:
      return tr("Lateral wall (end of A)");
    case ct::Mark::nearB:
      return tr("Lateral wall, first end of B");
    case ct::Mark::farB:
      return tr("Lateral wall, second end of B");
    case ct::Mark::floor:
      return tr("Base (floor of the basal turn)");
    case ct::Mark::apex:
      return tr("Apex");
    case ct::Mark::modiolus:
      return tr("Modiolus");
  }
  return {};
}

QString structureGuide(ct::MarkupKind structure)
{
  switch (structure) {
    case ct::MarkupKind::facialNerve:
      return tr(
          "Click along the center of its canal: the mastoid part below the lateral semicircular "
          "canal, in axial slices from above downward.");
    case ct::MarkupKind::chordaTympani:
      return tr(
          "Click along its canal, from the mastoid part of the facial nerve up to the tympanic "
          "cavity. Where the slices do not show it, it is not marked.");
    case ct::MarkupKind::canalWall:
      return tr(
          "Click on the surface of the posterior wall of the ear canal that faces the mastoid.");
    case ct::MarkupKind::distance:
    case ct::MarkupKind::angle:
    case ct::MarkupKind::note:
    case ct::MarkupKind::approach:
      break;
  }
  return {};
}

QString distanceText(const ct::DistanceToLine& distance)
{
  return intervalText(distance.distance_mm, distance.sd_mm, 1);
}

QString markGuide(ct::Mark mark)
{
  switch (mark) {
    case ct::Mark::roundWindow:
      return tr("Cochlear view: the center of the round window, where the basal turn opens.");
    case ct::Mark::farWall:
      return tr(
          "Cochlear view: from the round window through the modiolus to the opposite lateral "
          "wall of the basal turn.");
    case ct::Mark::nearB:
    case ct::Mark::farB:
      return tr(
          "Cochlear view: the lateral wall of the basal turn on the line through the modiolus, "
          "perpendicular to A.");
    case ct::Mark::floor:
      return tr("Mid-modiolar view: the lowest point of the basal turn’s bony lumen.");
    case ct::Mark::apex:
      return tr("Mid-modiolar view: the highest point of the apical turn’s bony lumen.");
    case ct::Mark::modiolus:
      return tr("Cochlear view: the center of the modiolus in the basal turn.");
  }
  return {};
}

QString measureText(const ct::Measure& measure, int decimals)
{
  return intervalText(measure.value, measure.sd(), decimals);
}

QString errorText(const ct::Measure& measure)
{
  return tr("95 % interval. Standard deviations: noise and voxels %1 mm, shape model %2 mm, "
            "position of the round window %3 mm.")
      .arg(numberText(measure.statistical, 2), numberText(measure.model, 2),
           numberText(measure.definition, 2));
}

QString markupName(ct::MarkupKind kind)
{
  switch (kind) {
    case ct::MarkupKind::distance:
      return tr("Distance");
    case ct::MarkupKind::angle:
      return tr("Angle");
    case ct::MarkupKind::note:
      return tr("Note");
    case ct::MarkupKind::facialNerve:
      return tr("Facial nerve");
    case ct::MarkupKind::chordaTympani:
      return tr("Chorda tympani");
    case ct::MarkupKind::canalWall:
      return tr("Canal wall");
    case ct::MarkupKind::approach:
      return tr("Line of approach");
  }
  return {};
}

QString markupText(const ct::Markup& markup, const Eigen::Matrix3d& voxelEdges_P)
{
  const QString text = QString::fromStdString(markup.text);
  const auto value = ct::valueOf(markup, voxelEdges_P);
  if (!value) return text.isEmpty() ? markupName(markup.kind) : text;
  const QString number =
      markup.kind == ct::MarkupKind::angle
          ? tr("%1 ± %2°").arg(numberText(value->value, 1), numberText(halfWidth95 * value->sd, 1))
          : intervalText(value->value, value->sd, 2);
  return text.isEmpty() ? number : tr("%1: %2").arg(text, number);
}

QString placeText(const Eigen::Vector3d& point_P)
{
  return QStringLiteral("%1; %2; %3")
      .arg(numberText(point_P.x(), 1), numberText(point_P.y(), 1), numberText(point_P.z(), 1));
}

QStringList cursorText(const CtStudy& study, const Eigen::Vector3d& point_P)
{
  const QString place = tr("LPS %1 mm").arg(placeText(point_P));
  if (!study.hasCt() || !study.volume()->contains(point_P)) return {tr("outside the CT"), place};
  const auto intensity = study.volume()->sample(point_P);
  if (!intensity) return {tr("not measured"), place};
  const QString value = numberText(*intensity, 0);
  const bool isStated = study.series().format == "DICOM";
  return {!isStated ? tr("%1, unit not stated").arg(value)
          : imaging::grayValueNote(study.series()).empty()
              ? tr("%1 HU").arg(value)
              : tr("%1, gray value, not HU").arg(value),
          place};
}

QString planePlaceText(const CtStudy& study, std::size_t plane)
{
  const Eigen::Vector3d voxel = study.volume()->spacing_mm();
  const QString voxels =
      QStringLiteral("%1 × %2 × %3")
          .arg(numberText(voxel.x(), 2), numberText(voxel.y(), 2), numberText(voxel.z(), 2));
  const QString thickness = numberText(study.thickness_mm(), 0);
  const QString slab = study.thickness_mm() == 0.0 ? tr("single layer, voxels %1 mm").arg(voxels)
                       : study.projection() == imaging::Projection::mean
                           ? tr("slab %1 mm, mean").arg(thickness)
                           : tr("slab %1 mm, maximum").arg(thickness);
  return tr("%1 · through LPS %2 mm · %3 · level %4, width %5")
      .arg(planeName(study.frame(), plane), placeText(study.planes()[plane].center_P), slab,
           numberText(study.window().center, 0), numberText(study.window().width, 0));
}

QString lengthText(const std::optional<double>& value_mm)
{
  return value_mm ? tr("%1 mm").arg(numberText(*value_mm, 2)) : QStringLiteral("–");
}

QString seriesText(const imaging::CtSeries& series)
{
  QString text =
      QStringLiteral("%1 × %2 × %3 · %4 × %5 × %6 mm")
          .arg(series.size[0])
          .arg(series.size[1])
          .arg(series.size[2])
          .arg(numberText(series.spacing_mm.x(), 2), numberText(series.spacing_mm.y(), 2),
               numberText(series.spacing_mm.z(), 2));
  const QString scanner = QString::fromStdString(series.scanner);
  return scanner.isEmpty() ? text : text + QStringLiteral(" · ") + scanner;
}

QString ductLengthDetail(const ct::CochleaMeasures& measures)
{
  const Length fromA = anatomy::ductLengthFromA(millimeters(measures.a.value));
  return tr("Its interval holds what the formula of A alone gives: %1 mm (Alexiades et al. 2015).")
      .arg(numberText(inMillimeters(fromA), 1));
}

QString ductLengthText(const ct::CochleaMeasures& measures)
{
  // The formulas assume 2.5 turns; the flag says so.
  if (!measures.cdlOc) return {};
  return tr(
      "CDL: cochlear duct length along the organ of Corti, from A and B (elliptic-circular).");
}

}  // namespace perilymph::gui
