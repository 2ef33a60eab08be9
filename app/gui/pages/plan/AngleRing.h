// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The angles of an array's contacts around the modiolus.

#include <QWidget>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/planning/PlanResult.h"

namespace perilymph::gui {

/// A spiral from the round window on, as seen from the apex. Contacts are dots at their median
/// angles with arcs from 5 to 95 %; a left ear is mirrored.
class AngleRing : public QWidget {
  Q_OBJECT
public:
  explicit AngleRing(QWidget* parent);

  void show(const std::vector<planning::ContactBand>& contacts, anatomy::Side side);
  QSize minimumSizeHint() const override { return {160, 150}; }

protected:
  void paintEvent(QPaintEvent*) override;

private:
  std::vector<planning::ContactBand> contacts_;
  anatomy::Side side_ = anatomy::Side::right;
};

}  // namespace perilymph::gui
