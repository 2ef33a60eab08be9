// SPDX-License-Identifier: BSD-3-Clause

// The population of cochleae against the numbers of Pietsch et al. 2017, and patients scaled from
// the mean against their own measures.

#include "perilymph/anatomy/Population.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "perilymph/anatomy/IndividualShape.h"
#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::anatomy {
namespace {

TEST(IndividualHalfDiameters, KeepAAndBAndHaveTheConditionalCovarianceOfThePopulation)
{
  const Length a = millimeters(9.6), b = millimeters(6.5);
  const HalfDiameters mean = likeliestHalfDiameters(a, b);
  const auto deviated = [&](double first, double second) {
    return individualHalfDiameters(a, b, {first, second});
  };
  for (const auto& one : {deviated(0.0, 0.0), deviated(1.3, -0.4), deviated(-2.0, 2.0)}) {
    EXPECT_NEAR(inMillimeters(one.a()), 9.6, 1e-9);
    EXPECT_NEAR(inMillimeters(one.b()), 6.5, 1e-9);
  }
  // Schur complement of the covariance in A1, B1, A, B, eliminated by hand
  const auto s = halfDiameterCovariance();
  const double aa = s[0][0] + 2.0 * s[0][2] + s[2][2];
  const double bb = s[1][1] + 2.0 * s[1][3] + s[3][3];
  const double ab = s[0][1] + s[0][3] + s[2][1] + s[2][3];
  const double a1a = s[0][0] + s[0][2], a1b = s[0][1] + s[0][3];
  const double weightA = (bb * a1a - ab * a1b) / (aa * bb - ab * ab);
  const double weightB = (aa * a1b - ab * a1a) / (aa * bb - ab * ab);
  const double variance = s[0][0] - weightA * a1a - weightB * a1b;
  EXPECT_NEAR(deviated(1.0, 0.0).a1 - mean.a1, std::sqrt(variance), 1e-9);
  EXPECT_NEAR(deviated(0.0, 1.0).a1 - mean.a1, 0.0, 1e-12);
}

TEST(IndividualShape, KeepsAAndBAndNarrowsTheScalaFromTheModiolus)
{
  const BasalTurn turn{millimeters(9.3), millimeters(6.7), millimeters(3.9)};
  IndividualShape shape{individualHalfDiameters(turn.a, turn.b, {1.0, -1.0})};
  shape.section = 0.85;
  const auto individual = buildMean("individual", turn, shape, Length{});
  ASSERT_TRUE(individual) << individual.error().message;
  const auto typical = buildMean("typical", turn, Length{});
  ASSERT_TRUE(typical) << typical.error().message;
  const auto outer = [](const ScalaTympani& scala, double angle_deg) {
    return scala.section(degrees(angle_deg).si()).outerRadius * 1e3;
  };
  const ScalaTympani& own = **individual;
  EXPECT_NEAR(outer(own, 0.0) + outer(own, 180.0), 9.3, 0.02);
  EXPECT_NEAR(outer(own, 90.0) + outer(own, 270.0), 6.7, 0.02);
  EXPECT_GT(std::fabs(outer(own, 180.0) - outer(**typical, 180.0)), 0.05);
  const auto width = [&](const ScalaTympani& scala, double angle_deg) {
    const Section section = scala.section(degrees(angle_deg).si());
    return (section.outerRadius - section.innerRadius) / section.outerRadius;
  };
  for (const double angle_deg : {90.0, 270.0, 400.0})
    EXPECT_NEAR(width(own, angle_deg) / width(**typical, angle_deg), 0.85, 0.01) << angle_deg;
}

/// amplitude cos(frequency angle + phase).
AngularVariation cosine(double amplitude, double frequency, double phase = 0.0)
{
  AngularVariation variation;
  variation.amplitude = amplitude;
  // the others are zero at every angle
  for (auto& wave : variation.waves) wave = {0.0, 0.5 * pi};
  variation.waves[0] = {frequency, phase};
  return variation;
}

double height_mm(const ScalaTympani& scala);

class VariedShape : public testing::Test {
protected:
  std::shared_ptr<const ScalaTympani> build(const IndividualShape& shape, const BasalTurn& turn)
  {
    const auto built = buildMean("varied", turn, shape, Length{});
    EXPECT_TRUE(built) << built.error().message;
    return *built;
  }
  BasalTurn turn_{millimeters(9.3), millimeters(6.7), millimeters(3.9)};
  IndividualShape plain_{likeliestHalfDiameters(turn_.a, turn_.b)};
};

TEST_F(VariedShape, KeepsABAndHWithSectionsCourseAndRadiusThatVary)
{
  IndividualShape shape = plain_;
  shape.sections = cosine(0.15, 0.5);
  shape.course = cosine(0.2e-3, 2.0, 1.0);
  shape.radius = cosine(0.02, 1.5, 0.3);
  const auto scala = build(shape, turn_);
  const auto outer = [&](double angle_deg) {
    return scala->section(degrees(angle_deg).si()).outerRadius * 1e3;
  };
  EXPECT_NEAR(outer(0.0) + outer(180.0), 9.3, 0.02);
  EXPECT_NEAR(outer(90.0) + outer(270.0), 6.7, 0.02);
  EXPECT_NEAR(height_mm(*scala), 3.9, 0.02);
}

TEST_F(VariedShape, HasTheFactorsAndTheCourseThatWereGiven)
{
  IndividualShape shape = plain_;
  shape.sections = cosine(0.1, 1.0);
  shape.course = cosine(0.2e-3, 1.0);
  turn_.h = std::nullopt;
  const auto scala = build(shape, turn_), typical = build(plain_, turn_);
  for (const double angle_deg : {90.0, 180.0, 270.0, 360.0, 450.0}) {
    const double angle = degrees(angle_deg).si();
    const Section a = scala->section(angle), b = typical->section(angle);
    const double factor = std::exp(0.1 * std::cos(angle));
    EXPECT_NEAR((a.roofHeight - a.floorHeight) / (b.roofHeight - b.floorHeight), factor, 0.005);
    EXPECT_NEAR((a.outerRadius - a.innerRadius) / (b.outerRadius - b.innerRadius), factor, 0.01);
    EXPECT_NEAR(1e3 * (a.centerHeight - b.centerHeight), 0.2 * std::cos(angle), 0.01);
  }
}

TEST_F(VariedShape, HasAFactorOfTheHeightThatWasNotMeasured)
{
  turn_.h = std::nullopt;
  IndividualShape shape = plain_;
  shape.height = 1.1;
  EXPECT_NEAR(height_mm(*build(shape, turn_)) / height_mm(*build(plain_, turn_)), 1.1, 0.005);
}

TEST_F(VariedShape, LeavesTheAxisBesideTheWidestSections)
{
  IndividualShape shape = plain_;
  shape.section = 1.4;
  const auto scala = build(shape, turn_);
  for (double angle_deg = 0.0; angle_deg <= 850.0; angle_deg += 10.0)
    EXPECT_GT(scala->section(degrees(angle_deg).si()).innerRadius, 0.0) << angle_deg;
}

TEST(Population, TurnsTwoTurnsAndTwoThirds)
{
  EXPECT_NEAR(turnAngle(meanHalfDiameters()) / degrees(360), 2.686, 0.0005);
}

TEST(Population, HasThePublishedDiameters)
{
  EXPECT_NEAR(inMillimeters(spreadOfA().mean), 9.23, 1e-9);
  EXPECT_NEAR(inMillimeters(spreadOfA().standardDeviation), 0.43, 0.005);
  EXPECT_NEAR(inMillimeters(spreadOfB().mean), 6.80, 1e-9);
  EXPECT_NEAR(inMillimeters(spreadOfB().standardDeviation), 0.36, 0.005);
}

TEST(Population, HasThePublishedOuterWall)
{
  const HalfDiameters mean = meanHalfDiameters();
  const auto radius_mm = [&](double angle_deg) {
    return outerWallRadius(mean, degrees(angle_deg)) * 1e3;
  };
  EXPECT_NEAR(radius_mm(0), 5.745, 0.001);
  EXPECT_NEAR(radius_mm(90), 4.331, 0.002);
  // A and B of the fitted spiral
  EXPECT_NEAR(radius_mm(0) + radius_mm(180), 9.06, 0.01);
  EXPECT_NEAR(radius_mm(90) + radius_mm(270), 6.95, 0.01);
}

TEST(LikeliestHalfDiameters, AddUpToWhatIsGiven)
{
  const HalfDiameters half = likeliestHalfDiameters(millimeters(8.4), millimeters(7.1));
  EXPECT_NEAR(inMillimeters(half.a()), 8.4, 1e-9);
  EXPECT_NEAR(inMillimeters(half.b()), 7.1, 1e-9);
}

TEST(LikeliestHalfDiameters, OfTheMeanAreTheMean)
{
  const HalfDiameters half = likeliestHalfDiameters(millimeters(9.23), millimeters(6.80));
  EXPECT_NEAR(half.a1, 5.97e-3, 1e-12);
  EXPECT_NEAR(half.b2, 2.85e-3, 1e-12);
}

TEST(LikeliestHalfDiameters, LeaveAResidualUncorrelatedWithAAndB)
{
  // Property of a regression: the residual of each half-diameter is uncorrelated with A and B.
  const auto covariance = halfDiameterCovariance();
  const auto slope = [](int by) {
    const double nudge = 0.1;
    const HalfDiameters at = likeliestHalfDiameters(millimeters(9.23 + (by == 0 ? nudge : 0.0)),
                                                    millimeters(6.80 + (by == 1 ? nudge : 0.0)));
    const HalfDiameters mean = meanHalfDiameters();
    return std::array<double, 4>{
        (at.a1 - mean.a1) / (nudge / 1e3), (at.b1 - mean.b1) / (nudge / 1e3),
        (at.a2 - mean.a2) / (nudge / 1e3), (at.b2 - mean.b2) / (nudge / 1e3)};
  };
  const auto byA = slope(0), byB = slope(1);
  const auto& s = covariance;
  const double aa = s[0][0] + 2.0 * s[0][2] + s[2][2];
  const double bb = s[1][1] + 2.0 * s[1][3] + s[3][3];
  const double ab = s[0][1] + s[0][3] + s[2][1] + s[2][3];
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(s[i][0] + s[i][2], byA[i] * aa + byB[i] * ab, 1e-15);
    EXPECT_NEAR(s[i][1] + s[i][3], byA[i] * ab + byB[i] * bb, 1e-15);
  }
}

