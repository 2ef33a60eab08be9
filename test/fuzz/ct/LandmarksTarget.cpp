// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a markups file of 3D Slicer.

#include "InputFile.h"
#include "perilymph/imaging/Landmarks.h"
#include "perilymph/imaging/PlanFiles.h"

namespace perilymph::fuzz {

std::vector<Bytes> seeds()
{
  ct::Marks marks;
  for (std::size_t k = 0; k < ct::markCount; ++k)
    marks.points_P[k] = Eigen::Vector3d(double(k), 2.5, -1e3);
  const std::string text = imaging::planText({.marks = marks});
  const std::string ras =
      R"({"markups":[{"coordinateSystem":"RAS","controlPoints":[{"label":"C","position":[1,2,3]}]}]})";
  return {Bytes(text.begin(), text.end()), Bytes(ras.begin(), ras.end())};
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  static fuzz::InputFile file("a.mrk.json");
  const auto marks = imaging::readLandmarks(file.holding({data, size}), {});
  if (!marks) {
    fuzz::promise(!marks.error().message.empty(), "a refusal has a sentence");
    return 0;
  }
  fuzz::promise(!marks->isEmpty(), "landmarks that are read are there");
  for (const auto& point : marks->points_P)
    if (point) fuzz::promise(point->allFinite(), "landmarks are finite");
  return 0;
}
