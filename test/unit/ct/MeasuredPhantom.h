// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A phantom and what is measured in it, once for all cases of a suite.

#include <stdexcept>

#include "perilymph/ct/Measures.h"
#include "perilymph/test/CtPhantom.h"

namespace perilymph::ct {

inline MeasureRequest clickedInto(const test::CtPhantom& phantom, std::uint64_t seed)
{
  MeasureRequest request;
  request.click_P = test::jitteredClick(phantom, seed);
  return request;
}

inline const test::CtPhantom& phantom()
{
  static const test::CtPhantom built = test::makeCtPhantom(501, test::highResolutionScan());
  return built;
}

inline const CochleaMeasures& measures()
{
  static const auto found = measureCochlea(phantom().volume, clickedInto(phantom(), 501));
  if (!found) throw std::runtime_error(found.error().message);
  return *found;
}

}  // namespace perilymph::ct
