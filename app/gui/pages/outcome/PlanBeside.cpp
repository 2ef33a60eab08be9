// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/outcome/PlanBeside.h"

#include <QCoreApplication>
#include <algorithm>

#include "gui/pages/plan/ForceBands.h"
#include "gui/setup/OutcomeWords.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/TableHeads.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int besideRow_px = 22, besideHeader_px = 26;
constexpr int besideWidths_px[] = {116, 126, 110, 84};

std::string figureWords(const char* text)
{
  return QCoreApplication::translate("perilymph::gui", text).toStdString();
}

/// How the array was moved: a scripted speed, or a hand.
std::string insertedWords(const std::optional<double>& speed)
{
  if (!speed) return figureWords(QT_TRANSLATE_NOOP("perilymph::gui", "inserted by hand"));
  return QCoreApplication::translate("perilymph::gui", "inserted at %1 mm/s")
      .arg(numberText(1e3 * *speed, 2))
      .toStdString();
}

}  // namespace

PlanBeside::PlanBeside(QWidget* parent) : QTableWidget(0, int(std::size(besideWidths_px)), parent)
{
  setObjectName(QStringLiteral("outcomeBesidePlan"));
  setAccessibleName(tr("Plan beside outcome"));
  const std::pair<QString, QString> columns[] = {
      {tr("Quantity"), tr("The depth of the array, and the angle of each contact; 1 at the tip")},
      {tr("Plan"),
       tr("Median and band of the plan; above stands what it holds. Of a contact, of the "
          "simulations in which it is inside.")},
      {tr("Found"), tr("Measured in the CT after surgery, with its 95 % interval")},
      {tr("Percentile"), tr("Share of the plan’s simulations below the value found, with its "
                            "error; of a contact from the quantiles of the band")}};
  showValues(*this, columns, sized(besideRow_px), sized(besideHeader_px));
}

void PlanBeside::show(const planning::ArrayPlan* plan, const outcome::PlannedOutcome& ends,
                      const outcome::FoundArray& found)
{
  setRowCount(0);
  const auto add = [this](const QStringList& texts) {
    const int row = rowCount();
    insertRow(row);
    for (int column = 0; column < texts.size(); ++column)
      setItem(row, column, new QTableWidgetItem(texts[column]));
  };
  const QString none = tr("–");
  const outcome::Uncertain& depth = found.angularInsertionDepth_deg;
  const outcome::Uncertain inserted{found.insertedLength_mm, found.insertedLengthSd_mm};
  const QString depthPlace = plan ? percentileText(ends.angles_deg, plan->angle_deg, depth) : none;
  add({tr("Angular insertion depth"), plan ? bandWords(plan->angle_deg, 0, tr("°")) : none,
       depthText(found), depthPlace});
  add({tr("Inserted length"), plan ? bandWords(plan->depth_mm, 1, tr(" mm")) : none,
       insertedText(found),
       plan ? percentileText(ends.depths_mm, plan->depth_mm, inserted) : none});
  bool isApical = true;  // the depth is the angle of the first one inside
  for (const outcome::FoundContact& each : found.contacts) {
    const planning::ContactBand* planned = nullptr;
    if (plan != nullptr)
      for (const planning::ContactBand& band : plan->contacts)
        if (band.number == each.number && band.draws > 0) planned = &band;
    add({tr("Contact %1").arg(each.number),
         planned ? bandWords(planned->angle_deg, 0, tr("°")) : none, angleText(each),
         !planned || !each.isInside ? none
         : isApical                 ? depthPlace
                                    : percentileText(planned->angle_deg, each.angle_deg.value)});
    if (each.isInside) isApical = false;
  }
  fitColumns(*this, besideWidths_px);
}

std::optional<figures::Figure> forceBeside(const PlannedEar& ear, const outcome::FoundArray& found)
{
  if (!ear.plan && !ear.insertion) return std::nullopt;
  figures::Figure figure;
  if (ear.plan)
    figure = forceBands(ear.plan->plan, {ear.place});
  else
    figure.title = figureWords(QT_TRANSLATE_NOOP("perilymph::gui", "Insertion force over depth"));
  const double wide_mm = std::max(1.96 * found.insertedLengthSd_mm, 0.1);
  double deepest_mm = std::max(ear.plan ? figure.x.high : 1.0, found.insertedLength_mm + wide_mm);
  double top_mN = ear.plan ? figure.y.high : 10.0;
  if (ear.insertion) {
    figures::FigureCurve curve;
    curve.label = insertedWords(ear.insertion->settings.speed);
    curve.ink = figures::ink::vermilion;
    curve.width = 2.0;
    for (const analysis::AxisPoint& point : ear.insertion->overDepth) {
      curve.x.push_back(1e3 * point.place);
      curve.y.push_back(1e3 * point.force);
      deepest_mm = std::max(deepest_mm, curve.x.back());
      top_mN = std::max(top_mN, curve.y.back());
    }
    figure.curves.push_back(std::move(curve));
  }
  figure.x = figures::axisOver(
      figureWords(QT_TRANSLATE_NOOP("perilymph::gui", "insertion depth, mm")), 0.0, deepest_mm);
  figure.y = figures::axisOver(
      figureWords(QT_TRANSLATE_NOOP("perilymph::gui", "axial insertion force, mN")), 0.0, top_mN);
  figure.bands.push_back(
      {figureWords(QT_TRANSLATE_NOOP("perilymph::gui", "inserted in the patient")),
       {found.insertedLength_mm - wide_mm, found.insertedLength_mm + wide_mm},
       {figure.y.low, figure.y.low},
       {figure.y.high, figure.y.high},
       figures::ink::tint(figures::ink::green, 0.35)});
  return figure;
}

}  // namespace perilymph::gui
