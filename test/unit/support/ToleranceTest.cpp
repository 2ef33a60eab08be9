// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/Tolerance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>

namespace perilymph::test {
namespace {

/// Restores the variable: a run with true residuals must reach every test.
class ToleranceScale : public ::testing::Test {
protected:
  ToleranceScale()
  {
    if (const char* const value = std::getenv(name)) before_ = value;
  }
  ~ToleranceScale() override
  {
    if (before_)
      setenv(name, before_->c_str(), 1);
    else
      unsetenv(name);
  }

  static constexpr const char* name = "PERILYMPH_TOLERANCE_SCALE";

private:
  std::optional<std::string> before_;
};

TEST_F(ToleranceScale, LeavesTolerancesAloneWhenUnset)
{
  unsetenv(name);
  EXPECT_EQ(tolerance(0.25, "an exact binary fraction"), 0.25);
}

TEST_F(ToleranceScale, OfZeroShowsTrueResiduals)
{
  setenv(name, "0", 1);
  EXPECT_EQ(tolerance(0.25, "an exact binary fraction"), 0.0);
}

TEST_F(ToleranceScale, ThatIsNoNumberIsRefused)
{
  for (const char* const error : {"tight", "1x", "-1", "nan", "inf"}) {
    setenv(name, error, 1);
    EXPECT_THROW(tolerance(0.25, "any"), std::invalid_argument) << error;
  }
}

TEST_F(ToleranceScale, IsNoExcuseForAToleranceWithoutReasonOrBelowZero)
{
  unsetenv(name);
  EXPECT_THROW(tolerance(0.25, ""), std::invalid_argument);
  EXPECT_THROW(tolerance(-0.25, "any"), std::invalid_argument);
  EXPECT_THROW(tolerance(std::nan(""), "any"), std::invalid_argument);
}

}  // namespace
}  // namespace perilymph::test
