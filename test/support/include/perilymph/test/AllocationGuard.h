// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace perilymph::test {

/// Counts the heap allocations of the calling thread during its lifetime.
///
/// It intercepts malloc and related functions, not operator new: Eigen and C code call malloc
/// directly. Linking a test to this library interposes counting functions before the C library's.
/// Other threads are not counted.
///
///     const AllocationGuard guard;
///     rig.tick();
///     EXPECT_EQ(guard.allocations(), 0u);
class AllocationGuard {
public:
  /// False under sanitizers, which have their own heap. A test that needs the guard then skips: `if
  /// (!AllocationGuard::isAvailable()) GTEST_SKIP() << AllocationGuard::whyNot();`
  static bool isAvailable() noexcept;
  /// Message of the skipped test; empty if the guard is available.
  static const char* whyNot() noexcept;

  AllocationGuard() noexcept;
  AllocationGuard(const AllocationGuard&) = delete;
  AllocationGuard& operator=(const AllocationGuard&) = delete;

  /// Blocks allocated since construction by malloc, calloc, realloc, reallocarray, aligned_alloc,
  /// posix_memalign or memalign.
  std::uint64_t allocations() const noexcept;
  /// Blocks freed since construction; null pointers do not count.
  std::uint64_t frees() const noexcept;

private:
  std::uint64_t allocationsBefore_;
  std::uint64_t freesBefore_;
};

}  // namespace perilymph::test
