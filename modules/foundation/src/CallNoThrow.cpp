// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/CallNoThrow.h"

#include <exception>
#include <new>

namespace perilymph {

Error currentExceptionError(const std::string& subject) noexcept
{
  try {
    try {
      throw;
    } catch (const std::bad_alloc&) {
      return Error{"%1 needs more memory than is available. Close other programs and try again.",
                   subject};
    } catch (const std::exception& thrown) {
      return Error{"%1 failed: %2.", subject, thrown.what()};
    } catch (...) {
      return Error{"%1 failed for an unknown reason.", subject};
    }
  } catch (...) {
    return Error{"Out of memory."};  // short enough to need no allocation
  }
}

}  // namespace perilymph
