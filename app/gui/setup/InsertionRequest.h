// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a page requests to be inserted.

#include <optional>

#include "gui/run/PlannedForce.h"
#include "gui/setup/Setup.h"

namespace perilymph::gui {

/// What follows after another setup was loaded, whose cochlea is built meanwhile.
enum class AfterLoading { rest, insert };

/// A setup to be shown on the insertion page.
struct InsertionRequest {
  Setup setup;
  SetupOrigin::Kind kind = SetupOrigin::Kind::own;
  AfterLoading then = AfterLoading::rest;
  /// Force expected by a plan; without it that of the last plan remains.
  std::optional<PlannedForce> plan = {};
};

}  // namespace perilymph::gui
