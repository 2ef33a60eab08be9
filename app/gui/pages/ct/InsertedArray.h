// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// An insertion in the measured cochlea, in the frame of the CT.

#include "gui/pages/ct/CtStudy.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/imaging/PlanFiles.h"

namespace perilymph::gui {

/// The array of a snapshot in the CT, with the line that it was pushed along; empty if a node is not finite.
CtStudy::InsertedArray insertedArray(const ct::CochleaMeasures& measures,
                                     const electrode::ArrayDesign& design,
                                     const anatomy::ScalaTympani& scala,
                                     const anatomy::Approach& approach,
                                     const haptics::Snapshot& now);

/// What a study has for other programs: landmarks, axis, and the inserted array if there is one.
imaging::PlanMarkups planOf(const CtStudy& study);

}  // namespace perilymph::gui
