// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/Conclusion.h"

#include <algorithm>
#include <utility>

namespace perilymph::gui {

bool Conclusion::isDue(const haptics::TickOutput& now)
{
  const bool isOver =
      now.workflow == haptics::Workflow::finished || now.workflow == haptics::Workflow::fault;
  if (!isOver) *this = {};
  if (!isOver) return false;
  const bool wasResting = std::exchange(isResting_, (now.status & haptics::resting) != 0);
  const auto time = std::chrono::steady_clock::now();
  if (!ended_) ended_ = time;
  const bool isDueNow =
      (isResting_ && !wasResting) || (!isRequested_ && time - *ended_ >= longestWait);
  isRequested_ = isRequested_ || isDueNow;
  return isDueNow;
}

double angleOfTip(const anatomy::ScalaTympani& anatomy, const haptics::Snapshot& now)
{
  const auto& tip_W = now.node_W[now.nodes - 1];
  anatomy::LumenTrack track = anatomy.startTrack();
  anatomy.follow({tip_W[0], tip_W[1], tip_W[2]}, track);
  return std::max(track.angle, 0.0);
}

}  // namespace perilymph::gui
