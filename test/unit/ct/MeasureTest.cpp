// SPDX-License-Identifier: BSD-3-Clause

// Measurement of phantoms with known ground truth.

#include "perilymph/ct/Measures.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <cstring>
#include <stop_token>

#include "MeasuredPhantom.h"
#include "perilymph/anatomy/DuctLength.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/test/CtPhantom.h"

namespace perilymph::ct {
namespace {

TEST(MeasureCochlea, FindsThePhantomsDiametersWithinThreeOfItsSigmas)
{
  EXPECT_NEAR(measures().a.value, phantom().a, 3.0 * measures().a.sd());
  EXPECT_NEAR(measures().b.value, phantom().b, 3.0 * measures().b.sd());
  EXPECT_NEAR(measures().h.value, phantom().h, 3.0 * measures().h.sd());
}

TEST(MeasureCochlea, FindsThePhantomsAxisAndRoundWindow)
{
  EXPECT_GT(measures().axis_P.dot(phantom().axis_P), std::cos(degrees(4.0).si()));
  EXPECT_LT((measures().roundWindow_P - phantom().roundWindow_P).norm(), 0.6);
}

TEST(MeasureCochlea, FromGivenStartsFindsTheSameCochleaWithoutAClick)
{
  const auto startAt = [](const Eigen::Vector3d& shift, double turn_deg) {
    const Eigen::Matrix3d turned =
        Eigen::AngleAxisd(degrees(turn_deg).si(), Eigen::Vector3d(2.0, -1.0, 1.0).normalized())
            .toRotationMatrix();
    const auto moved = [&](const Eigen::Vector3d& at_P) {
      return Eigen::Vector3d(measures().center_P + shift + turned * (at_P - measures().center_P));
    };
    return CochleaStart{moved(measures().roundWindow_P), moved(measures().center_P),
                        moved(measures().center_P + 4.0 * measures().axis_P), measures().side};
  };
  MeasureRequest request;
  request.starts = {startAt({5.0, 4.0, -3.0}, 100.0), startAt({0.6, -0.5, 0.6}, 15.0)};
  const auto found = measureCochlea(phantom().volume, request);
  ASSERT_TRUE(found) << found.error().message;
  // both fits end at the smallest misfit; what differs is far below the stated error
  EXPECT_NEAR(found->a.value, measures().a.value, 0.3 * measures().a.sd());
  EXPECT_NEAR(found->b.value, measures().b.value, 0.3 * measures().b.sd());
  EXPECT_LT((found->roundWindow_P - measures().roundWindow_P).norm(), 0.2);
}

TEST(MeasureCochlea, HasAnAxisNearThatOfTheSpiralMotionOfItsWall)
{
  EXPECT_GT(measures().kinematicTilt_deg, 0.0);
  EXPECT_LT(measures().kinematicTilt_deg, 15.0);
}

TEST(MeasureCochlea, FindsTheSideOfBothEars)
{
  EXPECT_EQ(measures().side == anatomy::Side::right, phantom().isRight);
  for (std::uint64_t seed = 510;; ++seed) {
    const test::CtPhantom ear = test::makeCtPhantom(seed, test::clinicalScan());
    if (ear.isRight == phantom().isRight) continue;
    const auto found = measureCochlea(ear.volume, clickedInto(ear, seed));
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found->side == anatomy::Side::right, ear.isRight) << seed;
    break;
  }
}

TEST(MeasureCochlea, GivesTheDuctLengthTheErrorThatPagesAndFilesComputeFromTheMeasures)
{
  const CochleaMeasures& found = measures();
  const Length a = millimeters(found.a.value), b = millimeters(found.b.value);
  const double byMeasures = inMillimeters(
      anatomy::ductLengthError(a, b, {millimeters(found.a.sd()), millimeters(found.b.sd())}));
  ASSERT_TRUE(found.cdlOc);
  EXPECT_NEAR(found.cdlOc->value, inMillimeters(anatomy::ellipticCircularDuctLength(a, b)), 1e-12);
  EXPECT_NEAR(found.cdlOc->sd(),
              std::hypot(byMeasures, inMillimeters(anatomy::ductLengthFormulaError(a, b))), 1e-9);
}

TEST(MeasureCochlea, KeepsTheErrorsApartAndAddsTheirSquares)
{
  const Measure& a = measures().a;
  EXPECT_GT(a.statistical, 0.0);
  EXPECT_GT(a.model, 0.0);
  EXPECT_GT(a.definition, 0.0);
  EXPECT_NEAR(a.sd(), std::hypot(a.statistical, a.model, a.definition), 1e-12);
  EXPECT_NEAR(a.interval95()[1] - a.interval95()[0], 2.0 * 1.96 * a.sd(), 1e-12);
}

TEST(MeasureCochlea, GivesAFrameWhoseHandednessIsTheEars)
{
  const double determinant = measures().axes_PW.determinant();
  EXPECT_NEAR(determinant, measures().side == anatomy::Side::right ? 1.0 : -1.0, 1e-9);
  const Eigen::Vector3d toWindow = measures().roundWindow_P - measures().center_P;
  EXPECT_NEAR(toWindow.normalized().dot(measures().axes_PW.col(0)), 1.0, 1e-9);
}

TEST(MeasureCochlea, GivesTheSameBitsTwice)
{
  const auto again = measureCochlea(phantom().volume, clickedInto(phantom(), 501));
  ASSERT_TRUE(again);
  EXPECT_EQ(std::memcmp(&again->a.value, &measures().a.value, sizeof(double)), 0);
  EXPECT_EQ(std::memcmp(again->axis_P.data(), measures().axis_P.data(), 3 * sizeof(double)), 0);
}

TEST(MeasureCochlea, FlagsTheOtherEarAsMirrored)
{
  MeasureRequest request = clickedInto(phantom(), 501);
  request.side = phantom().isRight ? anatomy::Side::left : anatomy::Side::right;
  const auto found = measureCochlea(phantom().volume, request);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->has(Flag::mirrored));
  EXPECT_FALSE(measures().has(Flag::mirrored));
}

