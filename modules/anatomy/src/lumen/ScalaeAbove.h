// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>

#include "perilymph/anatomy/ScalaTympani.h"

namespace perilymph::anatomy {

/// The ducts above a scala tympani, built once for all arrays that are inserted into it.
class ScalaeAbove {
public:
  static ScalaeAbove& of(const ScalaTympani& scala) { return *scala.above_; }

  std::shared_ptr<const ScalaTympani> vestibuli(const ScalaTympani& scala)
  {
    std::call_once(hasVestibuli_, [&] { vestibuli_ = buildVestibuli(scala); });
    return vestibuli_;
  }
  std::shared_ptr<const ScalaTympani> both(const ScalaTympani& scala)
  {
    std::call_once(hasBoth_, [&] { both_ = buildBoth(scala); });
    return both_;
  }

private:
  static std::shared_ptr<const ScalaTympani> buildVestibuli(const ScalaTympani& scala);
  static std::shared_ptr<const ScalaTympani> buildBoth(const ScalaTympani& scala);

  std::once_flag hasVestibuli_, hasBoth_;
  std::shared_ptr<const ScalaTympani> vestibuli_, both_;
};

}  // namespace perilymph::anatomy
