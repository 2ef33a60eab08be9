// SPDX-License-Identifier: BSD-3-Clause

// Any numbers as positions and orientations of slices.

#include <cmath>
#include <cstring>

#include "FuzzTarget.h"
#include "perilymph/ct/SliceStack.h"

namespace perilymph::fuzz {

namespace {

double numberOf(InputReader& reader)
{
  double number = 0.0;
  const auto bytes = reader.bytes(sizeof number);
  std::memcpy(&number, bytes.data(), bytes.size());
  return number;
}

void append(Bytes& bytes, double number)
{
  const auto* const first = reinterpret_cast<const std::uint8_t*>(&number);
  bytes.insert(bytes.end(), first, first + sizeof number);
}

}  // namespace

std::vector<Bytes> seeds()
{
  // upright slices at equal steps, tilted ones, and one with a gap
  std::vector<Bytes> stacks;
  for (const double tilt : {0.0, 0.2})
    for (const double gap : {0.0, 0.5}) {
      Bytes stack;
      for (int k = 0; k < 6; ++k) {
        stack.push_back(3);
        for (const double number :
             {10.0, 20.0 + tilt * k, 0.5 * k + (k > 3 ? gap : 0.0), 1.0, 0.0, 0.0, 0.0, 1.0, 0.0})
          append(stack, number);
      }
      stacks.push_back(std::move(stack));
    }
  return stacks;
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  fuzz::InputReader reader({data, size});
  std::vector<ct::SlicePose> slices;
  while (!reader.isEmpty() && slices.size() < 64) {
    ct::SlicePose slice;
    const std::uint8_t has = reader.byte();
    Eigen::Vector3d position, row, column;
    for (Eigen::Vector3d* const v : {&position, &row, &column})
      for (int axis = 0; axis < 3; ++axis) (*v)[axis] = fuzz::numberOf(reader);
    if ((has & 1) != 0) slice.position_P = position;
    if ((has & 2) != 0) {
      slice.axes_P.emplace();
      slice.axes_P->col(0) = row;
      slice.axes_P->col(1) = column;
    }
    slices.push_back(slice);
  }
  const auto stack = ct::stackSlices(slices);
  if (!stack) {
    fuzz::promise(!stack.error().message.empty(), "a refusal has a sentence");
    return 0;
  }
  fuzz::promise(stack->places.size() >= 2, "a stack has two places");
  fuzz::promise(
      stack->step_P.allFinite() && stack->origin_P.allFinite() && stack->axes_P.allFinite(),
      "the geometry is finite");
  fuzz::promise(stack->planeDistance_mm() > 0.0, "planes lie apart");
  std::size_t count = 0;
  const double allowed = std::max(
      ct::roundedDeviation_mm,
      std::min(ct::allowedDeviation_mm, ct::allowedDeviationFraction * stack->step_P.norm()));
  fuzz::promise(stack->maxDeviation_mm <= allowed * (1.0 + 1e-9), "no slice is off its place");
  for (const auto& place : stack->places) {
    fuzz::promise(!place.empty(), "every place has a slice");
    for (const std::size_t slice : place)
      fuzz::promise(slice < slices.size(), "slices of the stack were given");
    count += place.size();
  }
  fuzz::promise(count == slices.size(), "every slice has a place");
  return 0;
}
