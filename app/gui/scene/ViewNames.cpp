// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/ViewNames.h"

#include "gui/scene/OperationView.h"

namespace perilymph::gui {

using visualization::CameraPreset;

QString nameOf(CameraPreset preset)
{
  switch (preset) {
    case CameraPreset::surgeon:
      return OperationView::tr("Surgeon’s view");
    case CameraPreset::microscope:
      return OperationView::tr("Through the opening");
    case CameraPreset::overview:
      return OperationView::tr("Overview");
    case CameraPreset::followTip:
      return OperationView::tr("Following the tip");
    case CameraPreset::section:
      return OperationView::tr("Basal-turn section");
  }
  return {};
}

QString nameOf(visualization::Stereo stereo)
{
  using visualization::Stereo;
  switch (stereo) {
    case Stereo::off:
      return {};
    case Stereo::anaglyph:
      return OperationView::tr("anaglyph");
    case Stereo::sideBySide:
      return OperationView::tr("side by side");
    case Stereo::interlaced:
      return OperationView::tr("interlaced");
    case Stereo::quadBuffered:
      return OperationView::tr("quad-buffered");
  }
  return {};
}

}  // namespace perilymph::gui