class SampleOf10000 : public testing::Test {
protected:
  static constexpr int size = 10'000;

  void SetUp() override
  {
    for (int seed = 1; seed <= size; ++seed) {
      const HalfDiameters half = sampleHalfDiameters(static_cast<std::uint64_t>(seed));
      drawn_mm.push_back({half.a1 * 1e3, half.b1 * 1e3, half.a2 * 1e3, half.b2 * 1e3});
    }
    for (const auto& one : drawn_mm)
      for (std::size_t i = 0; i < 4; ++i) mean_mm[i] += one[i] / size;
  }

  double covariance(std::size_t i, std::size_t k) const
  {
    double sum = 0.0;
    for (const auto& one : drawn_mm) sum += (one[i] - mean_mm[i]) * (one[k] - mean_mm[k]);
    return sum / (size - 1);
  }

  std::vector<std::array<double, 4>> drawn_mm;
  std::array<double, 4> mean_mm{};
};

TEST_F(SampleOf10000, HasThePublishedMeansAndDeviations)
{
  // Pietsch et al. 2017; four standard errors: 4 SD / 100 for a mean, 4 SD / 141 for an SD
  const std::array<double, 4> mean{5.97, 3.95, 3.26, 2.85},
      standardDeviation{0.36, 0.35, 0.28, 0.33};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(mean_mm[i], mean[i], 0.04 * standardDeviation[i]) << i;
    EXPECT_NEAR(std::sqrt(covariance(i, i)), standardDeviation[i], 0.029 * standardDeviation[i])
        << i;
  }
}

