// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/AnatomyMeasures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "perilymph/analysis/ClinicalEstimates.h"
#include "perilymph/anatomy/DuctLength.h"
#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::analysis {
namespace {

double valueOf(const std::vector<Measure>& measures, const std::string& key)
{
  const auto found = std::find_if(measures.begin(), measures.end(),
                                  [&](const Measure& measure) { return measure.key == key; });
  EXPECT_NE(found, measures.end()) << key;
  return found == measures.end() ? 0.0 : found->value;
}

constexpr double ringRadius = 4e-3;     // [m]
constexpr double sectionRadius = 1e-3;  // [m]

/// A torus: a ring of circular section, whose measures are known in closed form.
anatomy::ScalaTympani ring()
{
  anatomy::SectionTables tables;
  tables.name = "ring";
  constexpr int sections = 241;
  tables.step = 2.0 * pi / (sections - 1);
  tables.directions = 96;
  tables.leadIn = 1e-3;
  tables.centerRadius.assign(sections, ringRadius);
  tables.centerHeight.assign(sections, 0.0);
  tables.wallRadius.assign(sections * 96, sectionRadius);
  tables.membraneInner.assign(sections, 0.0);
  tables.membraneOuter.assign(sections, 0.2e-3);
  tables.membraneHeight.assign(sections, 0.9e-3);
  tables.planRadius.assign(sections, ringRadius);
  return anatomy::ScalaTympani(std::move(tables));
}

TEST(MeasuresOfARing, AreThoseOfATorus)
{
  const auto measures = measure(ring());
  const double outer_mm = (ringRadius + sectionRadius) * 1e3;
  const double chords = test::tolerance(1e-3, "polylines and tables instead of circles");
  EXPECT_NEAR(valueOf(measures, "A_mm"), 2.0 * outer_mm, chords * outer_mm);
  EXPECT_NEAR(valueOf(measures, "B_mm"), 2.0 * outer_mm, chords * outer_mm);
  EXPECT_NEAR(valueOf(measures, "H_mm"), 2.0 * sectionRadius * 1e3, chords);
  EXPECT_NEAR(valueOf(measures, "turns"), 1.0, 1e-9);
  EXPECT_NEAR(valueOf(measures, "outer_wall_length_360_mm"), 2.0 * pi * outer_mm,
              chords * 2.0 * pi * outer_mm);
  EXPECT_NEAR(valueOf(measures, "st_length_mm"), 2.0 * pi * ringRadius * 1e3, chords * 25.0);
  EXPECT_NEAR(valueOf(measures, "rw_width_mm"), 2.0 * sectionRadius * 1e3, chords);
  // Pappus: area of the section times the path of its center
  const double torus_mm3 = pi * sectionRadius * sectionRadius * 2.0 * pi * ringRadius * 1e9;
  EXPECT_NEAR(valueOf(measures, "volume_mm3"), torus_mm3, 2.0 * chords * torus_mm3);
}

TEST(MeasuresOfThePublishedAnatomy, AreThePatientsOwnNumbers)
{
  anatomy::Patient patient;
  patient.scalaTympaniLength = millimeters(33.6);
  patient.roundWindowWidth = millimeters(2.1);
  patient.roundWindowHeight = millimeters(1.7);
  const auto scala = anatomy::buildPublished(patient, millimeters(1));
  const auto measures = measure(*scala);
  const double spline_mm = test::tolerance(0.02, "splines through tables round corners off");
  EXPECT_NEAR(valueOf(measures, "st_length_mm"), 33.6, spline_mm);
  EXPECT_NEAR(valueOf(measures, "rw_width_mm"), 2.1, spline_mm);
  EXPECT_NEAR(valueOf(measures, "rw_height_mm"), 1.7, spline_mm);
}

class MeasuresOfTheMeanAnatomy : public testing::Test {
protected:
  static std::vector<Measure> measured()
  {
    const auto scala = anatomy::buildMean(millimeters(1));
    return scala ? measure(**scala) : std::vector<Measure>{};
  }

