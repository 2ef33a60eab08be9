// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What a plan is made of.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/anatomy/Approach.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::planning {

/// Nodes of the array and time step of a plan's insertions: a longer step than the scenario's, a third
/// of the time. How far they are from 400 nodes and 1 ms: guide, `clinical.md` (test/physics/ends). The
/// bands: test/physics/plan.
struct Resolution {
  int nodes = 100;
  Duration step = milliseconds(5);  ///< At most 10 ms, which an engine accepts.
};

/// That of a plan; where programs take few draws (see checkDraws()), 40 nodes and 10 ms.
Resolution usualResolution();

/// Input of a plan.
struct PlanRequest {
  anatomy::Patient patient;         ///< With A and B; H and the errors of all three if known.
  std::vector<std::string> arrays;  ///< Shipped names or files.
  std::string scenario = "surgery-flex28";  ///< Defines everything that is neither drawn nor named.
  std::optional<std::string> friction;      ///< Shipped name or file; without it, the scenario's.
  /// Without one, the scenario's. Draws deviate from it.
  std::optional<anatomy::Approach> approach;
  /// File of a clinic's resistance (ResistanceGrid.h): the depth is also given by simulations weighted with
  /// it. Everything else stays as without it.
  std::optional<std::string> clinicResistance;
  std::size_t draws = 64;  ///< At most.
  /// Whether fewer draws are run if the bands stand earlier (see hasConverged()).
  bool stopsEarly = true;
  std::uint64_t seed = 1;
  /// Without one, the scenario's own nodes and time step.
  std::optional<Resolution> resolution = usualResolution();
  unsigned jobs = 0;  ///< Threads; 0: one per processor. Does not affect the plan.
};

/// The scenario of a request with one of its arrays.
///
/// @param stopTravel_mm  Decimal text, such as session::anyStopTravel until the array's is known.
Result<session::Scenario> scenarioOf(const PlanRequest& request, const std::string& array,
                                     const std::string& stopTravel_mm);

/// Smallest and largest number of draws. The extremes of 16 hold 88 % of what is to come; of 8, 78 %;
/// what is called a band has more (fewestForBand in PlanSummary.h).
inline constexpr std::size_t fewestDraws = 16, maxDraws = 4096;
/// Refuses numbers of draws that no user is offered. makePlan() itself takes one draw: a window shows
/// first bands of few, and tests are cheap. Programs take few if PERILYMPH_FEW_DRAWS is set, which
/// their results name (Version.h).
Result<void> checkDraws(std::size_t draws);
/// Number of draws where a user names none. A clinic's resistance weights them, so that they must amount to
/// fewestEffective (ResistanceGrid.h).
std::size_t usualDraws(bool hasClinicResistance);
}  // namespace perilymph::planning
