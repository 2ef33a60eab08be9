#pragma once

#include <cstdint>

namespace perilymph::test {

/// Counts what the calling thread asks of the heap while the guard lives.
///
/// It watches malloc and its kin themselves, not operator new: Eigen and C code use malloc
/// directly. Linking a test to this library puts the counting functions in front of the C
/// library's. Other threads are not counted.
///
///     const AllocationGuard guard;
///     rig.tick();
///     EXPECT_EQ(guard.allocations(), 0u);
class AllocationGuard {
public:
  /// False under sanitizers, which bring a heap of their own. A test that needs the guard then
  /// skips: `if (!AllocationGuard::isAvailable()) GTEST_SKIP() << AllocationGuard::whyNot();`
  static bool isAvailable() noexcept;
  /// A sentence for the skipped test; empty while the guard is available.
  static const char* whyNot() noexcept;

  AllocationGuard() noexcept;
  AllocationGuard(const AllocationGuard&) = delete;
  AllocationGuard& operator=(const AllocationGuard&) = delete;

  /// Blocks asked for since the guard was made: malloc, calloc, realloc, reallocarray,
  /// aligned_alloc, posix_memalign, memalign.
  std::uint64_t allocations() const noexcept;
  /// Blocks given back since the guard was made; freeing a null pointer does not count.
  std::uint64_t frees() const noexcept;

private:
  std::uint64_t allocationsBefore_;
  std::uint64_t freesBefore_;
};

}  // namespace perilymph::test
