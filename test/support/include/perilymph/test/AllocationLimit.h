#pragma once

// Little memory, for the thread of a test alone.

#include <cstddef>

namespace perilymph::test {

/// While it lives, `new` of more than `maxBytes` at once throws std::bad_alloc in this thread.
class AllocationLimit {
public:
  explicit AllocationLimit(std::size_t maxBytes) noexcept;
  ~AllocationLimit();
  AllocationLimit(const AllocationLimit&) = delete;
  AllocationLimit& operator=(const AllocationLimit&) = delete;
};

}  // namespace perilymph::test
