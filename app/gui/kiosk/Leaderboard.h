// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The anonymous insertions of a day at the booth.

#include <QDate>
#include <QTime>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph::gui {

/// An insertion that reached its goal.
struct KioskEntry {
  QTime at;
  double peak_mN = 0.0;
  double duration_s = 0.0;
  int reversals = 0;
};

/// A day at the booth.
struct DayStatistics {
  int visitors = 0;    ///< Who moved the array, from a touch of the demonstration to the next one.
  int insertions = 0;  ///< Insertions that reached the goal; one visitor may have several.
  std::optional<double> best_mN;    ///< Lowest peak force.
  std::optional<double> median_mN;  ///< Median of all peak forces.
};

/// Stores the insertions of one day in a small text file, which a restart reads again. The list is
/// empty on a new day; damaged lines are ignored.
class Leaderboard {
public:
  /// More than one insertion every six seconds, eight hours long. Beyond, the largest peak is dropped.
  static constexpr std::size_t capacity = 5000;

  explicit Leaderboard(std::filesystem::path file) : file_(std::move(file)) {}

  /// The entries of a day, sorted by peak; equal peaks by time.
  const std::vector<KioskEntry>& entriesOf(const QDate& day);
  DayStatistics statisticsOf(const QDate& day);
  /// Adds an insertion, its peak rounded as it is stored.
  ///
  /// @return Its rank, from 1; empty if the list is full of lower peaks.
  std::optional<int> enter(const QDate& day, const KioskEntry& entry);
  /// Counts a visitor.
  void addVisitor(const QDate& day);
  /// Why the list could not be saved; empty if there is no error.
  const std::string& error() const { return error_; }

private:
  void load(const QDate& day);
  void save();

  std::filesystem::path file_;
  QDate day_;
  std::vector<KioskEntry> entries_;
  int visitors_ = 0;
  std::string error_;
};

/// Path of the list: in the folder `booth` of the data home.
std::filesystem::path kioskBoardFile();

}  // namespace perilymph::gui
