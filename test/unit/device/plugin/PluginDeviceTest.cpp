// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/device/PluginDevice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "perilymph/test/Places.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/Tolerance.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::device {
namespace {

namespace fs = std::filesystem;
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
  EXPECT_FALSE(traits.pushesAlong(0));
  EXPECT_TRUE(traits.pushesAlong(2));
  EXPECT_EQ(traits.maxTorque, 0.0);
}

TEST(ExamplePlugin, IsLedInwardAtTwoMillimetersPerSecondAndThenRests)
{
  // Behind the hand by nothing at constant speed: its damper acts on the difference of the speeds.
  const auto device = loadPluginDevice(example());
  ASSERT_TRUE((*device)->open());
  DeviceSample sample;
  EXPECT_TRUE(test::waitUntil([&] { return (sample = next(**device)).sequence >= 2000; }));
  // One read is one millisecond. The grip has settled: 90 g / 4 N.s/m is 22 ms.
  EXPECT_NEAR(sample.position_D[2], -2e-3 * 1e-3 * static_cast<double>(sample.sequence),
              test::tolerance(2.5e-6, "a step of 2 um: the grip acts on the place before it"));
  EXPECT_EQ(sample.buttons, graspButton);
}

TEST(ExamplePlugin, IsPushedOutByAForceAgainstItsGrip)
{
  // 0.4 N against 100 N/m displaces it by 4 mm at rest. A busy machine may take the force away for
  // moments; half of that is never reached without it.
  const auto device = loadPluginDevice(example());
  ASSERT_TRUE((*device)->open());
  EXPECT_TRUE(test::waitUntil([&] {
    const DeviceSample sample = next(**device);
    (*device)->write({{0.0, 0.0, 0.4}, {}});
    const double hand = -2e-3 * 1e-3 * static_cast<double>(sample.sequence);
    return sample.position_D[2] - hand > 2e-3;
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
  EXPECT_THAT(refusal(faulty("anotherVersion")),
              HasSubstr("built for version 2 of PluginApi.h, this program for version 1"));
  EXPECT_THAT(refusal(faulty("laterEntry")),
              HasSubstr("built for version 3 of PluginApi.h, this program for version 1"));
  EXPECT_THAT(refusal(faulty("otherAxes")), HasSubstr("its axes 2 do not match its counts: 2"));
  EXPECT_THAT(refusal(faulty("monstrousTorque")), HasSubstr("between 0.0001 and 10"));
  EXPECT_THAT(refusal(faulty("missingFunction")), HasSubstr("functions is missing"));
  EXPECT_THAT(refusal(faulty("tooShort")), HasSubstr("functions is missing"));
  EXPECT_THAT(refusal(faulty("noDevice")), HasSubstr("finds no device"));
  EXPECT_THAT(refusal(faulty("noName")), HasSubstr("has no name"));
  EXPECT_THAT(refusal(faulty("monstrousForce")), HasSubstr("must be between 0.01 and 50"));
  EXPECT_THAT(refusal(faulty("noTraits")), HasSubstr("does not tell its traits"));
  EXPECT_THAT(refusal(faulty("lineInName")),
              HasSubstr("a line break or another control character"));
  EXPECT_THAT(refusal(faulty("monstrousDelay")),
              HasSubstr("its transport delay is 100 s; it must be between 0 and 0.1."));
  EXPECT_THAT(refusal(faulty("noButton")), HasSubstr("renders force and has no button"));
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
  EXPECT_THAT(refusal(folder.path()), HasSubstr("it is not a file"));
  std::ofstream(folder.path() / "text.so") << "no library";
  EXPECT_THAT(refusal(folder.path() / "text.so"), HasSubstr("not a shared library"));
  EXPECT_THAT(refusal(test::testPlugin("empty_plugin")),
              HasSubstr("exports no perilymph_device_v1"));
}

TEST(NoPlugin, OfAnotherMachineIsRefusedBeforeAnyProcessLoadsIt)
{
  const test::TemporaryFolder folder;
  std::ifstream original(example(), std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(original)), {});
  ASSERT_GT(bytes.size(), 64u);
  bytes[4] = 1;  // EI_CLASS: 32 bits
  std::ofstream(folder.path() / "narrow.so", std::ios::binary) << bytes;
  EXPECT_THAT(refusal(folder.path() / "narrow.so"), HasSubstr("not a shared library of this"));
}

TEST(NoPlugin, IsOneThatEverybodyMayChange)
{
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "own.so";
  fs::copy_file(example(), file);
  EXPECT_EQ(refusal(file), "it was taken");
  fs::permissions(file, fs::perms::others_write, fs::perm_options::add);
  EXPECT_THAT(refusal(file), HasSubstr("may change it"));
  EXPECT_THAT(refusal(file), HasSubstr("chmod o-w " + file.string()));
  fs::permissions(file, fs::perms::others_write, fs::perm_options::remove);
  fs::permissions(folder.path(), fs::perms::others_write, fs::perm_options::add);
  EXPECT_THAT(refusal(file), HasSubstr("may replace it"));
  fs::permissions(folder.path(), fs::perms::sticky_bit, fs::perm_options::add);
  EXPECT_EQ(refusal(file), "it was taken");  // as /tmp: only its owner may replace it
}

TEST(NoPlugin, IsOneThatOthersMayReplaceThroughALinkOrAFolderAbove)
{
  const test::TemporaryFolder folder;
  const fs::path open = folder / "open", inner = open / "inner", own = folder / "own";
  fs::create_directories(inner);
  fs::create_directory(own);
  fs::copy_file(example(), inner / "real.so");
  fs::create_symlink(inner / "real.so", own / "link.so");
  fs::create_directory_symlink(inner, own / "linked");
  EXPECT_EQ(refusal(own / "link.so"), "it was taken");
  fs::permissions(open, fs::perms::others_write, fs::perm_options::add);
  for (const fs::path& file : {inner / "real.so", own / "link.so", own / "linked" / "real.so"}) {
    EXPECT_THAT(refusal(file), HasSubstr("may replace it")) << file;
    EXPECT_THAT(refusal(file), HasSubstr("chmod o-w " + open.string())) << file;
  }
  fs::permissions(open, fs::perms::sticky_bit, fs::perm_options::add);
  EXPECT_EQ(refusal(own / "link.so"), "it was taken");
}

TEST(NoPlugin, IsOneOfAnotherUser)
{
  if (::geteuid() != 0) GTEST_SKIP() << "Only root gives files away.";
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "theirs");
  const fs::path file = folder / "theirs" / "own.so";
  fs::copy_file(example(), file);
  constexpr uid_t nobody = 65534;
  ASSERT_EQ(::chown(file.c_str(), nobody, 0), 0);
  EXPECT_THAT(refusal(file), HasSubstr("nobody may change it"));
  ASSERT_EQ(::chown(file.c_str(), 0, 0), 0);
  EXPECT_EQ(refusal(file), "it was taken");
  ASSERT_EQ(::chown((folder / "theirs").c_str(), nobody, 0), 0);
  EXPECT_THAT(refusal(file), HasSubstr("nobody may replace it"));
}

TEST(NoPlugin, ThatMayNotBeReadIsRefusedWithTheCommandThatHelps)
{
  if (::geteuid() == 0) GTEST_SKIP() << "Root may read every file.";
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "own.so";
  fs::copy_file(example(), file);
  fs::permissions(file, fs::perms::none);
  EXPECT_THAT(refusal(file), HasSubstr("you may not read it"));
  EXPECT_THAT(refusal(file), HasSubstr("chmod u+r " + file.string()));
}

TEST(PluginFolder, ListsLibrariesInItAndOneLevelBelow)
{
  const test::TemporaryFolder folder;
  fs::create_directories(folder.path() / "a" / "b");
  for (const char* name : {"two.so", "a/one.so", "a/b/deep.so", "a/profile.toml"})
    std::ofstream(folder.path() / name) << "x";
  const auto found = pluginLibraries(folder.path());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_THAT(found[0].string(), EndsWith("a/one.so"));
  EXPECT_THAT(found[1].string(), EndsWith("two.so"));
  EXPECT_TRUE(pluginLibraries(folder.path() / "none").empty());
}

TEST(InstalledPlugins, AreListedWithTheirTraitsOrWithTheReason)
{
  const test::TemporaryFolder own, shared;
  fs::copy_file(example(), own.path() / "example.so");
  std::ofstream(own.path() / "text.so") << "no library";
  fs::create_symlink(own.path() / "gone", own.path() / "link.so");
  fs::copy_file(faulty("noDevice"), shared.path() / "lab.so");
  const auto found = surveyPlugins({own.path(), own.path() / "none", shared.path()});
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].name, "Example handle");
  EXPECT_TRUE(found[0].isUsable()) << found[0].obstacle;
  EXPECT_EQ(found[0].traits.maxForce, 3.0);
  EXPECT_THAT(found[1].obstacle, HasSubstr("no such file"));
  EXPECT_EQ(found[2].name, "text");
  EXPECT_THAT(found[2].obstacle, HasSubstr("not a shared library"));
  EXPECT_EQ(found[3].file, shared.path() / "lab.so");
  EXPECT_THAT(found[3].obstacle, HasSubstr("finds no device"));
}

