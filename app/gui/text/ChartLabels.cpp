// SPDX-License-Identifier: BSD-3-Clause
#include "gui/text/ChartLabels.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>

namespace perilymph::gui {

// lupdate of Qt 5.15.15 takes a qualified return type for the function's class.
using charts::ChartStyle;
using visualization::SceneStyle;

namespace {

// lupdate assigns texts of free functions to their namespace.
std::string tr(const char* text)
{
  return QCoreApplication::translate("perilymph::gui", text).toStdString();
}

char decimalSign() { return QString(QLocale().decimalPoint()).toStdString().front(); }

}  // namespace

ChartStyle chartStyle(figures::ColorScheme scheme)
{
  ChartStyle style{scheme, {}};
  style.strings = {
      .travel = tr("travel, mm"),
      .axialForce = tr("insertion force, mN"),
      .force = tr("force, mN"),
      .now = tr("now"),
      .thisInsertion = tr("this insertion"),
      .feltBySurgeons = tr("perception threshold %1 mN"),
      .axial = tr("axial"),
      .lateral = tr("lateral"),
      .vertical = tr("vertical"),
      .outerWall = tr("outer wall"),
      .modiolus = tr("modiolus"),
      .basilarMembrane = tr("basilar membrane"),
      .wallForceScale = tr("wall force, 50 mN per mm"),
      .wallForce = tr("wall force %1 mN"),
      .unrolledAxes = tr("angle from round window, °; width, mm"),
      .tipIsOutside = tr("tip is outside the cochlea"),
      .noContactInside = tr("no contact inserted yet"),
      .meanAndInside = tr("mean %1 mm, %2 inserted"),
      .meanAndAbove = tr("mean %1 mm, %2 below the partition, %3 above"),
      .onlyAbove = tr("%1 above the partition"),
      .rupture = tr("rupture"),
      .rib = tr("rib %1"),
      .decimalSign = decimalSign(),
  };
  return style;
}

SceneStyle sceneStyle(figures::ColorScheme scheme, double textScale)
{
  SceneStyle style{scheme, {}, textScale};
  style.strings = {
      .wallForce = tr("wall force, mN per mm"),
      .normalForce = tr("contact force (arrow %1 mm = %2 mN)"),
      .friction = tr("friction force (arrows enlarged %1×)"),
      .decimalSign = decimalSign(),
  };
  return style;
}

QString referenceName(const std::string& label)
{
  // labels of the shipped references in their files
  static const char* const shipped[] = {
      QT_TRANSLATE_NOOP("perilymph::gui", "published measurements, mean ± SD"),
  };
  for (const char* one : shipped)
    if (label == one) return QCoreApplication::translate("perilymph::gui", one);
  return QString::fromStdString(label);
}

}  // namespace perilymph::gui
