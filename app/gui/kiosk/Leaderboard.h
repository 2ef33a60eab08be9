// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The anonymous list of the day's best insertions.

#include <QDate>
#include <QTime>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// A completed insertion to full depth.
struct KioskEntry {
  QTime at;
  double peak_mN = 0.0;
  double duration_s = 0.0;
  int reversals = 0;
};

/// Stores the gentlest insertions of one day in a small text file. The list is empty on a new day;
/// damaged lines are ignored.
class Leaderboard {
public:
  static constexpr std::size_t capacity = 8;

  explicit Leaderboard(std::filesystem::path file) : file_(std::move(file)) {}

  /// The entries of a day, sorted by peak; equal peaks by time.
  const std::vector<KioskEntry>& entriesOf(const QDate& day);
  /// Adds an insertion if it is among the best.
  ///
  /// @return Its rank, from 1; empty if it is not among them.
  std::optional<int> enter(const QDate& day, const KioskEntry& entry);
  /// Why the list could not be saved; empty if there is no error.
  const std::string& error() const { return error_; }

private:
  void load(const QDate& day);
  void save();

  std::filesystem::path file_;
  QDate day_;
  std::vector<KioskEntry> entries_;
  std::string error_;
};

/// Path of the list: in the folder `booth` of the data home.
std::filesystem::path kioskBoardFile();

}  // namespace perilymph::gui
