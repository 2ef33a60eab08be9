// SPDX-License-Identifier: BSD-3-Clause
#include "solver/BandFactors.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace perilymph::mechanics {
namespace {

/// A random symmetric positive definite band system and the same as a dense matrix.
struct Pair {
  explicit Pair(std::size_t blocks) : band(blocks), factors(blocks)
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
        setBlock(j, k, block);
        const auto row = static_cast<Eigen::Index>(3 * j);
        const auto column = static_cast<Eigen::Index>(3 * k);
        dense.block<3, 3>(row, column) = block;
        dense.block<3, 3>(column, row) = block.transpose();
      }
    }
    for (Eigen::Index a = 0; a < n; ++a) right[a] = number(random);
  }
  void setBlock(std::size_t row, std::size_t column, const Eigen::Matrix3d& b)
  {
    if (row == column) {
      band.diagonal.set(row, {b(0, 0), b(0, 1), b(0, 2), b(1, 1), b(1, 2), b(2, 2)});
      return;
    }
    Blocks& blocks = row == column + 1 ? band.beside : band.beyond;
    blocks.set(row,
               {b(0, 0), b(0, 1), b(0, 2), b(1, 0), b(1, 1), b(1, 2), b(2, 0), b(2, 1), b(2, 2)});
  }
  /// Solution of the band system for the right-hand side, as one column.
  Eigen::VectorXd solution(const Eigen::VectorXd& forRight)
  {
    std::vector<Eigen::Vector3d> blocks(band.blocks());
    for (std::size_t j = 0; j < blocks.size(); ++j)
      blocks[j] = forRight.segment<3>(static_cast<Eigen::Index>(3 * j));
    factors.solve(blocks);
    Eigen::VectorXd result(right.size());
    for (std::size_t j = 0; j < blocks.size(); ++j)
      result.segment<3>(static_cast<Eigen::Index>(3 * j)) = blocks[j];
    return result;
  }
  BandMatrix band;
  BandFactors factors;
  Eigen::MatrixXd dense;
  Eigen::VectorXd right;
};

// The chain is eliminated from both ends until one to three blocks are left: these lengths include
// every remainder.
constexpr std::size_t lengths[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 40, 41};

TEST(BandFactors, SolvesLikeADenseFactorization)
{
  for (const std::size_t blocks : lengths) {
    Pair pair(blocks);
    const Eigen::VectorXd expected = pair.dense.ldlt().solve(pair.right);
    ASSERT_TRUE(pair.factors.factorize(pair.band));
    EXPECT_LT((pair.solution(pair.right) - expected).cwiseAbs().maxCoeff(), 1e-13) << blocks;
  }
}

TEST(BandFactors, SolvesAgainWithTheSameFactors)
{
  Pair pair(12);
  ASSERT_TRUE(pair.factors.factorize(pair.band));
  pair.solution(pair.right);
  // the factors are separate from the matrix
  pair.band = BandMatrix(12);
  const Eigen::VectorXd other = pair.right.reverse();
  const Eigen::VectorXd expected = pair.dense.ldlt().solve(other);
  EXPECT_LT((pair.solution(other) - expected).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(BandFactors, KeepsAHeldBlockWhereItIs)
{
  for (const std::size_t blocks : lengths) {
    Pair pair(blocks);
    pair.band.holdFirst();
    const auto rest = static_cast<Eigen::Index>(3 * (blocks - 1));
    Eigen::VectorXd right = pair.right;
    right.head<3>().setZero();
    ASSERT_TRUE(pair.factors.factorize(pair.band));
    const Eigen::VectorXd found = pair.solution(right);
    EXPECT_EQ(found.head<3>(), Eigen::Vector3d::Zero()) << blocks;
    if (rest == 0) continue;
    const Eigen::VectorXd expected =
        pair.dense.bottomRightCorner(rest, rest).ldlt().solve(right.tail(rest));
    EXPECT_LT((found.tail(rest) - expected).cwiseAbs().maxCoeff(), 1e-13) << blocks;
  }
}

TEST(BandFactors, SaysWhenItIsNotPositiveDefinite)
{
  for (const std::size_t blocks : lengths)
    for (std::size_t bad = 0; bad < blocks; ++bad) {
      Pair pair(blocks);
      pair.band.diagonal.add(bad, {-60.0, 0.0, 0.0, -60.0, 0.0, -60.0});
      EXPECT_FALSE(pair.factors.factorize(pair.band)) << bad << " of " << blocks;
    }
}

}  // namespace
}  // namespace perilymph::mechanics
