// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A found array with the contacts that a person placed, and what was before.

#include <Eigen/Core>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "perilymph/outcome/FoundArray.h"

namespace perilymph::gui {

/// Steps for undo: a step is one contact that was moved, with what was found from it.
class FoundHistory {
public:
  struct State {
    std::map<int, Eigen::Vector3d> byHand;  ///< Positions in P [mm].
    std::shared_ptr<const outcome::FoundArray> found;
    bool isStale = false;  ///< A contact was moved since the others were found.
  };

  const State& now() const { return now_; }
  /// Forgets everything, and begins with a state.
  void begin(State state)
  {
    now_ = std::move(state);
    before_.clear();
    after_.clear();
  }
  void change(State state)
  {
    if (before_.size() == maxSteps) before_.erase(before_.begin());
    before_.push_back(std::exchange(now_, std::move(state)));
    after_.clear();
  }
  /// What was found from the contacts as they are now: no step of its own.
  void setFound(std::shared_ptr<const outcome::FoundArray> found)
  {
    now_.found = std::move(found);
    now_.isStale = false;
  }
  bool canUndo() const { return !before_.empty(); }
  bool canRedo() const { return !after_.empty(); }
  void undo() { move(before_, after_); }
  void redo() { move(after_, before_); }

private:
  static constexpr std::size_t maxSteps = 100;

  void move(std::vector<State>& from, std::vector<State>& to)
  {
    if (from.empty()) return;
    to.push_back(std::exchange(now_, std::move(from.back())));
    from.pop_back();
  }

  State now_;
  std::vector<State> before_, after_;
};

}  // namespace perilymph::gui
