// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where the bone of a picture is from, and what it is if there is none.

#include <QString>
#include <functional>
#include <memory>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/visualization/BoneLayer.h"

namespace perilymph::gui {

/// Bone of the CT in which a patient's cochlea was measured, in frame W; null while it is not open.
using BoneSource =
    std::function<std::shared_ptr<const visualization::BoneModel>(const anatomy::Patient& patient)>;

/// What a cochlea was built from.
enum class CochleaOrigin {
  model,    ///< No patient.
  numbers,  ///< A patient's measures, typed.
  ct        ///< A patient's measures in a CT.
};

/// What the picture shows, in a sentence or two, with the reason where it has no bone.
QString boneNote(bool hasBone, CochleaOrigin origin);

/// How the picture is turned and cut.
QString boneTip();

}  // namespace perilymph::gui
