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

/// The rule for all products of a vendor.
std::string vendorRule(std::uint16_t vendor)
{
  std::string rule = udevRule(vendor, 0);
  return rule.replace(rule.find(":0000."), 6, ":");
}

/// The rules that the profiles require; a profile for a whole vendor requires the vendor's rule.
std::set<std::string> wanted()
{
  std::set<std::uint16_t> wholeVendors;
  std::set<std::string> wantedRules;
  const ProfileCatalog catalog = shippedProfiles();
  for (const DeviceProfile& profile : catalog.profiles)
    for (const DeviceMatch& match : profile.matches)
      if (match.vendor && !match.product) wholeVendors.insert(*match.vendor);
  for (const std::uint16_t vendor : wholeVendors) wantedRules.insert(vendorRule(vendor));
  for (const DeviceProfile& profile : catalog.profiles)
    for (const DeviceMatch& match : profile.matches)
      if (match.vendor && match.product && wholeVendors.count(*match.vendor) == 0)
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
