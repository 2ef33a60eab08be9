// SPDX-License-Identifier: BSD-3-Clause
#include "TravelColumns.h"

#include <algorithm>
#include <cmath>

namespace perilymph::charts {
namespace {

const auto columns = static_cast<std::size_t>(
    std::lround((TravelColumns::last_mm - TravelColumns::first_mm) / TravelColumns::width_mm));

}  // namespace

TravelColumns::TravelColumns() : in_(columns), out_(columns) {}

void TravelColumns::append(double travel_mm, double force_mN)
{
  if (!std::isfinite(force_mN) || !(travel_mm >= first_mm && travel_mm < last_mm)) return;
  if (isEmpty_) {
    farthest_mm_ = lowestTravel_mm_ = highestTravel_mm_ = travel_mm;
    lowestForce_mN_ = highestForce_mN_ = force_mN;
    isEmpty_ = false;
  }
  turnRound(travel_mm);
  // Values behind the front of this pass are tremor, or a reversal not yet certain.
  if (std::abs(travel_mm - farthest_mm_) <= width_mm) enter(travel_mm, force_mN);

  lastTravel_mm_ = travel_mm;
  lastForce_mN_ = force_mN;
  lowestForce_mN_ = std::min(lowestForce_mN_, force_mN);
  highestForce_mN_ = std::max(highestForce_mN_, force_mN);
  lowestTravel_mm_ = std::min(lowestTravel_mm_, travel_mm);
  highestTravel_mm_ = std::max(highestTravel_mm_, travel_mm);
}

void TravelColumns::enter(double travel_mm, double force_mN)
{
  const std::size_t index =
      std::min(columns - 1, static_cast<std::size_t>((travel_mm - first_mm) / width_mm));
  Column& column = (direction_ == Direction::in ? in_ : out_)[index];
  const float x = static_cast<float>(travel_mm);
  const float y = static_cast<float>(force_mN);
  if (column.pass != pass_)
    column = {pass_, x, y, x, y};
  else if (y < column.low_mN)
    column.low_mN = y, column.lowTravel_mm = x;
  else if (y > column.high_mN)
    column.high_mN = y, column.highTravel_mm = x;
}

void TravelColumns::turnRound(double travel_mm)
{
  const double onward =
      direction_ == Direction::in ? travel_mm - farthest_mm_ : farthest_mm_ - travel_mm;
  if (onward >= 0.0) {
    farthest_mm_ = travel_mm;
  } else if (onward < -turn_mm) {
    direction_ = direction_ == Direction::in ? Direction::out : Direction::in;
    farthest_mm_ = travel_mm;
    ++pass_;
  }
}

void TravelColumns::clear()
{
  std::fill(in_.begin(), in_.end(), Column{});
  std::fill(out_.begin(), out_.end(), Column{});
  direction_ = Direction::in;
  pass_ = 1;
  isEmpty_ = true;
  lowestForce_mN_ = highestForce_mN_ = lowestTravel_mm_ = highestTravel_mm_ = 0.0;
}

void TravelColumns::curve(Direction direction, std::vector<float>& travel_mm,
                          std::vector<float>& force_mN) const
{
  travel_mm.clear();
  force_mN.clear();
  for (const Column& column : direction == Direction::in ? in_ : out_) {
    if (column.pass == 0) continue;
    const bool lowFirst = column.lowTravel_mm <= column.highTravel_mm;
    travel_mm.push_back(lowFirst ? column.lowTravel_mm : column.highTravel_mm);
    force_mN.push_back(lowFirst ? column.low_mN : column.high_mN);
    if (column.low_mN == column.high_mN) continue;
    travel_mm.push_back(lowFirst ? column.highTravel_mm : column.lowTravel_mm);
    force_mN.push_back(lowFirst ? column.high_mN : column.low_mN);
  }
}

}  // namespace perilymph::charts
