// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/KeyImage.h"

#include <cmath>

#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

std::filesystem::path keyImageFile(const anatomy::Patient& patient)
{
  Sha256 hash;
  const auto addLength = [&hash](Length length) {
    hash.add(static_cast<std::uint64_t>(std::lround(1e3 * inMillimeters(length))));
  };
  if (patient.basalTurn) {
    addLength(patient.basalTurn->a);
    addLength(patient.basalTurn->b);
    addLength(patient.basalTurn->h.value_or(Length{}));
  }
  constexpr std::size_t digits = 16;
  return patientFolder() / "key-images" /
         (patient.label + "-" + anatomy::nameOf(patient.side) + "-" + hash.hex().substr(0, digits) +
          ".png");
}

}  // namespace perilymph::gui
