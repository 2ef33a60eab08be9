// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/BoneNote.h"

#include <QCoreApplication>

namespace perilymph::gui {

namespace {

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

}  // namespace

QString boneNote(bool hasBone, CochleaOrigin origin)
{
  if (hasBone) return tr("Bone of the patient’s CT");
  if (origin == CochleaOrigin::model)
    return tr("Schematic: landmarks of this model; it has no bone.");
  const QString schematic =
      tr("Schematic: landmarks of the average cochlea, scaled to the patient’s measures.");
  return schematic + QLatin1Char(' ') +
         (origin == CochleaOrigin::numbers ? tr("There is no CT of this patient.")
                                           : tr("The bone appears once the CT of this patient is "
                                                "open and measured on page CT."));
}

QString boneTip()
{
  return tr(
      "Drag: rotate. Drag the handle, Ctrl+drag or Page Up, Page Down: move the cut. V: turn "
      "the cut to the viewer. Wheel: zoom.");
}

}  // namespace perilymph::gui