TEST_F(SampleOf10000, HasThePublishedCorrelations)
{
  const double published[4][4] = {{1.0, 0.53476, -0.12441, -0.07296},
                                  {0.53476, 1.0, 0.11668, -0.43748},
                                  {-0.12441, 0.11668, 1.0, 0.57846},
                                  {-0.07296, -0.43748, 0.57846, 1.0}};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_NEAR(covariance(i, k) / std::sqrt(covariance(i, i) * covariance(k, k)),
                  published[i][k], 0.04)  // four standard errors
          << i << " " << k;
}

TEST_F(SampleOf10000, IsNormallyDistributed)
{
  // 68.27 % within one standard deviation, 95.45 % within two; four standard errors of a fraction
  int one = 0, two = 0;
  for (const auto& drawn : drawn_mm) {
    one += std::fabs(drawn[2] - 3.26) < 0.28 ? 1 : 0;
    two += std::fabs(drawn[2] - 3.26) < 0.56 ? 1 : 0;
  }
  EXPECT_NEAR(one, 0.6827 * size, 4.0 * std::sqrt(size * 0.6827 * 0.3173));
  EXPECT_NEAR(two, 0.9545 * size, 4.0 * std::sqrt(size * 0.9545 * 0.0455));
}

TEST(Sample, OfTheSameSeedIsTheSame)
{
  EXPECT_EQ(sampleHalfDiameters(5).a1, sampleHalfDiameters(5).a1);
  EXPECT_NE(sampleHalfDiameters(5).a1, sampleHalfDiameters(6).a1);
}

