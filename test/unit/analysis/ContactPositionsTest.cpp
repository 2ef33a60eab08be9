// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/ContactPositions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "perilymph/analysis/AnatomyMeasures.h"
#include "perilymph/anatomy/AnatomySource.h"

namespace perilymph::analysis {
namespace {

/// An array along the centers of the sections, its tip at an angle, its contacts 0.5 mm apart.
class ContactsAlongTheCenters : public testing::Test {
protected:
  static constexpr double tip_deg = 300.0;
  static constexpr double length_mm = 20.0;
  static constexpr int nodes = 100;

  ContactsAlongTheCenters()
      : scala(*anatomy::buildAnatomy({anatomy::AnatomySource::mean, {}, millimeters(1)}, "test"))
  {
    array.length = millimeters(length_mm);
    for (int i = 0; i < 16; ++i) array.contactsFromTip.push_back(millimeters(0.5 + i));
    now.nodes = nodes;
    // nodes at equal steps back from the tip along the path of the centers
    const double step = 1e-3 * length_mm / (nodes - 1);
    double angle = degrees(tip_deg).si();
    Eigen::Vector3d place_W = scala->center_W(angle);
    for (int i = nodes - 1; i >= 0; --i) {
      now.node_W[std::size_t(i)] = {float(place_W.x()), float(place_W.y()), float(place_W.z())};
      if (angle <= 0.0) {
        place_W += step * scala->entry().out_W;
        continue;
      }
      while (angle > 0.0 && (scala->center_W(angle) - place_W).norm() < step) angle -= 1e-4;
      place_W = scala->center_W(angle);
    }
    now.output.depth = 17e-3;
    contacts = contactPositions(*scala, array, now);
  }

  std::shared_ptr<const anatomy::ScalaTympani> scala;
  electrode::ArrayDesign array;
  haptics::Snapshot now{};
  std::vector<ContactPosition> contacts;
};

TEST_F(ContactsAlongTheCenters, AreNumberedFromTheTipWithTheirDepthAlongTheArray)
{
  ASSERT_EQ(contacts.size(), 16u);
  EXPECT_EQ(contacts.front().number, 1);
  EXPECT_EQ(contacts.back().number, 16);
  EXPECT_NEAR(inMillimeters(contacts.front().depth), 16.5, 1e-9);
  EXPECT_NEAR(inMillimeters(contacts[15].depth), 1.5, 1e-9);
}

TEST_F(ContactsAlongTheCenters, HaveAnglesThatFallFromTheTipToTheBase)
{
  // 0.5 mm at the radius of the center there
  const double radius_mm =
      inMillimeters(meters(scala->section(degrees(tip_deg).si()).centerRadius));
  const double expected_deg = tip_deg - inDegrees(radians(0.5 / radius_mm));
  EXPECT_NEAR(inDegrees(contacts.front().angle), expected_deg, 1.0);
  for (std::size_t i = 1; i < contacts.size(); ++i) {
    if (!contacts[i].isInserted) continue;
    EXPECT_LE(contacts[i].angle.si(), contacts[i - 1].angle.si()) << contacts[i].number;
    EXPECT_GE(contacts[i].frequency_Hz, contacts[i - 1].frequency_Hz) << contacts[i].number;
  }
}

TEST_F(ContactsAlongTheCenters, HaveTheFrequencyOfTheirPlaceByGreenwood)
{
  for (const ContactPosition& contact : contacts) {
    if (!contact.isInserted || contact.angle.si() <= 0.0) continue;
    const double fromApex = 1.0 - contact.coverage;
    EXPECT_NEAR(contact.frequency_Hz, 165.4 * (std::pow(10.0, 2.1 * fromApex) - 0.88), 0.1);
    EXPECT_GT(contact.frequency_Hz, 20.0);
    EXPECT_LT(contact.frequency_Hz, 20'700.0);
  }
}

TEST_F(ContactsAlongTheCenters, LieInsideTheLumen)
{
  for (const ContactPosition& contact : contacts) {
    if (!contact.isInserted || contact.angle.si() <= 0.0) continue;
    const anatomy::Section section = scala->section(contact.angle.si());
    EXPECT_GT(contact.toModiolus.si(), 0.0) << contact.number;
    EXPECT_LT(contact.toModiolus.si(), section.outerRadius - section.innerRadius) << contact.number;
  }
}

TEST_F(ContactsAlongTheCenters, AreMarkedWhereTheyAreAboveThePartition)
{
  for (std::size_t i = 75; i < nodes; ++i) now.isAbove.set(i);  // the last quarter
  for (const ContactPosition& contact : contactPositions(*scala, array, now)) {
    const bool isLastQuarter = contact.number - 0.5 < 0.25 * length_mm - 0.2;
    EXPECT_EQ(contact.isAbove, isLastQuarter) << contact.number;
    EXPECT_EQ(contact.toModiolus.si() < 0.0, isLastQuarter) << contact.number;
    if (isLastQuarter) {
      EXPECT_GT(contact.frequency_Hz, 0.0);  // its angle is as without a rupture
    }
  }
}

TEST_F(ContactsAlongTheCenters, CoverTheOrganOfCortiUpToTheMostApicalOne)
{
  const auto rows = sectionRows(*scala, degrees(1));
  double there = 0.0;
  for (const SectionRow& row : rows)
    if (row.angle <= contacts.front().angle.si()) there = row.organOfCortiLength;
  EXPECT_NEAR(cochlearCoverage(contacts), there / rows.back().organOfCortiLength, 0.005);
}

TEST_F(ContactsAlongTheCenters, OutsideTheOpeningAreNotInserted)
{
  // moved out by 10 mm along the entry
  const Eigen::Vector3d out_W = 0.010 * scala->entry().out_W;
  for (std::size_t i = 0; i < nodes; ++i)
    for (int k = 0; k < 3; ++k)
      now.node_W[i][std::size_t(k)] = float(0.0005 * double(i) * out_W[k] + out_W[k]);
  const auto outside = contactPositions(*scala, array, now);
  for (const ContactPosition& contact : outside) EXPECT_FALSE(contact.isInserted);
  EXPECT_EQ(cochlearCoverage(outside), 0.0);
}

}  // namespace
}  // namespace perilymph::analysis
