// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/device/PluginDevice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "perilymph/test/Places.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::device {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

std::filesystem::path example() { return test::examplePlugin(); }

std::filesystem::path faulty(const std::string& fault)
{
  return test::testPlugin("faulty_" + fault);
}

/// The next fresh sample.
DeviceSample next(HapticDevice& device)
{
  EXPECT_TRUE(test::waitUntil([&] { return device.await(milliseconds(2)) == Awaited::fresh; }));
  return device.read();
}

std::string refusal(const std::filesystem::path& file)
{
  const auto device = loadPluginDevice(file);
  return device ? "it was taken" : device.error().message;
}

TEST(ExamplePlugin, TellsItsTraits)
{
  const auto device = loadPluginDevice(example());
  ASSERT_TRUE(device) << device.error().message;
  const DeviceTraits traits = (*device)->traits();
  EXPECT_EQ(traits.name, "Example handle");
  EXPECT_EQ(traits.maxForce, 3.0);
  EXPECT_EQ(traits.actuatedTranslations, 1);
}

TEST(ExamplePlugin, DriftsInwardAtTheSpeedOfForceOverDamping)
{
  // 0.2 N against 0.5 N.s/m: 0.4 m/s once 90 g / 0.5 N.s/m = 0.18 s have passed many times.
  const auto device = loadPluginDevice(example());
  ASSERT_TRUE((*device)->open());
  DeviceSample before, after;
  EXPECT_TRUE(test::waitUntil([&] { return (before = next(**device)).sequence >= 3000; }));
  after = next(**device);
  // One read is one millisecond.
  const double time = 1e-3 * static_cast<double>(after.sequence - before.sequence);
  EXPECT_NEAR((after.position_D[2] - before.position_D[2]) / time, -0.4, 1e-6);
}

TEST(ExamplePlugin, IsPushedOutByAForceGreaterThanItsHands)
{
  // 0.4 N outward against 0.2 N inward, and 0.5 N.s/m: the speed goes from -0.4 to 0.4 m/s. A busy
  // machine may take the force away for moments; half of the speed is never reached without it.
  const auto device = loadPluginDevice(example());
  ASSERT_TRUE((*device)->open());
  DeviceSample before = next(**device);
  EXPECT_TRUE(test::waitUntil([&] {
    const DeviceSample hand = next(**device);
    (*device)->write({{0.0, 0.0, 0.4}, {}});
    const double time = 1e-3 * static_cast<double>(hand.sequence - before.sequence);
    const double speed = (hand.position_D[2] - before.position_D[2]) / time;
    before = hand;
    return speed > 0.2;
  }));
}

TEST(ExamplePlugin, AddsTheDelayOfItsProcessToItsTraits)
{
  const auto device = loadPluginDevice(example());
  EXPECT_EQ((*device)->traits().transportDelay, 0.0);
  ASSERT_TRUE((*device)->open());
  EXPECT_GT((*device)->traits().transportDelay, 0.0);
  EXPECT_TRUE((*device)->health()->isGuarded);
}

TEST(ExamplePlugin, AnswersNothingWhileItIsClosed)
{
  const auto device = loadPluginDevice(example());
  EXPECT_EQ((*device)->read().isValid, 0u);
  ASSERT_TRUE((*device)->open());
  EXPECT_EQ(next(**device).isValid, 1u);
  (*device)->close();
  EXPECT_EQ((*device)->read().isValid, 0u);
  ASSERT_TRUE((*device)->open());
  EXPECT_EQ(next(**device).isValid, 1u);
}

TEST(ExamplePlugin, LoadedTwiceHasTwoProcesses)
{
  const auto first = loadPluginDevice(example());
  const auto second = loadPluginDevice(example());
  EXPECT_TRUE(first && second);
}

TEST(FaultyPlugin, IsRefusedWithASentence)
{
  EXPECT_THAT(refusal(faulty("anotherVersion")), HasSubstr("speaks version 2"));
  EXPECT_THAT(refusal(faulty("missingFunction")), HasSubstr("functions is missing"));
  EXPECT_THAT(refusal(faulty("tooShort")), HasSubstr("functions is missing"));
  EXPECT_THAT(refusal(faulty("noDevice")), HasSubstr("finds no device"));
  EXPECT_THAT(refusal(faulty("noName")), HasSubstr("has no name"));
  EXPECT_THAT(refusal(faulty("monstrousForce")), HasSubstr("must be between 0.01 and 50"));
  EXPECT_THAT(refusal(faulty("noTraits")), HasSubstr("does not tell its traits"));
}

TEST(FaultyPlugin, MayLeaveItsTextsOpenAtTheEnd)
{
  const auto device = loadPluginDevice(faulty("cannotOpen"));
  ASSERT_TRUE(device);
  EXPECT_EQ((*device)->traits().name, std::string(64, 'x'));
  const auto opened = (*device)->open();
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().message, std::string(511, 'y'));
}

TEST(FaultyPlugin, ThatTakesNoForceIsNoValidHand)
{
  const auto device = loadPluginDevice(faulty("failsToWrite"));
  ASSERT_TRUE((*device)->open());
  EXPECT_TRUE(test::waitUntil([&] {
    (*device)->await(milliseconds(2));
    return (*device)->read().sequence > 100;
  }));
  EXPECT_EQ((*device)->read().isValid, 0u);
}

TEST(NoPlugin, IsRefusedWithASentence)
{
  const test::TemporaryFolder folder;
  EXPECT_THAT(refusal(folder.path() / "none.so"), HasSubstr("no such file"));
  std::ofstream(folder.path() / "text.so") << "no library";
  EXPECT_THAT(refusal(folder.path() / "text.so"), HasSubstr("cannot be loaded"));
  EXPECT_THAT(refusal(test::testPlugin("empty_plugin")),
              HasSubstr("exports no perilymph_device_v1"));
}

TEST(PluginFolder, ListsLibrariesInItAndOneLevelBelow)
{
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "a" / "b");
  for (const char* name : {"two.so", "a/one.so", "a/b/deep.so", "a/profile.toml"})
    std::ofstream(folder.path() / name) << "x";
  const auto found = pluginLibraries(folder.path());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_THAT(found[0].string(), EndsWith("a/one.so"));
  EXPECT_THAT(found[1].string(), EndsWith("two.so"));
  EXPECT_TRUE(pluginLibraries(folder.path() / "none").empty());
}

}  // namespace
}  // namespace perilymph::device
