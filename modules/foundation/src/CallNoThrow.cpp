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
      return Error{subject +
                   " needs more memory than is available. Close other programs and try again."};
    } catch (const std::exception& thrown) {
      return Error{subject + " failed: " + thrown.what() + "."};
    } catch (...) {
      return Error{subject + " failed for an unknown reason."};
    }
  } catch (...) {
    return Error{"Out of memory."};  // short enough to need no allocation
  }
}

}  // namespace perilymph
