#pragma once

// The boundary where exceptions end: one that leaves a thread ends the program.

#include <string>
#include <type_traits>

#include "perilymph/foundation/Result.h"

namespace perilymph {

/// The Error for the exception that is being handled. Only inside a catch block.
///
/// @param subject  What could not be done, as the sentence begins: "The recording a.insertion".
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
