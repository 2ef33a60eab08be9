#include "perilymph/mechanics/BandSystem.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace perilymph::mechanics {
namespace {

/// A random symmetric positive definite band system and the same as a dense matrix.
struct Pair {
  explicit Pair(std::size_t blocks) : band(blocks)
  {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const auto n = static_cast<Eigen::Index>(3 * blocks);
    dense = Eigen::MatrixXd::Zero(n, n);
    right = Eigen::VectorXd::Zero(n);
    for (std::size_t j = 0; j < blocks; ++j) {
      for (std::size_t k = j >= 2 ? j - 2 : 0; k <= j; ++k) {
        Eigen::Matrix3d block;
        for (int a = 0; a < 9; ++a) block(a / 3, a % 3) = number(random);
        if (k == j) block = block + block.transpose() + 20.0 * Eigen::Matrix3d::Identity();
        band.add(j, k, block);
        const auto row = static_cast<Eigen::Index>(3 * j);
        const auto column = static_cast<Eigen::Index>(3 * k);
        dense.block<3, 3>(row, column) = block;
        dense.block<3, 3>(column, row) = block.transpose();
      }
      for (int a = 0; a < 3; ++a) {
        band.right[j][a] = number(random);
        right[static_cast<Eigen::Index>(3 * j) + a] = band.right[j][a];
      }
    }
  }
  BandSystem band;
  Eigen::MatrixXd dense;
  Eigen::VectorXd right;
};

TEST(BandSystem, SolvesLikeADenseFactorization)
{
  for (const std::size_t blocks : {1u, 2u, 3u, 4u, 40u}) {
    Pair pair(blocks);
    const Eigen::VectorXd expected = pair.dense.ldlt().solve(pair.right);
    ASSERT_TRUE(pair.band.solve());
    for (std::size_t j = 0; j < blocks; ++j)
      for (int a = 0; a < 3; ++a)
        EXPECT_NEAR(pair.band.right[j][a], expected[static_cast<Eigen::Index>(3 * j) + a], 1e-13);
  }
}

TEST(BandSystem, SaysWhenItIsNotPositiveDefinite)
{
  Pair pair(6);
  pair.band.diagonal[3] -= 60.0 * Eigen::Matrix3d::Identity();
  EXPECT_FALSE(pair.band.solve());
}

}  // namespace
}  // namespace perilymph::mechanics