TEST(InstalledPlugins, AreFoundByTheNameOfTheDeviceOrOfTheFile)
{
  const std::vector<FoundPlugin> survey{{"/a/one.so", "Handle", {}, {}},
                                        {"/a/two.so", "Other", {}, {}}};
  for (const char* name : {"/a/two.so", "two.so", "two", "Other"}) {
    const auto found = pluginNamed(survey, name);
    ASSERT_TRUE(found && *found) << name;
    EXPECT_EQ((*found)->file, "/a/two.so");
  }
  EXPECT_EQ(*pluginNamed(survey, "three"), nullptr);
}

TEST(InstalledPlugins, OfOneNameAreNotTakenForOneAnother)
{
  const std::vector<FoundPlugin> survey{{"/a/one.so", "Handle", {}, {}},
                                        {"/b/one.so", "Pen", {}, {}},
                                        {"/c/two.so", "Handle", {}, {}}};
  for (const char* name : {"Handle", "one", "one.so"}) {
    const auto found = pluginNamed(survey, name);
    ASSERT_FALSE(found) << name;
    EXPECT_THAT(found.error().message, HasSubstr("2 plug-ins are named " + std::string(name)));
    EXPECT_THAT(found.error().message, HasSubstr("/a/one.so, "));
  }
  EXPECT_EQ((*pluginNamed(survey, "/c/two.so"))->name, "Handle");
  EXPECT_EQ((*pluginNamed(survey, "Pen"))->file, "/b/one.so");
}

