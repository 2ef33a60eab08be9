// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A recorded insertion whose curve is shown behind the next ones.

#include <QString>
#include <QStringList>
#include <utility>
#include <vector>

#include "perilymph/foundation/Units.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

struct ReferenceInsertion {
  QString name;
  session::ScenarioSubject subject;
  std::vector<std::pair<Length, Force>> curve;  ///< Force over travel.
};

/// How a reference differs from what is inserted now: "another array (FLEX28), another cochlea";
/// empty if it does not.
QString differenceText(const ReferenceInsertion& reference,
                       const session::ScenarioSubject& current);

}  // namespace perilymph::gui
