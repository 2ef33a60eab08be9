#include "perilymph/mechanics/BandSystem.h"

namespace perilymph::mechanics {
namespace {

/// The inverse of a symmetric positive definite block; false if it is not one.
bool invert(const Eigen::Matrix3d& a, Eigen::Matrix3d& inverse) noexcept
{
  const double c00 = a(1, 1) * a(2, 2) - a(1, 2) * a(1, 2);
  const double c01 = a(0, 2) * a(1, 2) - a(0, 1) * a(2, 2);
  const double c02 = a(0, 1) * a(1, 2) - a(0, 2) * a(1, 1);
  const double determinant = a(0, 0) * c00 + a(0, 1) * c01 + a(0, 2) * c02;
  const double minor = a(0, 0) * a(1, 1) - a(0, 1) * a(0, 1);
  if (!(a(0, 0) > 0.0 && minor > 0.0 && determinant > 0.0)) return false;
  const double scale = 1.0 / determinant;
  inverse(0, 0) = c00 * scale;
  inverse(0, 1) = inverse(1, 0) = c01 * scale;
  inverse(0, 2) = inverse(2, 0) = c02 * scale;
  inverse(1, 1) = (a(0, 0) * a(2, 2) - a(0, 2) * a(0, 2)) * scale;
  inverse(1, 2) = inverse(2, 1) = (a(0, 1) * a(0, 2) - a(0, 0) * a(1, 2)) * scale;
  inverse(2, 2) = minor * scale;
  return true;
}

}  // namespace

void BandSystem::clear() noexcept
{
  for (std::size_t j = 0; j < blocks(); ++j) {
    diagonal[j].setZero();
    beside[j].setZero();
    beyond[j].setZero();
    right[j].setZero();
  }
}

bool BandSystem::solve() noexcept
{
  const std::size_t n = blocks();

  // forward: diagonal becomes the inverse pivots, beside and beyond become the factor's blocks
  for (std::size_t j = 0; j < n; ++j) {
    Eigen::Matrix3d pivot = diagonal[j];
    if (j >= 2) {
      const Eigen::Matrix3d factor = beyond[j] * diagonal[j - 2];
      beside[j].noalias() -= beyond[j] * beside[j - 1].transpose();
      pivot.noalias() -= factor * beyond[j].transpose();
      beyond[j] = factor;
      right[j].noalias() -= factor * right[j - 2];
    }
    if (j >= 1) {
      const Eigen::Matrix3d factor = beside[j] * diagonal[j - 1];
      pivot.noalias() -= factor * beside[j].transpose();
      beside[j] = factor;
      right[j].noalias() -= factor * right[j - 1];
    }
    if (!invert(pivot, diagonal[j])) return false;
  }

  // backward
  for (std::size_t j = n; j-- > 0;) {
    Eigen::Vector3d x = diagonal[j] * right[j];
    if (j + 1 < n) x.noalias() -= beside[j + 1].transpose() * right[j + 1];
    if (j + 2 < n) x.noalias() -= beyond[j + 2].transpose() * right[j + 2];
    right[j] = x;
  }
  return true;
}

}  // namespace perilymph::mechanics
