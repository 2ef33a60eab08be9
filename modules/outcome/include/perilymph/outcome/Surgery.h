// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the surgeon knows about an insertion and no CT shows: asked once, every answer may be left out.

#include <array>
#include <optional>
#include <string>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Choice.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::outcome {

/// Why the surgeon stopped.
enum class StopReason { unknown, mark, resistance, buckling, hearing, bleeding, other };
inline constexpr std::array stopReasons{
    Choice<StopReason>{StopReason::unknown, "unknown", "it is not known"},
    Choice<StopReason>{StopReason::mark, "mark", "the intended mark was reached"},
    Choice<StopReason>{StopReason::resistance, "resistance", "resistance was felt"},
    Choice<StopReason>{StopReason::buckling, "buckling", "the array bowed outside"},
    Choice<StopReason>{StopReason::hearing, "hearing", "to preserve hearing"},
    Choice<StopReason>{StopReason::bleeding, "bleeding", "bleeding"},
    Choice<StopReason>{StopReason::other, "other", "another reason"}};

/// The opening through which the array was inserted.
enum class Opening { unknown, roundWindow, extendedRoundWindow, cochleostomy };
inline constexpr std::array openings{
    Choice<Opening>{Opening::unknown, "unknown"},
    Choice<Opening>{Opening::roundWindow, "round-window"},
    Choice<Opening>{Opening::extendedRoundWindow, "extended-round-window"},
    Choice<Opening>{Opening::cochleostomy, "cochleostomy"}};

/// What held the array.
enum class Tool { unknown, forceps, sheath, stylet, advanceOffStylet, robot };
inline constexpr std::array tools{Choice<Tool>{Tool::unknown, "unknown"},
                                  Choice<Tool>{Tool::forceps, "forceps"},
                                  Choice<Tool>{Tool::sheath, "sheath"},
                                  Choice<Tool>{Tool::stylet, "stylet"},
                                  Choice<Tool>{Tool::advanceOffStylet, "advance-off-stylet"},
                                  Choice<Tool>{Tool::robot, "robot"}};

/// One insertion as its surgeon describes it. What is not known is absent.
struct Surgery {
  std::string array;  ///< Shipped name: "flex28".
  std::string
      lot;  ///< The array's lot number; up to 24 letters, digits, hyphens; never a patient's number.
  Opening opening = Opening::unknown;
  Tool tool = Tool::unknown;
  std::string lubricant;                     ///< "saline", "hyaluronate"; up to 40 characters.
  std::optional<double> tilt_deg, turn_deg;  ///< Approach, as in scenarios.
  /// Depth of the tip past the opening that was intended before the insertion.
  std::optional<Length> intendedDepth;
  std::optional<int> intendedContacts;  ///< Number of contacts that were to be inside.
  std::optional<bool> isMarkReached;
  std::optional<Length> outside;  ///< Length of the array's insertable part that stayed outside.
  std::optional<int> contactsOutside;  ///< Contacts seen outside the opening.
  StopReason stopReason = StopReason::unknown;
  std::optional<int>
      contactAtResistance;  ///< Number of the contact (1 at the tip) at the opening at first resistance.
  std::optional<int> attempts, pullBacks;
  std::optional<int> daysToCt;  ///< From surgery to the CT.

  friend bool operator==(const Surgery&, const Surgery&) = default;
};

/// Refuses values that no surgery has, with a sentence.
Result<void> checkSurgery(const Surgery& surgery);
/// Refuses those that no surgery with an array has: more contacts than it has, a depth beyond its length.
Result<void> checkSurgery(const Surgery& surgery, const electrode::ArrayDesign& array);

}  // namespace perilymph::outcome
