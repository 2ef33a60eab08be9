// SPDX-License-Identifier: BSD-3-Clause
#include "gui/text/LandmarkText.h"

#include <QCoreApplication>

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

}  // namespace

QString markLabel(ct::Mark mark)
{
  switch (mark) {
    case ct::Mark::roundWindow:
      return tr("RW");
    case ct::Mark::farWall:
      return tr("LW");
    case ct::Mark::nearB:
      return QStringLiteral("B1");
    case ct::Mark::farB:
      return QStringLiteral("B2");
    case ct::Mark::floor:
      return tr("base");
    case ct::Mark::apex:
      return tr("apex");
    case ct::Mark::modiolus:
      return QStringLiteral("M");
  }
  return {};
}

}  // namespace perilymph::gui
