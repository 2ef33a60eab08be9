#include "gui/parts/ChartLabels.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>

#include "perilymph/charts/ChartStrings.h"
#include "perilymph/visualization/SceneStrings.h"

namespace perilymph::gui {

namespace {

// lupdate looks for words of free functions under the name of their namespace.
std::string tr(const char* text)
{
  return QCoreApplication::translate("perilymph::gui", text).toStdString();
}

}  // namespace

void translateCharts()
{
  charts::setChartStrings({
      .travel = tr("travel, mm"),
      .axialForce = tr("axial force, N"),
      .force = tr("force, mN"),
      .now = tr("now"),
      .thisInsertion = tr("this insertion"),
      .feltBySurgeons = tr("felt by surgeons 20 mN"),
      .axial = tr("axial"),
      .lateral = tr("lateral"),
      .vertical = tr("vertical"),
      .outerWall = tr("outer wall"),
      .modiolus = tr("modiolus"),
      .basilarMembrane = tr("basilar membrane"),
      .wallForceScale = tr("wall force, 50 mN per mm"),
      .wallForce = tr("wall force %1 mN"),
      .unrolledAxes = tr("angle from round window, °; width, mm"),
      .tipIsOutside = tr("the tip is outside"),
      .noContactInside = tr("no contact is inside yet"),
      .meanAndInside = tr("mean %1 mm, %2 inside"),
      .decimalSign = QString(QLocale().decimalPoint()).toStdString().front(),
  });
  visualization::setSceneStrings({
      .wallForce = tr("wall force, mN per mm"),
      .normalForce = tr("normal force, %1 mm for %2 mN"),
      .friction = tr("friction, × %1"),
  });
}

QString referenceName(const std::string& label)
{
  // what the shipped references are called in their files
  static const char* const shipped[] = {
      QT_TRANSLATE_NOOP("perilymph::gui", "published experiment, printed values ± SD"),
  };
  for (const char* one : shipped)
    if (label == one) return QCoreApplication::translate("perilymph::gui", one);
  return QString::fromStdString(label);
}

}  // namespace perilymph::gui
