// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/anatomy/ScalaVestibuli.h"

namespace perilymph::anatomy {

/// The ducts above a scala tympani, built once for all arrays that are inserted into it.
class ScalaeAbove {
public:
  static ScalaeAbove& of(const ScalaTympani& scala) { return *scala.above_; }

  std::shared_ptr<const ScalaTympani> vestibuli(const ScalaTympani& scala)
  {
    std::call_once(hasVestibuli_, [&] { vestibuli_ = buildVestibuli(scala, heights(scala)); });
    return vestibuli_;
  }
  std::shared_ptr<const ScalaTympani> both(const ScalaTympani& scala)
  {
    std::call_once(hasBoth_, [&] { both_ = buildBoth(scala, heights(scala)); });
    return both_;
  }

private:
  const std::vector<double>& heights(const ScalaTympani& scala)
  {
    std::call_once(hasHeights_, [&] { heights_ = partitionHeights(scala); });
    return heights_;
  }
  /// @param partition  Heights of the partition at the sections of the tables [m].
  static std::shared_ptr<const ScalaTympani> buildVestibuli(const ScalaTympani& scala,
                                                            const std::vector<double>& partition);
  static std::shared_ptr<const ScalaTympani> buildBoth(const ScalaTympani& scala,
                                                       const std::vector<double>& partition);

  std::once_flag hasHeights_, hasVestibuli_, hasBoth_;
  std::vector<double> heights_;
  std::shared_ptr<const ScalaTympani> vestibuli_, both_;
};

}  // namespace perilymph::anatomy
