// SPDX-License-Identifier: BSD-3-Clause

// A tip that folds over, as it is seen: a precurved array leaves its sheath before the basal turn.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <stop_token>

#include "perilymph/charts/ArrayInScala.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/planning/PlannedDraw.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/copyChanged.h"
#include "perilymph/visualization/Picture.h"

namespace perilymph::planning {
namespace {

/// The end of the first insertion of a plan in which the tip folded over.
Result<PlannedShape> foldedTip(const std::filesystem::path& folder, const Resolution& resolution)
{
  PlanRequest request;
  const auto patient = anatomy::loadPatient(resource("resources/patients/measured.toml"));
  if (!patient) return patient.error();
  request.patient = *patient;
  request.scenario = test::copyChanged(
      resource("resources/scenarios/surgery-flex28.toml"), folder / "scenario.toml",
      {{"technique = \"standard\"", "technique = \"aos\""},
       {"friction = \"estimate-from-pig-tissue\"", "friction = \"tissue\""}});
  request.arrays = {test::copyChanged(resource("plugins/electrodes/cochlear/slim-modiolar.toml"),
                                      folder / "early.toml",
                                      {{"hold_depth_mm = 5.0", "hold_depth_mm = 3.0"}})};
  request.draws = 4;
  request.seed = 5;
  request.resolution = resolution;
  const auto plan = makePlan(request, {}, {});
  if (!plan) return plan.error();
  const auto folded = std::ranges::find_if(plan->insertions, [](const PlannedInsertion& each) {
    return each.insertion.end == haptics::InsertionEnd::foldedTip;
  });
  if (folded == plan->insertions.end()) return Error{"No tip folded over."};
  const auto draw = static_cast<std::size_t>(folded - plan->insertions.begin()) + 1;
  return shapeOf(*plan, 0, draw, {});
}

class AFoldOver : public testing::TestWithParam<Resolution> {};

TEST_P(AFoldOver, IsSeenAsATipThatPointsBack)
{
  const test::TemporaryFolder folder;
  const auto shape = foldedTip(folder.path(), GetParam());
  ASSERT_TRUE(shape) << shape.error().message;
  charts::ArrayInScala array(*shape->anatomy, shape->parameters.array);
  array.follow(shape->end);
  ASSERT_FALSE(array.nodes().empty());
  EXPECT_LT(array.nodes().back().along.z(), 0.0);  // along the duct
  const auto deepest = std::ranges::max(
      array.nodes(), {}, [](const charts::NodePlace& node) { return node.angle_deg; });
  EXPECT_GT(deepest.angle_deg, array.nodes().back().angle_deg);

  const char* const kept = std::getenv("PERILYMPH_SCREEN_PICTURES");
  visualization::PictureRequest picture;
  picture.scala = shape->anatomy;
  picture.array = shape->parameters.array;
  picture.now = &shape->end;
  picture.file = std::filesystem::path(kept != nullptr ? kept : folder.path()) / "fold-over.png";
  const auto drawn = visualization::renderPicture(picture);
  ASSERT_TRUE(drawn) << drawn.error().message;
  EXPECT_GT(std::filesystem::file_size(picture.file), 10'000u);
}

INSTANTIATE_TEST_SUITE_P(AtEveryResolution, AFoldOver,
                         testing::Values(Resolution{40, milliseconds(10)},
                                         Resolution{100, milliseconds(2)}));

}  // namespace
}  // namespace perilymph::planning