TEST(InstalledPlugins, ThatHangWhileTheyAreLoadedAreGivenUp)
{
  ::setenv("PERILYMPH_TEST_FAULT", "hang in create", 1);
  const auto began = std::chrono::steady_clock::now();
  const auto loaded = loadPluginDevice(test::testPlugin("socket_device"), milliseconds(200));
  ::unsetenv("PERILYMPH_TEST_FAULT");
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().message, HasSubstr("did not answer within 0 s while it was loaded"));
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(10));
}

TEST(InstalledPlugins, ThatHangDelayTheListOnce)
{
  const test::TemporaryFolder folder;
  for (int i = 0; i < 8; ++i)
    fs::copy_file(test::testPlugin("socket_device"),
                  folder / ("hangs" + std::to_string(i) + ".so"));
  fs::copy_file(example(), folder / "sound.so");
  ::setenv("PERILYMPH_TEST_FAULT", "hang in create", 1);
  const auto began = std::chrono::steady_clock::now();
  const auto found = surveyPlugins({folder.path()}, milliseconds(2000));
  const auto time = std::chrono::steady_clock::now() - began;
  ::unsetenv("PERILYMPH_TEST_FAULT");
  ASSERT_EQ(found.size(), 9u);
  for (int i = 0; i < 8; ++i)
    EXPECT_THAT(found[static_cast<std::size_t>(i)].obstacle, HasSubstr("did not answer within"));
  EXPECT_TRUE(found[8].isUsable()) << found[8].obstacle;
  // one after the other it would be 16 s; the rest is for ending them on a busy machine
  EXPECT_LT(time, std::chrono::seconds(8));
}

TEST(InstalledPlugins, AreInTheUsersDataHomeAndInThePackagesLibraries)
{
  const test::TemporaryFolder home;
  ::setenv("XDG_DATA_HOME", home.path().c_str(), 1);
  const auto folders = pluginFolders();
  ::unsetenv("XDG_DATA_HOME");
  ASSERT_EQ(folders.size(), 2u);
  EXPECT_EQ(folders[0], home.path() / "perilymph/plugins");
  EXPECT_THAT(folders[1].string(), EndsWith("/perilymph/plugins"));
  EXPECT_TRUE(folders[1].is_absolute());
}

}  // namespace
}  // namespace perilymph::device
