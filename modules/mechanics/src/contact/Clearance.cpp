#include "Clearance.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace perilymph::mechanics {
namespace {

double squaredMotion(const InsertionState& state, std::size_t i) noexcept
{
  const Eigen::Vector3d moved = state.position_W[i] - state.room.before_W[i];
  return moved[0] * moved[0] + moved[1] * moved[1] + moved[2] * moved[2];
}

}  // namespace

void findWall(const InsertionModel& model, InsertionState& state, StepRoom& room) noexcept
{
  const std::size_t n = state.position_W.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double most = state.clearance[i];
    room.isAsked[i] = squaredMotion(state, i) < most * most ? 0 : 1;
    room.wall[i].isNear = false;
  }
  room.isAsked[n - 1] = 1;  // the tip always: its angle is a reading

  // neighbors in one question
  for (std::size_t first = 0; first < n;) {
    std::size_t count = 0;
    while (first + count < n && room.isAsked[first + count] != 0) ++count;
    if (count > 0)
      model.parts.lumen->nearestWall(std::span(state.position_W).subspan(first, count),
                                     std::span(room.reach).subspan(first, count),
                                     std::span(state.track).subspan(first, count),
                                     std::span(room.wall).subspan(first, count));
    first += count + 1;
  }
}

void keepClearance(InsertionState& state) noexcept
{
  const StepRoom& room = state.room;
  for (std::size_t i = 0; i < state.clearance.size(); ++i) {
    double& left = state.clearance[i];
    if (room.isAsked[i] == 0)
      left -= std::sqrt(squaredMotion(state, i));
    else
      left = room.wall[i].isNear ? 0.0 : std::max(room.wall[i].clearance, 0.0);
  }
}

}  // namespace perilymph::mechanics
