// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Simulates low memory in the thread of a test.

#include <cstddef>

namespace perilymph::test {

/// During its lifetime, `new` of more than `maxBytes` at once throws std::bad_alloc in this thread.
class AllocationLimit {
public:
  explicit AllocationLimit(std::size_t maxBytes) noexcept;
  ~AllocationLimit();
  AllocationLimit(const AllocationLimit&) = delete;
  AllocationLimit& operator=(const AllocationLimit&) = delete;
};

}  // namespace perilymph::test
