// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// How far from a point the distance to the wall is known from its value, gradient and Hessian there.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace perilymph::anatomy {

/// The radii between which a table chooses [m]; the first is none.
inline constexpr double trustRadii[] = {0.0,  0.5e-6, 1e-6, 1.5e-6, 2e-6,  3e-6,
                                        4e-6, 6e-6,   8e-6, 12e-6,  16e-6, 24e-6};
/// Half of the error that is accepted at a trust radius [m]: for the table's third derivatives, and
/// as much for the rotation of the section along the duct.
inline constexpr double trustError = 5e-9;

/// Index of the largest radius over which a third derivative [1/m^2] adds at most `trustError`.
std::uint8_t trustLevel(double thirdDerivative) noexcept;

/// For every cell of the table of distances, the index of its trust radius: a bound from the third
/// derivatives within the sections, in the cell and its neighbors. Those along the duct are smaller
/// by orders of magnitude (tested).
///
/// @param distance  Coefficients, [section][p][q] [m].
/// @param across    Their number along p and along q.
/// @param cellWidth   Per section of coefficients: size of a cell along p [m].
/// @param cellHeight  The same along q [m].
/// @return For the cell whose first coefficient has the same index.
std::vector<std::uint8_t> trustLevels(const std::vector<float>& distance, std::size_t across,
                                      const std::vector<double>& cellWidth,
                                      const std::vector<double>& cellHeight);

}  // namespace perilymph::anatomy
