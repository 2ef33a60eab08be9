#pragma once

// The best insertions of the day, without names.

#include <QDate>
#include <QTime>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// An insertion to full depth.
struct KioskEntry {
  QTime at;
  double peak_mN = 0.0;
  double duration_s = 0.0;
  int reversals = 0;
};

/// Keeps the gentlest insertions of one day in a small text file. Another day begins with an empty
/// board; a damaged line is left out.
class KioskBoard {
public:
  static constexpr std::size_t capacity = 8;

  explicit KioskBoard(std::filesystem::path file) : file_(std::move(file)) {}

  /// The entries of a day, the lowest peak first; of equal peaks the earlier one.
  const std::vector<KioskEntry>& entriesOf(const QDate& day);
  /// Enters an insertion if it is among the best.
  ///
  /// @return Its place, 1 for the first; none if it is not among them.
  std::optional<int> enter(const QDate& day, const KioskEntry& entry);
  /// Why the board could not be kept; empty while all is well.
  const std::string& error() const { return error_; }

private:
  void load(const QDate& day);
  void save();

  std::filesystem::path file_;
  QDate day_;
  std::vector<KioskEntry> entries_;
  std::string error_;
};

/// The board's place: the folder `booth` in the data home.
std::filesystem::path kioskBoardFile();

}  // namespace perilymph::gui
