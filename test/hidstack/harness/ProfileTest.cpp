// SPDX-License-Identifier: BSD-3-Clause

// The virtual handle's own report definitions compared with those that the device layer derives
// from its descriptor and profile.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "HandleReports.h"
#include "VirtualHandle.h"
#include "codec/DeviceCodec.h"
#include "codec/DeviceProfile.h"
#include "codec/ReportDescriptor.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::hidstack {
namespace {

device::DeviceProfile profile()
{
  auto read = device::loadProfile(test::projectFolder() / "test/hidstack/virtual_handle.toml");
  EXPECT_TRUE(read) << (read ? "" : read.error().message);
  return *std::move(read);
}

device::ReportDescriptor descriptor()
{
  auto parsed = device::ReportDescriptor::parse(reportDescriptor());
  EXPECT_TRUE(parsed) << (parsed ? "" : parsed.error().message);
  return *std::move(parsed);
}

std::unique_ptr<device::DeviceCodec> codec()
{
  auto made = device::makeCodec(profile(), descriptor());
  EXPECT_TRUE(made) << (made ? "" : made.error().message);
  return *std::move(made);
}

TEST(VirtualHandleProfile, DescribesReportsAsLongAsTheHandleSends)
{
  EXPECT_TRUE(descriptor().isNumbered());
  EXPECT_EQ(descriptor().reportBytes(device::ReportKind::input, inputNumber), inputSize - 1);
  EXPECT_EQ(descriptor().reportBytes(device::ReportKind::output, outputNumber), outputSize - 1);
}

TEST(VirtualHandleProfile, FitsTheHandleThatIsPluggedIn)
{
  const device::DeviceProfile one = profile();
  const device::HidIdentity identity{vendor, product, -1};
  EXPECT_NE(device::matchingProfile({&one, 1}, identity, descriptor()), nullptr);
  EXPECT_EQ(one.traits.maxForce, maxForce);
}

TEST(VirtualHandleProfile, ReadsPlaceButtonAndCountAsTheyWereSent)
{
  InputReport sent;
  sent.sequence = 40'000;
  sent.place = {15'000, -20'000, -123'456};
  sent.buttons = 1;
  const auto bytes = encode(sent);
  device::RawReport report;
  std::copy(bytes.begin(), bytes.end(), report.bytes.begin());
  report.size = bytes.size();

  device::DeviceSample hand;
  EXPECT_EQ(codec()->decode(report, hand), 40'000u);
  EXPECT_NE(hand.buttons & device::graspButton, 0u);
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(hand.position_D[axis], placeQuantum * sent.place[axis],
                test::tolerance(1e-12, "rounding"));
}

TEST(VirtualHandleProfile, SendsAForceThatTheHandleUnderstands)
{
  device::ReportList reports;
  codec()->encode({{0.1, -0.2, 3.0}, {}}, reports);
  ASSERT_EQ(reports.count, 1u);
  const auto heard = decodeOutput(reports.reports[0].view());
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->force, (std::array<std::int16_t, 3>{1000, -2000, 30'000}));
}

}  // namespace
}  // namespace perilymph::hidstack
