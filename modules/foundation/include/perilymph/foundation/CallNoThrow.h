// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Converts exceptions to errors: an exception that leaves a thread would terminate the program.

#include <string>
#include <type_traits>

#include "perilymph/foundation/Result.h"

namespace perilymph {

/// The Error for the exception being handled. Call only inside a catch block.
///
/// @param subject  Beginning of the message: "The recording a.insertion".
Error currentExceptionError(const std::string& subject) noexcept;

/// Calls `work`, which returns a Result. An exception that leaves it becomes the Result's Error.
/// Every worker thread runs its work through this function.
template <class Work>
std::invoke_result_t<Work&> callNoThrow(const std::string& subject, Work&& work) noexcept
{
  try {
    return work();
  } catch (...) {
    return currentExceptionError(subject);
  }
}

}  // namespace perilymph
