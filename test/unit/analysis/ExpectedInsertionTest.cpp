// SPDX-License-Identifier: BSD-3-Clause

// Where fully inserted arrays end, against lengths measured on the mean scala tympani.

#include "perilymph/analysis/ExpectedInsertion.h"

#include <gtest/gtest.h>

#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::analysis {
namespace {

std::shared_ptr<const anatomy::ScalaTympani> meanScala()
{
  return *anatomy::buildAnatomy({anatomy::AnatomySource::mean, {}, millimeters(1)}, "the test");
}

electrode::ArrayDesign arrayNamed(const char* name)
{
  return *electrode::loadArray(*findByName("array", "plugins/electrodes", name));
}

double valueOf(const std::vector<Measure>& measures, const char* key)
{
  for (const Measure& each : measures)
    if (each.key == key) return each.value;
  ADD_FAILURE() << key;
  return 0.0;
}

TEST(ExpectedInsertion, FollowsThePathMeasuredOnTheMeanScalaTympani)
{
  // Lengths of the path 0.40 mm inside the lateral wall of the published solid (Froehlich et al.
  // 2024, CC BY 4.0), measured at its sections: 12.56 mm to 180 degrees, 20.36 to 360, 25.60 to 540.
  const auto scala = meanScala();
  const double off_deg = test::tolerance(8.0, "chords of sections 22.5 degrees apart");
  for (const auto& [length_mm, angle_deg] :
       {std::pair{12.56, 180.0}, std::pair{20.36, 360.0}, std::pair{25.60, 540.0}})
    EXPECT_NEAR(inDegrees(angleAlongLateralWall(*scala, millimeters(length_mm), millimeters(0.40))),
                angle_deg, off_deg)
        << length_mm;
}

TEST(ExpectedInsertion, OfALongerArrayIsDeeperAndCoversMore)
{
  const auto scala = meanScala();
  double angle_deg = 0.0, coverage_percent = 0.0;
  for (const char* name : {"flex20", "flex24", "flex28"}) {
    const auto measures = expectedInsertion(*scala, arrayNamed(name));
    EXPECT_GT(valueOf(measures, "angular_insertion_depth_deg"), angle_deg) << name;
    EXPECT_GT(valueOf(measures, "coverage_percent"), coverage_percent) << name;
    angle_deg = valueOf(measures, "angular_insertion_depth_deg");
    coverage_percent = valueOf(measures, "coverage_percent");
  }
  EXPECT_LT(coverage_percent, 100.0);
}

TEST(ExpectedInsertion, OfAPrecurvedArrayIsNotClaimed)
{
  EXPECT_TRUE(expectedInsertion(*meanScala(), arrayNamed("contour")).empty());
}

TEST(ExpectedInsertion, IsNotBelowTheAnglesSeenInPatients)
{
  // Medians of O'Connell et al. 2017 (48 of 48 in the scala tympani): FLEX24 408, FLEX28 575
  // degrees. The tip's path is an upper bound, and the most apical contact, 1 mm and less before it,
  // is within a quarter of a turn of them.
  const auto scala = meanScala();
  for (const auto& [name, median_deg] : {std::pair{"flex24", 408.0}, std::pair{"flex28", 575.0}}) {
    const electrode::ArrayDesign array = arrayNamed(name);
    EXPECT_GT(inDegrees(angleAlongLateralWall(*scala, array.insertable, millimeters(0.4))),
              median_deg)
        << name;
    EXPECT_NEAR(valueOf(expectedInsertion(*scala, array), "angular_insertion_depth_deg"),
                median_deg, 90.0)
        << name;
  }
}

}  // namespace
}  // namespace perilymph::analysis
