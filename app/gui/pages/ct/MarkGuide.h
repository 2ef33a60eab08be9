// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The guide to the landmark that is being placed.

#include <QWidget>
#include <optional>

#include "gui/pages/ct/CtStudy.h"

class QLabel;

namespace perilymph::gui {

class LandmarkDrawing;

/// Name, place in a drawn cochlea of the patient's size and side, and how it is found in the
/// pictures. Hidden while none is placed.
class MarkGuide : public QWidget {
  Q_OBJECT
public:
  MarkGuide(const CtStudy& study, QWidget* parent);

  /// Shows a landmark; none hides the guide.
  void showMark(const std::optional<ct::Mark>& mark);

private:
  const CtStudy& study_;
  QLabel *name_, *text_;
  LandmarkDrawing* drawing_;
};

}  // namespace perilymph::gui
