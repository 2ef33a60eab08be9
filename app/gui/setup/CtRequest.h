// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the page CT is asked for by another page.

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/session/PatientRecord.h"

namespace perilymph::gui {

/// A CT for a patient.
struct CtRequest {
  QString code;  ///< The patient's; may be empty.
  std::string series =
      {};  ///< SHA-256 of the series to be opened again; empty: the user opens one.
  /// Where the cochlea was measured in that series; those by hand are placed again.
  std::vector<session::PatientLandmark> landmarks = {};
  std::optional<anatomy::Side> side = {};  ///< The patient's ear, looked for in that series.
};

}  // namespace perilymph::gui
