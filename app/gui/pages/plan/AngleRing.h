// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The angles of an array's contacts around the modiolus.

#include <QWidget>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/planning/PlanResult.h"

namespace perilymph::gui {

/// Where a contact was found in a CT.
struct FoundAngle {
  double angle_deg = 0.0, low_deg = 0.0, high_deg = 0.0;  ///< With its 95 % interval.
};

/// A spiral from the round window on, as seen from the apex. Contacts are dots at their median
/// angles with arcs from 5 to 95 %; a left ear is mirrored. Contacts found in a CT are drawn over them.
class AngleRing : public QWidget {
  Q_OBJECT
public:
  explicit AngleRing(QWidget* parent);

  void show(const std::vector<planning::ContactBand>& contacts, anatomy::Side side,
            std::vector<FoundAngle> found = {});
  QSize minimumSizeHint() const override { return {160, 150}; }

protected:
  void paintEvent(QPaintEvent*) override;

private:
  std::vector<planning::ContactBand> contacts_;
  std::vector<FoundAngle> found_;
  anatomy::Side side_ = anatomy::Side::right;
};

}  // namespace perilymph::gui
