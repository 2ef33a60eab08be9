// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The array of a reference insertion in the 3D view.

#include <optional>

#include "gui/run/ReferenceInsertion.h"

namespace perilymph::gui {

class OperationView;

/// Shows a reference's array at the depth of the current one, in the same cochlea only.
class GhostControl {
public:
  explicit GhostControl(OperationView& view) : view_(view) {}

  void setReference(const std::optional<ReferenceInsertion>& reference);
  /// The view has another scene, of this insertion.
  void setCurrent(const session::ScenarioSubject& current);
  /// Moves the array to a depth [m].
  void follow(double depth);

private:
  bool isShown() const;
  void draw();

  OperationView& view_;
  std::optional<ReferenceInsertion> reference_;
  session::ScenarioSubject current_;
  double depth_ = 0.0;  ///< [m]
};

}  // namespace perilymph::gui