TEST(MeasureCochlea, FlagsAirInTheCochlea)
{
  test::PhantomScan scan = test::highResolutionScan();
  scan.isAirFilled = true;
  const test::CtPhantom dry = test::makeCtPhantom(502, scan);
  const auto found = measureCochlea(dry.volume, clickedInto(dry, 502));
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_TRUE(found->has(Flag::airInCochlea));
  EXPECT_FALSE(measures().has(Flag::airInCochlea));
}

TEST(MeasureCochlea, TellsItsProgressAndCanBeCanceled)
{
  MeasureRequest request = clickedInto(phantom(), 501);
  double last = 0.0;
  bool isGrowing = true;
  std::stop_source stop;
  request.onProgress = [&](double fraction) {
    isGrowing = isGrowing && fraction >= last && fraction <= 1.0;
    last = fraction;
    if (last > 0.4) stop.request_stop();
  };
  request.stop = stop.get_token();
  const auto found = measureCochlea(phantom().volume, request);
  EXPECT_FALSE(found);
  EXPECT_TRUE(isGrowing);
  EXPECT_GT(last, 0.4);
}

TEST(MeasureCochlea, FindsTheCochleaWithoutAClick)
{
  const auto found = measureCochlea(phantom().volume, {});
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->a.value, phantom().a, 3.0 * found->a.sd());
  EXPECT_EQ(found->side, measures().side);
}

TEST(MeasureCochlea, FlagsALandmarkThatTheVoxelsContradictAndHardlyMovesTheFit)
{
  MeasureRequest request = clickedInto(phantom(), 501);
  const Eigen::Vector3d outward =
      (*phantom().marks[Mark::farB] - *phantom().marks[Mark::modiolus]).normalized();
  request.marks[Mark::farB] = *phantom().marks[Mark::farB] + 1.5 * outward;
  const auto after = measureCochlea(phantom().volume, request);
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_TRUE(after->has(Flag::landmarkContradicted));
  EXPECT_FALSE(measures().has(Flag::landmarkContradicted));
  EXPECT_NEAR(after->b.value, measures().b.value, 0.3);
}

TEST(MeasureCochlea, RefusesAClickOutside)
{
  MeasureRequest request;
  request.click_P = phantom().volume.toLps({-50.0, 0.0, 0.0});
  const auto found = measureCochlea(phantom().volume, request);
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().message.find("outside"), std::string::npos);
}

TEST(MeasureCochlea, RefusesLongVoxels)
{
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  lps(2, 2) = 1.5;
  const auto volume = CtVolume::make({8, 8, 8}, lps, std::vector<std::int16_t>(512));
  ASSERT_TRUE(volume);
  const auto found = measureCochlea(*volume, {});
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().message.find("1.5"), std::string::npos);
}

TEST(MeasureCochlea, RefusesAVolumeOfOneGray)
{
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity() * 0.5;
  lps(3, 3) = 1.0;
  const auto volume = CtVolume::make({40, 40, 40}, lps, std::vector<std::int16_t>(64000, 1500));
  ASSERT_TRUE(volume);
  EXPECT_FALSE(measureCochlea(*volume, {}));
}

TEST(Flags, HaveNamesAndSentencesOfTheirOwn)
{
  const std::vector<Flag> flags = allFlags();
  for (std::size_t i = 0; i < flags.size(); ++i) {
    EXPECT_GT(sentenceOf(flags[i]).size(), 20U);
    for (std::size_t k = 0; k < i; ++k) EXPECT_STRNE(nameOf(flags[i]), nameOf(flags[k]));
  }
}

}  // namespace
}  // namespace perilymph::ct
