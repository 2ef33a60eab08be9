// SPDX-License-Identifier: BSD-3-Clause

// The installed udev rules compared with the shipped profiles.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "codec/DeviceProfile.h"
#include "perilymph/device/HidNodes.h"
#include "perilymph/test/Places.h"

namespace perilymph::device {
namespace {

std::vector<std::string> rules()
{
  std::ifstream stream(test::testData().string() + "/../../packaging/udev/70-perilymph.rules");
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty() && line[0] != '#') lines.push_back(line);
  return lines;
}

/// The rules that the profiles require: one for each product that they name. A profile for whatever
/// else a vendor makes requires none: its other products include keyboards.
std::set<std::string> wanted()
{
  std::set<std::string> wantedRules;
  for (const DeviceProfile& profile : shippedProfiles().profiles)
    for (const DeviceMatch& match : profile.matches)
      if (match.vendor && match.product)
        wantedRules.insert(udevRule(*match.vendor, *match.product));
  return wantedRules;
}

TEST(InstalledUdevRules, AreThoseOfTheDevicesThatAreKnownByNumber)
{
  const auto lines = rules();
  ASSERT_FALSE(wanted().empty());
  EXPECT_EQ(std::set<std::string>(lines.begin(), lines.end()), wanted());
}

TEST(InstalledUdevRules, OpenNothingToEverybody)
{
  for (const std::string& line : rules()) {
    EXPECT_THAT(line, testing::HasSubstr(R"(TAG+="uaccess")"));
    EXPECT_THAT(line, testing::Not(testing::HasSubstr("MODE")));
    EXPECT_THAT(line, testing::Not(testing::HasSubstr("GROUP")));
  }
}

}  // namespace
}  // namespace perilymph::device
