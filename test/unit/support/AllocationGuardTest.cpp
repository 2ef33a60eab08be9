// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/AllocationGuard.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

namespace perilymph::test {
namespace {

/// Prevents the compiler from removing an unused block.
void use(void* block) { asm volatile("" : : "g"(block) : "memory"); }

TEST(AllocationGuard, SeesNothingWhereNothingIsAllocated)
{
  if (!AllocationGuard::isAvailable()) GTEST_SKIP() << AllocationGuard::whyNot();

  const AllocationGuard guard;
  double sum = 0.0;
  for (int i = 0; i < 1000; ++i) sum += Eigen::Vector3d(i, 1, 2).norm();
  use(&sum);
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST(AllocationGuard, SeesEigenAllocations)
{
  if (!AllocationGuard::isAvailable()) GTEST_SKIP() << AllocationGuard::whyNot();

  const AllocationGuard guard;
  Eigen::VectorXd vector = Eigen::VectorXd::Zero(100);
  use(vector.data());
  EXPECT_EQ(guard.allocations(), 1u);
}

TEST(AllocationGuard, SeesVectorsAndNew)
{
  if (!AllocationGuard::isAvailable()) GTEST_SKIP() << AllocationGuard::whyNot();

  const AllocationGuard guard;
  const std::vector<double> numbers(100, 1.0);
  const auto number = std::make_unique<double>(2.0);
  use(const_cast<double*>(numbers.data()));
  use(number.get());
  EXPECT_EQ(guard.allocations(), 2u);
}

TEST(AllocationGuard, SeesEveryWayToAskTheCLibrary)
{
  if (!AllocationGuard::isAvailable()) GTEST_SKIP() << AllocationGuard::whyNot();

  const AllocationGuard guard;
  void* blocks[6] = {std::malloc(10), std::calloc(2, 10), std::aligned_alloc(64, 128)};
  use(blocks[0]);
  blocks[3] = std::realloc(std::malloc(10), 100000);
  ASSERT_EQ(posix_memalign(&blocks[4], 64, 100), 0);
  blocks[5] = reallocarray(nullptr, 3, 8);
  const std::uint64_t seen = guard.allocations();
  for (void* block : blocks) {
    use(block);
    std::free(block);
  }
  EXPECT_EQ(seen, 7u);
}

TEST(AllocationGuard, SeesWhatIsGivenBackButNotNullPointers)
{
  if (!AllocationGuard::isAvailable()) GTEST_SKIP() << AllocationGuard::whyNot();

  void* const block = std::malloc(10);
  use(block);
  void* nothing = nullptr;
  use(&nothing);
  const AllocationGuard guard;
  std::free(block);
  std::free(nothing);
  EXPECT_EQ(guard.frees(), 1u);
}

TEST(AllocationGuard, CountsTheCallingThreadOnly)
{
  if (!AllocationGuard::isAvailable()) GTEST_SKIP() << AllocationGuard::whyNot();

  std::thread other;
  std::uint64_t seenByOther = 0;
  const auto work = [&seenByOther] {
    const AllocationGuard guard;
    for (int i = 0; i < 100; ++i) {
      void* const block = std::malloc(10);
      use(block);
      std::free(block);
    }
    seenByOther = guard.allocations();
  };
  other = std::thread(work);
  const AllocationGuard guard;
  other.join();
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_EQ(seenByOther, 100u);
}

TEST(AllocationGuard, BlocksAreAlignedAndRefusedAsTheStandardSays)
{
  if (!AllocationGuard::isAvailable()) GTEST_SKIP() << AllocationGuard::whyNot();

  void* block = nullptr;
  EXPECT_EQ(posix_memalign(&block, 3, 10), EINVAL);
  const volatile std::size_t tooMany = SIZE_MAX / 2;
  EXPECT_EQ(reallocarray(nullptr, tooMany, 3), nullptr);
  ASSERT_EQ(posix_memalign(&block, 4096, 10), 0);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % 4096, 0u);
  std::free(block);
}

TEST(AllocationGuard, SaysWhyWhereItCannotCount)
{
  EXPECT_NE(AllocationGuard::isAvailable(), *AllocationGuard::whyNot() != '\0');
}

}  // namespace
}  // namespace perilymph::test
