// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The folder in which a series arrives.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/archive/Fetch.h"

namespace perilymph::archive {

/// Files of one series of which it is known which belong to it.
class ReceivedSeries {
public:
  /// @param folder    A private folder of this call's own.
  /// @param expected  Instance UIDs of the series' objects.
  ReceivedSeries(std::filesystem::path folder, SeriesAddress series,
                 std::set<std::string> expected);

  std::size_t expectedCount() const { return expected_.size(); }
  std::size_t arrivedCount() const { return expected_.size() - missing_.size(); }
  const std::set<std::string>& missing() const { return missing_; }

  /// A place for an object that is being received.
  std::filesystem::path newPlace() const;
  /// Takes a file that was received, or deletes it if it does not belong to the series: then
  /// obstacle() says why, and nothing more is to be accepted.
  bool take(const std::filesystem::path& place);
  const std::optional<Sentence>& obstacle() const { return obstacle_; }
  /// The file of an object could not be written, which is an obstacle.
  void setUnwritable(const std::string& why);

private:
  void setObstacle(Sentence why) { obstacle_ = std::move(why); }
  std::filesystem::path placeOf(const std::string& instanceUid) const;
  std::optional<Sentence> faultOf(const std::filesystem::path& place, std::string& instanceUid);

  std::filesystem::path folder_;
  SeriesAddress series_;
  std::set<std::string> expected_, missing_;
  std::optional<std::pair<std::string, std::string>> patient_;  // number and birth date
  std::optional<Sentence> obstacle_;
};

}  // namespace perilymph::archive
