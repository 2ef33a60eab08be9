// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The columns of a block of ticks, and how each is coded.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace perilymph::session {

/// Number of numbers of a tick, and the places of those that follow from others.
struct BlockColumns {
  /// A column that is a linear function of others, but for rounding.
  struct Relation {
    std::size_t target;
    std::vector<std::size_t> sources;  ///< Never targets themselves.
  };

  std::size_t count = 0;
  std::vector<Relation> relations;

  /// The relation of a column; null without one.
  const Relation* of(std::size_t target) const
  {
    const auto found = std::find_if(relations.begin(), relations.end(),
                                    [&](const Relation& each) { return each.target == target; });
    return found == relations.end() ? nullptr : &*found;
  }
};

/// The columns of every tick, with depth by travel, axial and rendered force by the force on the hand, and position
/// by that of the device.
const BlockColumns& columnsOfATick();

/// What the numbers of a column are stored as.
enum class Coding : unsigned char {
  firstDifferences = 1,
  secondDifferences = 2,
  relation = 3,  ///< Differences to a linear function of other columns of the same tick.
};

/// Coefficients of a relation: a constant and up to three sources.
using Coefficients = std::array<double, 4>;

/// The sign of a difference in the lowest bit, so that small ones of either sign have zeros above.
inline std::uint64_t folded(std::uint64_t difference)
{
  return difference << 1 ^ (0 - (difference >> 63));
}
inline std::uint64_t unfolded(std::uint64_t number) { return number >> 1 ^ (0 - (number & 1)); }

/// All columns of a block, one behind the other.
class BlockTable {
public:
  void resize(std::size_t rows)
  {
    rows_ = rows;
    values_.resize(rows * columnsOfATick().count);
  }
  std::size_t rows() const { return rows_; }
  std::uint64_t* begin(std::size_t column) { return values_.data() + column * rows_; }
  const std::uint64_t* begin(std::size_t column) const { return values_.data() + column * rows_; }
  double real(std::size_t column, std::size_t row) const
  {
    return std::bit_cast<double>(begin(column)[row]);
  }

  /// Bits of the linear function; those of 0 where it is not finite. Sums and products in this order
  /// have the same bits on every machine.
  std::uint64_t predicted(const BlockColumns::Relation& relation, const Coefficients& terms,
                          std::size_t row) const;

  /// Least squares of a column by its sources, about their means.
  Coefficients fit(const BlockColumns::Relation& relation) const;

  /// Calls `each(row, number)` with the numbers of a coded column.
  template <class Each>
  void encode(std::size_t column, Coding coding, const Coefficients& terms, const Each& each) const
  {
    const std::uint64_t* values = begin(column);
    const BlockColumns::Relation* relation = columnsOfATick().of(column);
    std::uint64_t before = 0, step = 0;
    for (std::size_t i = 0; i < rows_; ++i) {
      const std::uint64_t next =
          coding == Coding::relation ? predicted(*relation, terms, i) : before + step;
      each(i, folded(values[i] - next));
      if (coding == Coding::secondDifferences) step = values[i] - before;
      before = values[i];
    }
  }

  /// Significant bits of the numbers of a coded column, in all.
  std::size_t cost(std::size_t column, Coding coding, const Coefficients& terms = {}) const
  {
    std::size_t bits = 0;
    encode(column, coding, terms, [&bits](std::size_t, std::uint64_t number) {
      bits += static_cast<std::size_t>(std::bit_width(number));
    });
    return bits;
  }

  /// Reads a coded column, bytes of equal weight together; its sources were read before.
  void decode(std::size_t column, Coding coding, const Coefficients& terms,
              const unsigned char* bytes)
  {
    std::uint64_t* values = begin(column);
    const BlockColumns::Relation* relation = columnsOfATick().of(column);
    std::uint64_t before = 0, step = 0;
    for (std::size_t i = 0; i < rows_; ++i) {
      std::uint64_t number = 0;
      for (std::size_t k = 0; k < sizeof number; ++k)
        number |= std::uint64_t{bytes[k * rows_ + i]} << (8 * k);
      const std::uint64_t next =
          coding == Coding::relation ? predicted(*relation, terms, i) : before + step;
      values[i] = next + unfolded(number);
      if (coding == Coding::secondDifferences) step = values[i] - before;
      before = values[i];
    }
  }

private:
  std::size_t rows_ = 0;
  std::vector<std::uint64_t> values_;
};

}  // namespace perilymph::session
