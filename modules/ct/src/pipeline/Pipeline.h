// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The measurement of a cochlea in a CT: find it, fit it, derive its measures.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "CoarseSearch.h"
#include "ImageFit.h"
#include "LumenShape.h"
#include "MarkConstraint.h"
#include "MeanLumen.h"
#include "perilymph/ct/Measures.h"

namespace perilymph::ct {

/// One measurement; its stages are declared in the order in which run() calls them. Each ends early,
/// with an error, when the request is stopped.
class Pipeline {
public:
  Pipeline(const CtVolume& volume, const MeasureRequest& request, const MeanLumen& mean);

  /// All stages (measure.cpp).
  Result<CochleaMeasures> run();

private:
  // 1. Finding (find.cpp).

  struct Start {
    Candidate candidate;
    double bone, lumen;
  };
  /// The best start after a short fit, and the best of the other handedness at any place.
  struct Choice {
    FitResult best, mirrored;
  };
  /// Finds places, then poses, and chooses among them.
  ///
  /// @param elsewhere_P  A cochlea that is found already; places near it are left out.
  Result<Choice> choose(const std::optional<Eigen::Vector3d>& elsewhere_P) const;
  /// Poses near the click, or near hollows of the whole volume, best first.
  Result<std::vector<Start>> starts(const std::optional<Eigen::Vector3d>& elsewhere_P) const;
  /// Poses near one point, for every possible level of the lumen.
  std::vector<Start> searchAt(const Eigen::Vector3d& place_P, double reach_mm, std::size_t count,
                              Threads threads) const;
  /// Starts where round window, modiolus and apex were placed, at the levels of the best starts.
  void addMarkedStarts(std::vector<Start>& found) const;
  /// The starts that the request gives.
  void addGivenStarts(std::vector<Start>& found) const;
  /// A short fit from every start; keeps the best, and the best of the other handedness.
  Result<Choice> chooseStart(const std::vector<Start>& from) const;
  struct Scored {
    FitResult fit;
    double score = 2.0;  ///< The misfit, more if the fit is far from the landmarks.
  };
  Scored scored(FitResult fit) const;
  /// Looks for a cochlea of the other winding in the rest of the volume, and takes it if the first
  /// one winds as in the ear that is not asked for. The winding tells the ears apart in a volume of
  /// any size.
  void considerOther(Choice& choice);

  // 2. Fitting (fit.cpp).

  /// The fit of pose, shape, levels and blur. In each round the voxels are selected again, because the wall
  /// has moved.
  Result<FitResult> refined(FitResult start) const;
  /// The fit under the constraints of the landmarks; of those that the voxels contradict, gross
  /// errors are excluded.
  FitResult corrected(FitResult free) const;
  /// Goes on with a finished fit under the constraints of the landmarks.
  FitResult steered(const FitResult& free, GrossError grossError) const;

  // 3. Measures, errors and flags (assemble.cpp).

  Result<CochleaMeasures> measured(const FitResult& best, const FitResult& mirrored) const;

  /// Half-widths of the blur in plane and across that a volume of this spacing has [mm].
  static Eigen::Vector2d blurGuess(const CtVolume& volume);
  static Eigen::Vector3d middleOf(const FitResult& fit)
  {
    return fit.state.pose.outOf_W({0.0, 0.0, 1.0});
  }
  static Error canceled() { return Error{"The measurement was canceled."}; }
  bool isStopped() const { return request_.stop.stop_requested(); }
  void report(double fraction) const
  {
    if (request_.onProgress && !isQuiet_) request_.onProgress(fraction);
  }

  const CtVolume& volume_;
  const MeasureRequest& request_;
  LumenShape family_;
  Template points_;
  ImageFit fit_;
  Eigen::Vector3d axis_W_;                  ///< The clinical axis.
  std::optional<Eigen::Vector3d> other_P_;  ///< In a second cochlea.
  bool isQuiet_ = false;                    ///< Progress is not reported.
};

}  // namespace perilymph::ct