  const std::vector<Measure> measures = measured();
};

TEST_F(MeasuresOfTheMeanAnatomy, AreThoseOfThePublishedSolid)
{
  // Froehlich et al. 2024, measured on the solid itself
  EXPECT_NEAR(valueOf(measures, "A_mm"), 9.53, 0.01);
  EXPECT_NEAR(valueOf(measures, "B_mm"), 6.82, 0.01);
  EXPECT_NEAR(valueOf(measures, "outer_wall_length_360_mm"), 22.82, 0.05);
  EXPECT_NEAR(valueOf(measures, "outer_wall_length_mm"), 33.04, 0.05);
  EXPECT_NEAR(valueOf(measures, "volume_mm3"), 33.4, 0.7);
  EXPECT_NEAR(valueOf(measures, "measured_to_deg"), 675.0, 1e-9);
  EXPECT_GT(valueOf(measures, "volume_to_apex_mm3"), valueOf(measures, "volume_mm3"));
}

TEST_F(MeasuresOfTheMeanAnatomy, AgreeWithTheFormulasWithin2_5Percent)
{
  const double lengthOfTurn = valueOf(measures, "outer_wall_length_360_mm");
  EXPECT_NEAR(valueOf(measures, "escude_outer_wall_360_mm"), lengthOfTurn, 0.025 * lengthOfTurn);
  EXPECT_NEAR(valueOf(measures, "eca_outer_wall_360_mm"), lengthOfTurn, 0.025 * lengthOfTurn);
  const double whole = valueOf(measures, "outer_wall_length_mm");
  EXPECT_NEAR(valueOf(measures, "escude_outer_wall_675_mm"), whole, 0.025 * whole);
}

TEST(ClinicalEstimates, AreThoseOfTheirFormulasForTheMeanCochlea)
{
  // computed by hand for A = 9.23 and B = 6.80 mm
  const Length a = millimeters(9.23), b = millimeters(6.80);
  EXPECT_NEAR(inMillimeters(anatomy::ductLengthFromA(a)), 34.40, 0.005);
  EXPECT_NEAR(inMillimeters(alexiadesTwoTurns(a)), 30.04, 0.005);
  EXPECT_NEAR(inMillimeters(escudeOuterWall(a, degrees(360))), 22.47, 0.005);
  EXPECT_NEAR(inMillimeters(anatomy::ellipticCircularBasalTurn(a, b)), 22.46, 0.005);
  const Measure duct = ductLength("cdl_oc_mm", a, b);
  EXPECT_NEAR(duct.value, 33.44, 0.005);
  EXPECT_NEAR(1.96 * duct.formulaError, 34.40 - 33.44, 0.005);
  EXPECT_NEAR(valueOf(clinicalEstimates(a, b), "pietsch_turns"), 2.686, 0.0005);
}

TEST(Measures, SayHowEachWasFound)
{
  for (const Measure& measure : measure(ring())) {
    EXPECT_FALSE(measure.formula.empty()) << measure.key;
    EXPECT_FALSE(measure.source.empty()) << measure.key;
  }
}

TEST(Sections, EndAtTheApexAndGrowInLength)
{
  const anatomy::ScalaTympani scala = ring();
  const auto rows = sectionRows(scala, degrees(7));
  EXPECT_DOUBLE_EQ(rows.front().angle, 0.0);
  EXPECT_NEAR(rows.back().angle, 2.0 * pi, 1e-9);
  EXPECT_EQ(rows.size(), static_cast<std::size_t>(std::ceil(360.0 / 7.0)) + 1);
  const double area_m2 = pi * sectionRadius * sectionRadius;
  EXPECT_NEAR(rows[20].section.area, area_m2, 2e-3 * area_m2);
  EXPECT_NEAR(rows.back().outerWallLength / rows.back().innerWallLength,
              (ringRadius + sectionRadius) / (ringRadius - sectionRadius), 1e-3);
}

TEST(Sections, AreATableWithItsUnits)
{
  std::istringstream csv(sectionsCsv(sectionRows(ring(), degrees(90))));
  std::string header, row;
  std::getline(csv, header);
  EXPECT_EQ(header.substr(0, 35), "angle_deg,center_r_mm,center_z_mm,i");
  int rows = 0;
  while (std::getline(csv, row)) {
    EXPECT_EQ(std::count(row.begin(), row.end(), ','),
              std::count(header.begin(), header.end(), ','));
    ++rows;
  }
  EXPECT_EQ(rows, 5);
}

TEST(SectionTable, GivesTheToneOfEachPlace)
{
  const auto scala = anatomy::buildPublished({}, millimeters(1));
  const auto rows = sectionRows(*scala, degrees(1));
  std::istringstream csv(sectionsCsv(rows));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line.substr(line.size() - 32), ",greenwood_Hz,spiral_ganglion_Hz");
  std::getline(csv, line);
  // the base: Greenwood's 20,677 Hz and the spiral ganglion's 17,225 Hz
  EXPECT_NEAR(std::stod(line.substr(line.rfind(',') + 1)), 17225.0, 1.0);
  const auto before = line.rfind(',', line.rfind(',') - 1);
  EXPECT_NEAR(std::stod(line.substr(before + 1)), 20677.0, 1.0);
  EXPECT_NEAR(rows.back().organOfCortiLength, 35.58e-3, 0.05e-3);
}

}  // namespace
}  // namespace perilymph::analysis