std::shared_ptr<const ScalaTympani> patient(double a_mm, double b_mm,
                                            std::optional<double> h_mm = {})
{
  BasalTurn turn{millimeters(a_mm), millimeters(b_mm), std::nullopt};
  if (h_mm) turn.h = millimeters(*h_mm);
  const auto built = buildMean("p", turn, millimeters(1));
  if (!built) throw std::runtime_error(built.error().message);
  return *built;
}

double outer_mm(const ScalaTympani& scala, double angle_deg)
{
  return scala.section(degrees(angle_deg).si()).outerRadius * 1e3;
}

double height_mm(const ScalaTympani& scala)
{
  double low = 1.0, high = -1.0;
  for (double angle_deg = 0; angle_deg <= 900; angle_deg += 1.5) {
    const Section section = scala.section(degrees(angle_deg).si());
    low = std::min(low, section.floorHeight);
    high = std::max(high, section.roofHeight);
  }
  return (high - low) * 1e3;
}

TEST(ScaledMean, MeasuresBackWhatThePatientHas)
{
  struct Given {
    double a_mm, b_mm, h_mm;
  };
  for (const Given& given : {Given{9.23, 6.80, 4.0}, Given{8.2, 6.1, 3.4}, Given{10.3, 7.5, 4.5},
                             Given{8.6, 7.4, 3.9}, Given{10.0, 6.2, 4.2}}) {
    const auto scala = patient(given.a_mm, given.b_mm, given.h_mm);
    EXPECT_NEAR(outer_mm(*scala, 0) + outer_mm(*scala, 180), given.a_mm, 0.02);
    EXPECT_NEAR(outer_mm(*scala, 90) + outer_mm(*scala, 270), given.b_mm, 0.02);
    EXPECT_NEAR(height_mm(*scala), given.h_mm, 0.02);
  }
}

TEST(ScaledMean, OfTheMeansOwnDiametersIsTheMean)
{
  const auto mean = buildMean(millimeters(1));
  ASSERT_TRUE(mean);
  const auto scala = patient(outer_mm(**mean, 0) + outer_mm(**mean, 180),
                             outer_mm(**mean, 90) + outer_mm(**mean, 270));
  const double spline = test::tolerance(5e-6, "measured through splines");
  for (double angle_deg = 0; angle_deg <= 900; angle_deg += 45)
    for (const double direction : {0.0, 1.5, 3.0, 4.5})
      EXPECT_NEAR((scala->wall_W(degrees(angle_deg).si(), direction) -
                   (*mean)->wall_W(degrees(angle_deg).si(), direction))
                      .norm(),
                  0.0, spline);
}

TEST(ScaledMean, KeepsTheShapeOfItsSections)
{
  const auto mean = buildMean(millimeters(1));
  ASSERT_TRUE(mean);
  const auto scala = patient(8.3, 6.2);
  for (double angle_deg = 20; angle_deg < 850; angle_deg += 50) {
    const Section a = scala->section(degrees(angle_deg).si());
    const Section b = (*mean)->section(degrees(angle_deg).si());
    const double slim = (a.outerRadius - a.innerRadius) / (a.roofHeight - a.floorHeight);
    EXPECT_NEAR(slim, (b.outerRadius - b.innerRadius) / (b.roofHeight - b.floorHeight), 0.005);
  }
}

TEST(ScaledMean, ExistsAtEveryCornerOfTheLimits)
{
  for (const Length a : {spreadOfA().low, spreadOfA().high})
    for (const Length b : {spreadOfB().low, spreadOfB().high})
      for (const Length h : {limitsOfH().low, limitsOfH().high}) {
        const auto scala = patient(inMillimeters(a), inMillimeters(b), inMillimeters(h));
        for (double angle_deg = 0; angle_deg <= 900; angle_deg += 30) {
          const Section section = scala->section(degrees(angle_deg).si());
          EXPECT_GT(section.innerRadius, 0.0) << angle_deg;
          EXPECT_GT(section.area, 0.0) << angle_deg;
        }
      }
}

TEST(SamplePatient, SharesNoneBetweenNeighboringStudies)
{
  const auto measuresOf = [](std::uint64_t study, std::uint64_t number) {
    const auto patient = samplePatient(study, number);
    return patient ? std::pair(patient->basalTurn->a.si(), patient->basalTurn->b.si())
                   : std::pair(0.0, 0.0);
  };
  EXPECT_EQ(measuresOf(1, 7), measuresOf(1, 7));
  EXPECT_NE(measuresOf(1, 7), measuresOf(1, 8));
  EXPECT_NE(measuresOf(1, 1'000'002), measuresOf(2, 1));
}

}  // namespace
}  // namespace perilymph::anatomy
