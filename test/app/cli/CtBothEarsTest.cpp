// SPDX-License-Identifier: BSD-3-Clause

// `ct measure --side both`: two searches in a whole head, a stage of test/run --long.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "perilymph/test/Cli.h"
#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/DicomWriter.h"

namespace perilymph::test {
namespace {

using Json = nlohmann::json;

Json jsonOf(const std::filesystem::path& file) { return Json::parse(contentOf(file)); }

TEST(BothEars, AreMeasuredAsEachAlone)
{
  TemporaryFolder out;
  const TwoEars head = makeTwoEars(601, clinicalScan(), 45.0);
  writeDicomFiles(dicomSlices(head.volume), out / "head");
  const auto both =
      cli({"ct", "measure", out / "head", "--side", "both", "--json", out / "both.json"});
  ASSERT_EQ(both.status, 0) << both.err;
  Json ears = jsonOf(out / "both.json").at("ears");
  ASSERT_EQ(ears.size(), 2u);
  EXPECT_EQ(ears[0].at("side"), "right");
  EXPECT_EQ(ears[1].at("side"), "left");
  EXPECT_NEAR(ears[0].at("A_mm").at("value").get<double>(), head.right.a, 0.6);
  EXPECT_NEAR(ears[1].at("A_mm").at("value").get<double>(), head.left.a, 0.6);
  const auto left =
      cli({"ct", "measure", out / "head", "--side", "left", "--json", out / "left.json"});
  ASSERT_EQ(left.status, 0) << left.err;
  Json alone = jsonOf(out / "left.json");
  alone.erase("seconds");
  ears[1].erase("seconds");
  EXPECT_EQ(alone, ears[1]);
}

TEST(BothEars, FailWhereOneIsMissing)
{
  TemporaryFolder out;
  const CtPhantom ear = makeCtPhantom(203, highResolutionScan());
  writeDicomFiles(dicomSlices(ear.volume), out / "ct");
  expectRefusal(cli({"ct", "measure", out / "ct", "--side", "both", "--json", out / "both.json"}),
                ear.isRight ? "No left cochlea" : "No right cochlea");
  EXPECT_FALSE(std::filesystem::exists(out / "both.json"));
}

}  // namespace
}  // namespace perilymph::test
