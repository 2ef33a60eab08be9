// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reading of untrusted files by libraries that print, allocate, hang or crash on odd ones: in a
// child process.

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>

namespace perilymph::imaging {

/// Limits of a child process.
struct ChildLimits {
  /// Memory that it may allocate beyond its parent's [bytes]; unlimited if empty.
  std::optional<std::size_t> memory;
  std::stop_token stop;  ///< Ends it early.
  /// A child has one of its parent's threads, and may wait forever for a lock that another one held
  /// when it was made. If given, a child that took longer is replaced once, by one that has a minute.
  std::optional<std::chrono::milliseconds> patience;
};

/// Status of a child that threw, crashed, was killed or took longer than a minute. Work returns
/// smaller ones.
inline constexpr int childFailed = 100;

/// Runs work in a child process without output and without a core file. Returns its status. With
/// `patience` the work may begin twice.
int runInChild(const std::function<int()>& work, const ChildLimits& limits);

}  // namespace perilymph::imaging
