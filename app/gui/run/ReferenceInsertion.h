// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A recorded insertion that is shown behind the next ones: its curve in the chart, its array in the
// 3D view.

#include <Eigen/Core>
#include <QString>
#include <QStringList>
#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/session/Playback.h"
#include "perilymph/session/SessionLibrary.h"

namespace perilymph::gui {

/// The array of a recording while it was inserted for the first time.
struct ReferenceShapes {
  struct Shape {
    double depth = 0.0;                    ///< [m]
    std::vector<Eigen::Vector3d> nodes_W;  ///< [m], base first.
  };
  electrode::ArrayDesign array;
  std::vector<Shape> shapes;  ///< In order of depth.

  /// The nodes at a depth [m], linearly interpolated; those at the nearest recorded depth outside;
  /// none without shapes.
  std::vector<Eigen::Vector3d> nodesAt(double depth) const;
};

struct ReferenceInsertion {
  QString name;
  session::ScenarioSubject subject;
  std::vector<std::pair<Length, Force>> curve;         ///< Force over travel.
  std::shared_ptr<const ReferenceShapes> shapes = {};  ///< Null if only the curve is known.
};

/// Recomputes the shapes of a recording every 0.1 mm of depth; takes some seconds. `stop` ends it
/// early, with an error.
Result<std::shared_ptr<const ReferenceShapes>> readShapes(const std::filesystem::path& file,
                                                          const std::stop_token& stop);

/// How a reference differs from what is inserted now: "another array (FLEX28), another cochlea";
/// empty if it does not.
QString differenceText(const ReferenceInsertion& reference,
                       const session::ScenarioSubject& current);

}  // namespace perilymph::gui
