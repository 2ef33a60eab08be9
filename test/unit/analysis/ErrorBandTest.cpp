// SPDX-License-Identifier: BSD-3-Clause

// Error bands against the effect of a tenth of a millimeter in the formulas themselves.

#include "perilymph/analysis/ErrorBand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "perilymph/anatomy/DuctLength.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::analysis {
namespace {

std::map<std::string, double> bandsOf(const anatomy::Cochlea& cochlea)
{
  const auto measures = measure(**buildAnatomy(cochlea, "the test"), cochlea);
  const auto bands = errorBands(cochlea, measures);
  EXPECT_TRUE(bands);
  std::map<std::string, double> named;
  for (std::size_t i = 0; i < bands->size(); ++i) named[measures[i].key] = (*bands)[i];
  return named;
}

TEST(ErrorBands, OfTheThreeLengthsAreTheLengthsOwn)
{
  auto bands = bandsOf({});
  const double rebuilt = test::tolerance(3e-3, "rounded corners of the built sections");
  EXPECT_NEAR(bands["st_length_mm"], 0.196, rebuilt);
  EXPECT_NEAR(bands["rw_width_mm"], 0.196, rebuilt);
  EXPECT_NEAR(bands["rw_height_mm"], 0.196, rebuilt);
}

TEST(ErrorBands, OfDiametersFollowTheClinicsFormulas)
{
  anatomy::Cochlea cochlea;
  cochlea.source = anatomy::AnatomySource::mean;
  cochlea.patient.basalTurn = {millimeters(9.2), millimeters(6.8), std::nullopt};
  auto bands = bandsOf(cochlea);
  // A and B measure back within 0.02 mm, so their bands do within a few hundredths
  EXPECT_NEAR(bands["A_mm"], 0.196, test::tolerance(0.04, "measured back"));
  EXPECT_NEAR(bands["B_mm"], 0.196, test::tolerance(0.04, "measured back"));
  // By hand: the elliptic-circular length is 33.40 mm and changes by 1.408 a millimeter of A, 3.737 of B; 4.16 A -
  // 4 is 0.87 mm more.
  EXPECT_NEAR(bands["cdl_oc_mm"], 1.170, test::tolerance(0.08, "measured back"));
}

/// The model's own A and B, between the knots of its splines, are some ten-thousandths smaller.
TEST(ErrorBands, AndTheDuctLengthOfAPatientAreThoseOfTheStatedAAndB)
{
  anatomy::Cochlea cochlea;
  cochlea.source = anatomy::AnatomySource::mean;
  const Length a = millimeters(9.2), b = millimeters(6.8);
  cochlea.patient.basalTurn = {a, b, std::nullopt};
  anatomy::BasalTurnErrors errors{millimeters(0.12), millimeters(0.21), std::nullopt};
  errors.ab = 0.4;
  cochlea.patient.errors = errors;
  // by hand: L = 1.18 x 8.2 + 2.69 x 5.8 - sqrt(0.72 x 8.2 x 5.8) = 19.42623, 1.71 L + 0.18
  for (const Measure& each : measure(**buildAnatomy(cochlea, "the test"), cochlea))
    if (each.key == "cdl_oc_mm") {
      EXPECT_NEAR(each.value, 33.39886, test::tolerance(1e-5, "digits of the calculation by hand"));
    }
  const double page = 1.96 * std::hypot(inMillimeters(anatomy::ductLengthError(a, b, errors)),
                                        inMillimeters(anatomy::ductLengthFormulaError(a, b)));
  EXPECT_NEAR(bandsOf(cochlea)["cdl_oc_mm"], page, test::tolerance(1e-9, "rounding"));
}

TEST(ErrorBands, UseTheErrorsThatTheMeasurementStates)
{
  anatomy::Cochlea cochlea;
  cochlea.source = anatomy::AnatomySource::mean;
  cochlea.patient.basalTurn = {millimeters(9.2), millimeters(6.8), std::nullopt};
  cochlea.patient.errors = {millimeters(0.3), millimeters(0.05), std::nullopt};
  auto bands = bandsOf(cochlea);
  EXPECT_NEAR(bands["A_mm"], 0.588, test::tolerance(0.06, "measured back"));
  EXPECT_NEAR(bands["B_mm"], 0.098, test::tolerance(0.04, "measured back"));
  EXPECT_NEAR(bands["cdl_oc_mm"], 1.256, test::tolerance(0.08, "measured back"));
}

TEST(ErrorBands, UseTheCorrelationsOfTheErrors)
{
  anatomy::Cochlea cochlea;
  cochlea.source = anatomy::AnatomySource::mean;
  cochlea.patient.basalTurn = {millimeters(9.2), millimeters(6.8), std::nullopt};
  const auto bandAt = [&](double correlation) {
    cochlea.patient.errors = {millimeters(0.3), millimeters(0.3), std::nullopt, correlation};
    return bandsOf(cochlea)["cdl_oc_mm"];
  };
  // by hand, as above: 1.96 sqrt(0.422^2 + 1.121^2 + 2 r 0.422 1.121) and the formula's 0.87
  EXPECT_NEAR(bandAt(0.7), 2.969, test::tolerance(0.12, "measured back"));
  EXPECT_NEAR(bandAt(-0.7), 1.930, test::tolerance(0.12, "measured back"));
}

TEST(ErrorOfTheDuctLength, IsThatOfAAndBWithTheirCorrelation)
{
  // by hand, as above: 0.422 mm for 0.3 mm of A, 1.121 mm for 0.3 mm of B
  for (const double r : {-0.9, -0.5, 0.0, 0.5, 0.9}) {
    const anatomy::BasalTurnErrors errors{millimeters(0.3), millimeters(0.3), std::nullopt, r};
    const double expected = std::sqrt(0.422 * 0.422 + 1.121 * 1.121 + 2.0 * r * 0.422 * 1.121);
    EXPECT_NEAR(inMillimeters(anatomy::ductLengthError(millimeters(9.2), millimeters(6.8), errors)),
                expected, test::tolerance(0.01, "curvature over 0.3 mm"));
  }
}

TEST(ErrorBands, HoldAtTheEdgeOfWhatIsAllowed)
{
  anatomy::Cochlea cochlea;
  cochlea.patient.scalaTympaniLength = anatomy::patientLimits().lengthHigh;
  EXPECT_NEAR(bandsOf(cochlea)["st_length_mm"], 0.196, test::tolerance(3e-3, "rebuilt"));
}

TEST(ErrorBands, AreNotClaimedForAnAnatomyAsMeasured)
{
  anatomy::Cochlea cochlea;
  cochlea.source = anatomy::AnatomySource::mean;
  EXPECT_TRUE(bandsOf(cochlea).empty());
}

}  // namespace
}  // namespace perilymph::analysis
