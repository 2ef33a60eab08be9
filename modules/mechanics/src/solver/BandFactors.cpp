// SPDX-License-Identifier: BSD-3-Clause
#include "solver/BandFactors.h"

#include "lanes/Lanes.h"
#include "perilymph/foundation/Hash.h"

namespace perilymph::mechanics {
namespace {

/// Column k of the matrix, from the diagonal down.
template <class T>
struct MatrixColumn {
  SymmetricBlock<T> diagonal;
  Block<T> beside;
  Block<T> beyond;
};

/// Contribution of eliminated columns to the next two.
template <class T>
struct EliminatedRows {
  SymmetricBlock<T> diagonal;      ///< Diagonal block of the next column.
  Block<T> beside;                 ///< Block below the diagonal of the next column.
  SymmetricBlock<T> nextDiagonal;  ///< Diagonal block of the column after it.
};

/// The same for a right-hand side.
template <class T>
struct EliminatedRhs {
  Triple<T> next;
  Triple<T> second;
};

PERILYMPH_IN_LANES bool isPositive(double a) noexcept { return a > 0.0; }
template <class Wide>
PERILYMPH_IN_LANES bool isPositive(Wide a) noexcept
{
  return a[0] > 0.0 && a[1] > 0.0;
}

/// The inverse of a symmetric block by its cofactors. False, without inverse, if it is not positive
/// definite.
template <class T>
PERILYMPH_IN_LANES bool invert(SymmetricBlock<T>& a) noexcept
{
  const T xx = a.yy * a.zz - a.yz * a.yz;
  const T xy = a.xz * a.yz - a.xy * a.zz;
  const T xz = a.xy * a.yz - a.xz * a.yy;
  const T minor = a.xx * a.yy - a.xy * a.xy;
  const T determinant = a.xx * xx + a.xy * xy + a.xz * xz;
  const bool isDefinite = isPositive(a.xx) && isPositive(minor) && isPositive(determinant);
  const T scale = 1.0 / determinant;
  a = {xx * scale,
       xy * scale,
       xz * scale,
       (a.xx * a.zz - a.xz * a.xz) * scale,
       (a.xy * a.xz - a.xx * a.yz) * scale,
       minor * scale};
  return isDefinite;
}

/// Eliminates one unknown: computes the column of the factors and its contribution to the next two.
template <class T, class Column>
PERILYMPH_IN_LANES bool eliminate(MatrixColumn<T> a, EliminatedRows<T>& taken,
                                  Column& factors) noexcept
{
  a.diagonal -= taken.diagonal;
  a.beside -= taken.beside;
  const bool isDefinite = invert(a.diagonal);
  factors.inverse = a.diagonal;
  factors.beside = product(a.beside, a.diagonal);
  factors.beyond = product(a.beyond, a.diagonal);
  taken.diagonal = taken.nextDiagonal;
  taken.diagonal += symmetricProduct(factors.beside, a.beside);
  taken.beside = productWithTransposed(factors.beyond, a.beside);
  taken.nextDiagonal = symmetricProduct(factors.beyond, a.beyond);
  return isDefinite;
}

template <class T, class Column>
PERILYMPH_IN_LANES void substitute(const Triple<T>& right, EliminatedRhs<T>& taken,
                                   Column& factors) noexcept
{
  factors.solution = right;
  factors.solution -= taken.next;
  taken.next = taken.second;
  taken.next += factors.beside * factors.solution;
  taken.second = factors.beyond * factors.solution;
}

template <class T, class Column>
PERILYMPH_IN_LANES void substituteBack(const Triple<T>& next, const Triple<T>& second,
                                       Column& factors) noexcept
{
  Triple<T> x = factors.inverse * factors.solution;
  x -= transposedTimes(factors.beyond, second);
  x -= transposedTimes(factors.beside, next);
  factors.solution = x;
}

template <class Wide>
PERILYMPH_IN_LANES SymmetricBlock<Wide> pair(const SymmetricBlock<double>& a,
                                             const SymmetricBlock<double>& b) noexcept
{
  return {Wide{a.xx, b.xx}, Wide{a.xy, b.xy}, Wide{a.xz, b.xz},
          Wide{a.yy, b.yy}, Wide{a.yz, b.yz}, Wide{a.zz, b.zz}};
}

/// The block of one chain beside the mirrored block of the other.
template <class Wide>
PERILYMPH_IN_LANES Block<Wide> pairMirrored(const Block<double>& a, const Block<double>& b) noexcept
{
  return {Wide{a.xx, b.xx}, Wide{a.xy, b.yx}, Wide{a.xz, b.zx}, Wide{a.yx, b.xy}, Wide{a.yy, b.yy},
          Wide{a.yz, b.zy}, Wide{a.zx, b.xz}, Wide{a.zy, b.yz}, Wide{a.zz, b.zz}};
}

template <class Wide>
PERILYMPH_IN_LANES Triple<Wide> pair(const Triple<double>& a, const Triple<double>& b) noexcept
{
  return {Wide{a.x, b.x}, Wide{a.y, b.y}, Wide{a.z, b.z}};
}

template <class Wide>
PERILYMPH_IN_LANES SymmetricBlock<double> laneOf(const SymmetricBlock<Wide>& a, int lane) noexcept
{
  return {a.xx[lane], a.xy[lane], a.xz[lane], a.yy[lane], a.yz[lane], a.zz[lane]};
}

template <class Wide>
PERILYMPH_IN_LANES Block<double> laneOf(const Block<Wide>& a, int lane) noexcept
{
  return {a.xx[lane], a.xy[lane], a.xz[lane], a.yx[lane], a.yy[lane],
          a.yz[lane], a.zx[lane], a.zy[lane], a.zz[lane]};
}

template <class Wide>
PERILYMPH_IN_LANES Triple<double> laneOf(const Triple<Wide>& a, int lane) noexcept
{
  return {a.x[lane], a.y[lane], a.z[lane]};
}

Triple<double> tripleOf(const Eigen::Vector3d& v) noexcept { return {v[0], v[1], v[2]}; }
Eigen::Vector3d vectorOf(const Triple<double>& v) noexcept { return {v.x, v.y, v.z}; }

constexpr int fromBase = 0;
constexpr int fromTip = 1;

}  // namespace

BandFactors::BandFactors(std::size_t blocks)
    : blocks_(blocks),
      steps_(blocks > 3 ? (blocks - 2) / 2 : 0),
      left_(blocks - 2 * steps_),
      ends_(steps_),
      middle_(left_)
{
}

bool BandFactors::factorize(const BandMatrix& matrix) noexcept
{
  withLanes([&]() PERILYMPH_KERNEL { factorizeInLanes(matrix); });
  return exist_;
}

PERILYMPH_IN_LANES void BandFactors::factorizeInLanes(const BandMatrix& matrix) noexcept
{
  const auto& [diagonal, beside, beyond, firstIsHeld] = matrix;
  firstIsHeld_ = firstIsHeld;
  bool isDefinite = true;
  EliminatedRows<Lanes> taken{};
  for (std::size_t k = 0; k < steps_; ++k) {
    const std::size_t mirrored = blocks_ - 1 - k;
    const MatrixColumn<Lanes> column{
        pair<Lanes>(load<double>(diagonal, k), load<double>(diagonal, mirrored)),
        pairMirrored<Lanes>(load<double>(beside, k + 1), load<double>(beside, mirrored)),
        pairMirrored<Lanes>(load<double>(beyond, k + 2), load<double>(beyond, mirrored))};
    isDefinite = eliminate(column, taken, ends_[k]) && isDefinite;
  }

  // the chains meet: both contribute to the blocks in the middle
  MatrixColumn<double> middle[3];
  for (std::size_t k = 0; k < left_; ++k) {
    middle[k].diagonal = diagonal[steps_ + k];
    if (k + 1 < left_) middle[k].beside = beside[steps_ + k + 1];
    if (k + 2 < left_) middle[k].beyond = beyond[steps_ + k + 2];
  }
  if (steps_ > 0) {
    middle[left_ - 1].diagonal -= laneOf(taken.diagonal, fromTip);
    middle[left_ - 2].diagonal -= laneOf(taken.nextDiagonal, fromTip);
    middle[left_ - 2].beside -= transposed(laneOf(taken.beside, fromTip));
  }
  EliminatedRows<double> takenBefore{laneOf(taken.diagonal, fromBase),
                                     laneOf(taken.beside, fromBase),
                                     laneOf(taken.nextDiagonal, fromBase)};
  for (std::size_t k = 0; k < left_; ++k)
    isDefinite = eliminate(middle[k], takenBefore, middle_[k]) && isDefinite;
  exist_ = isDefinite;
}

void BandFactors::solve(std::vector<Eigen::Vector3d>& right) noexcept
{
  withLanes([&]() PERILYMPH_KERNEL { solveInLanes(right); });
}

PERILYMPH_IN_LANES void BandFactors::solveInLanes(std::vector<Eigen::Vector3d>& right) noexcept
{
  const std::size_t last = blocks_ - 1;
  Column<Lanes>* ends = ends_.data();
  EliminatedRhs<Lanes> taken{};
  for (std::size_t k = 0; k < steps_; ++k)
    substitute(pair<Lanes>(load<double>(right, k), load<double>(right, last - k)), taken, ends[k]);

  Triple<double> middle[3];
  for (std::size_t k = 0; k < left_; ++k) middle[k] = tripleOf(right[steps_ + k]);
  if (steps_ > 0) {
    middle[left_ - 1] -= laneOf(taken.next, fromTip);
    middle[left_ - 2] -= laneOf(taken.second, fromTip);
  }
  EliminatedRhs<double> takenBefore{laneOf(taken.next, fromBase), laneOf(taken.second, fromBase)};
  for (std::size_t k = 0; k < left_; ++k) substitute(middle[k], takenBefore, middle_[k]);

  Triple<double> next{}, second{};
  for (std::size_t k = left_; k-- > 0;) {
    substituteBack(next, second, middle_[k]);
    second = next;
    next = middle_[k].solution;
    right[steps_ + k] = vectorOf(next);
  }
  if (steps_ == 0) return;
  Triple<Lanes> nextPair = pair<Lanes>(middle_[0].solution, middle_[left_ - 1].solution);
  Triple<Lanes> secondPair = pair<Lanes>(middle_[1].solution, middle_[left_ - 2].solution);
  for (std::size_t k = steps_; k-- > 0;) {
    substituteBack(nextPair, secondPair, ends[k]);
    secondPair = nextPair;
    nextPair = ends[k].solution;
    store(laneOf(nextPair, fromBase), right, k);
    store(laneOf(nextPair, fromTip), right, last - k);
  }
}

void BandFactors::addTo(Hash& hash) const noexcept
{
  hash.add(exist_);
  if (!exist_) return;
  hash.add(firstIsHeld_);
  const auto add = [&hash](const SymmetricBlock<double>& a) {
    for (const double value : {a.xx, a.xy, a.xz, a.yy, a.yz, a.zz}) hash.add(value);
  };
  const auto addBlock = [&hash](const Block<double>& a) {
    for (const double value : {a.xx, a.xy, a.xz, a.yx, a.yy, a.yz, a.zx, a.zy, a.zz})
      hash.add(value);
  };
  for (const Column<Lanes>& column : ends_)
    for (const int lane : {fromBase, fromTip}) {
      add(laneOf(column.inverse, lane));
      addBlock(laneOf(column.beside, lane));
      addBlock(laneOf(column.beyond, lane));
    }
  for (const Column<double>& column : middle_) {
    add(column.inverse);
    addBlock(column.beside);
    addBlock(column.beyond);
  }
}

}  // namespace perilymph::mechanics
