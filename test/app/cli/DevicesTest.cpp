// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <fstream>

#include "perilymph/test/Cli.h"

#include "perilymph/test/Places.h"
#include "perilymph/test/RecordedTree.h"

namespace perilymph::test {
namespace {

using testing::HasSubstr;

ProgramOutcome devicesIn(const RecordedTree& tree, std::vector<std::string> more = {})
{
  std::vector<std::string> arguments = {"devices"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  ProgramCall call = cliCall(std::move(arguments));
  call.environment.emplace_back("PERILYMPH_SYSTEM_ROOT", tree.root().string());
  return run(call);
}

TEST(Devices, ListTheInputsThatNeedNoHardware)
{
  const auto outcome = devicesIn(RecordedTree());
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, HasSubstr("No HID device"));
  EXPECT_THAT(outcome.out, HasSubstr("mouse and keyboard"));
  EXPECT_THAT(outcome.out, HasSubstr("script"));
}

TEST(Devices, AreListedWithWhatTheyAre)
{
  RecordedTree tree;
  tree.add({"0003:ABCD:0002.0001", "Some keyboard", "hidraw0", "00"});
  tree.addNode("hidraw0");
  const TemporaryFolder folder;
  const auto file = folder / "devices.json";
  const auto outcome = devicesIn(tree, {"--json", file.string()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("hidraw0"));
  EXPECT_THAT(outcome.out, HasSubstr("abcd:0002"));
  EXPECT_THAT(contentOf(file), HasSubstr("\"vendor_id\": 43981"));  // 0xabcd
  EXPECT_THAT(contentOf(file), HasSubstr("*:ABCD:0002.*"));
}

TEST(Devices, CannotTestAMissingDevice)
{
  const auto outcome = devicesIn(RecordedTree(), {"--test", "7"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("no hidraw7"));
}

TEST(Devices, NamesWhatIsThereForATestOfAnother)
{
  const auto outcome = devicesIn(RecordedTree(), {"--test", "mouse"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("There is no device 'mouse'."));
}

TEST(Devices, OfOneModelAreListedWithTheirPlaces)
{
  RecordedTree tree;
  tree.add({"0003:ABCD:0002.0001", "Some handle", "hidraw0", "00"});
  tree.add({.kernelName = "0003:ABCD:0002.0002",
            .name = "Some handle",
            .node = "hidraw1",
            .interface = "00",
            .place = "usb-0000:00:14.0-4/input0"});
  const TemporaryFolder folder;
  const auto file = folder / "devices.json";
  const auto outcome = devicesIn(tree, {"--json", file.string()});
  EXPECT_THAT(outcome.out, HasSubstr("At usb-0000:00:14.0-1/input0."));
  EXPECT_THAT(outcome.out, HasSubstr("At usb-0000:00:14.0-4/input0."));
  EXPECT_THAT(contentOf(file), HasSubstr("\"place\": \"usb-0000:00:14.0-4/input0\""));
}

TEST(Devices, AreNotNeededToReadAProfile)
{
  const auto outcome = devicesIn(RecordedTree(), {"--profile", "paddle"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              HasSubstr("paddle.toml: Haptic paddle, kind \"vector\", confidence low"));
  EXPECT_THAT(outcome.out, HasSubstr("1 shifts and 0 turns sensed, force on 1 axes up to 1.5 N"));
  EXPECT_THAT(outcome.out, HasSubstr("For usage page 0xffa1, usage 0x50."));
  EXPECT_THAT(outcome.out, HasSubstr("The profile is valid. No connected device fits it."));
}

/// A folder of the user's own files with plug-ins in it.
class InstalledPlugin : public testing::Test {
protected:
  void install(const std::filesystem::path& file, const std::string& name)
  {
    std::filesystem::create_directories(folder());
    std::filesystem::copy_file(file, folder() / name);
  }
  std::filesystem::path folder() const { return user_ / "perilymph" / "plugins"; }
  ProgramOutcome devices(std::vector<std::string> more = {})
  {
    std::vector<std::string> arguments = {"devices", "--json", json().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    ProgramCall call = cliCall(std::move(arguments));
    call.environment.emplace_back("PERILYMPH_SYSTEM_ROOT", tree_.root().string());
    call.environment.emplace_back("XDG_DATA_HOME", user_.path().string());
    return run(call);
  }
  std::filesystem::path json() const { return user_ / "devices.json"; }

  RecordedTree tree_;
  const TemporaryFolder user_;
};

TEST_F(InstalledPlugin, IsNoneBeforeAndAfter)
{
  EXPECT_THAT(devices().out, HasSubstr("No plug-in is installed."));
  EXPECT_THAT(devices().out, HasSubstr("Plug-ins are installed in " + folder().string()));
  install(examplePlugin(), "lab.so");
  EXPECT_THAT(devices().out, HasSubstr((folder() / "lab.so").string() + "  Example handle"));
  EXPECT_THAT(contentOf(json()), HasSubstr("\"name\": \"Example handle\""));
  std::filesystem::remove(folder() / "lab.so");
  EXPECT_THAT(devices().out, HasSubstr("No plug-in is installed."));
}

TEST_F(InstalledPlugin, IsTestedByItsName)
{
  install(examplePlugin(), "lab.so");
  for (const char* name : {"lab", "Example handle"}) {
    const auto outcome = devices({"--test", name});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("rendered on 1 of 1 axes"));
    EXPECT_THAT(contentOf(json()), HasSubstr("\"passed\": true"));
  }
}

TEST_F(InstalledPlugin, ThatIsRefusedIsListedWithTheReason)
{
  install(examplePlugin(), "open.so");
  std::filesystem::permissions(folder() / "open.so", std::filesystem::perms::others_write,
                               std::filesystem::perm_options::add);
  std::ofstream(folder() / "text.so") << "no library";
  install(testPlugin("faulty_laterEntry"), "later.so");
  const auto outcome = devices();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("chmod o-w " + (folder() / "open.so").string()));
  EXPECT_THAT(outcome.out, HasSubstr("text.so is not taken: it is not a shared library"));
  EXPECT_THAT(outcome.out, HasSubstr("built for version 3 of PluginApi.h"));
  const auto tested = devices({"--test", "later"});
  EXPECT_EQ(tested.status, 1);
  EXPECT_THAT(tested.err, HasSubstr("built for version 3 of PluginApi.h"));
}

TEST_F(InstalledPlugin, ThatDoesNotPassItsTestIsAnError)
{
  install(testPlugin("faulty_failsToWrite"), "lab.so");
  const auto outcome = devices({"--test", "lab"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("result             not passed: "));
  EXPECT_THAT(outcome.err, HasSubstr("did not pass the test: no report came."));
  EXPECT_THAT(contentOf(json()), HasSubstr("\"passed\": false"));
  EXPECT_THAT(contentOf(json()), HasSubstr("did not pass the test"));
}

TEST_F(InstalledPlugin, ThatCannotBeOpenedIsReportedWithTheReason)
{
  install(testPlugin("faulty_cannotOpen"), "lab.so");
  const auto listed = devices();
  EXPECT_THAT(listed.out, Not(HasSubstr("It may be opened.")));
  EXPECT_THAT(listed.out, HasSubstr("Whether its device is connected shows when it is opened"));
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"--test", "lab"}, {"--plugin", (folder() / "lab.so").string()}}) {
    std::filesystem::remove(json());
    const auto outcome = devices(call);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("yyyy"));
    EXPECT_THAT(contentOf(json()), HasSubstr("\"error\": \"yyyy"));
  }
}

TEST_F(InstalledPlugin, OfTheNameOfAnotherIsNotChosen)
{
  install(examplePlugin(), "one.so");
  install(examplePlugin(), "two.so");
  const auto outcome = devices({"--test", "Example handle"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("2 plug-ins are named Example handle: "));
  EXPECT_THAT(outcome.err, HasSubstr((folder() / "two.so").string()));
  EXPECT_EQ(devices({"--test", "two"}).status, 0);
}

TEST_F(InstalledPlugin, ThatIsUnknownIsAnsweredWithThoseThereAre)
{
  install(examplePlugin(), "lab.so");
  const auto outcome = devices({"--test", "banana"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("There is no device 'banana'."));
  EXPECT_THAT(outcome.err, HasSubstr("Installed plug-ins: Example handle."));
}

TEST(DevicePlugin, IsLoadedListenedToAndPushes)
{
  const TemporaryFolder folder;
  const auto file = folder / "trial.json";
  const auto outcome = cli({"devices", "--plugin", examplePlugin(), "--json", file.string()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              HasSubstr("Example handle: 1 shifts and 0 turns sensed, force on 1 axes"));
  // the virtual hand never releases the button; a busy machine may read it late
  EXPECT_THAT(outcome.out, HasSubstr(" of 3000 were fresh and valid"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("samples            0 of")));
  EXPECT_THAT(outcome.out, HasSubstr("rendered on 1 of 1 axes"));
  EXPECT_THAT(outcome.out, HasSubstr(" N of 0.50 N written; the handle moved"));
  EXPECT_THAT(outcome.out, HasSubstr("button             pressed"));
  EXPECT_THAT(outcome.out, HasSubstr("result             passed"));
  EXPECT_THAT(contentOf(file), HasSubstr("\"force_axes_shown\": 1"));
  EXPECT_THAT(contentOf(file), HasSubstr("\"rate_per_s\""));
}

TEST(DevicePlugin, ThatIsInvalidIsRefusedWithAMessage)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "text.so") << "no library";
  for (const char* name : {"none.so", "text.so"}) {
    const auto outcome = cli({"devices", "--plugin", (folder / name).string()});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr(name));
    EXPECT_EQ(outcome.out, "");
  }
}

// A stick with two axes and a button (HID 1.11, appendix): 8-bit positions from 0 to 255.
constexpr const char* joystickTape =
    "D: 0\n"
    "R: 38 05 01 09 04 a1 01 09 30 09 31 15 00 26 ff 00 75 08 95 02 81 02 05 09 19 01 29 08 15 00 "
    "25 "
    "01 75 01 95 08 81 02 c0\n"
    "N: Some joystick\nI: 3 abcd 0002\n"
    "E: 000000.000000 3 80 80 00\n"
    "E: 000000.010000 3 ff 80 01\n"
    "E: 000000.020000 3 80 00 00\n";

std::string joystickDescriptor()
{
  return std::string(
      "\x05\x01\x09\x04\xa1\x01\x09\x30\x09\x31\x15\x00\x26\xff\x00\x75\x08\x95\x02\x81\x02"
      "\x05\x09\x19\x01\x29\x08\x15\x00\x25\x01\x75\x01\x95\x08\x81\x02\xc0",
      38);
}

/// A tree with one joystick that plays a tape, and a folder of the user's own files.
class AJoystick : public testing::Test {
protected:
  explicit AJoystick(const std::string& tape = joystickTape)
  {
    tree_.add({"0003:ABCD:0002.0001", "Some joystick", "hidraw1", "00", joystickDescriptor()});
    tree_.addTape("hidraw1", tape);
  }
  ProgramOutcome devices(std::vector<std::string> more = {})
  {
    std::vector<std::string> arguments = {"devices", "--json", json().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    ProgramCall call = cliCall(std::move(arguments));
    call.environment.emplace_back("PERILYMPH_SYSTEM_ROOT", tree_.root().string());
    call.environment.emplace_back("XDG_DATA_HOME", user_.path().string());
    return run(call);
  }
  /// Puts a profile of the user's own into the folder for them.
  void own(const std::string& name, const std::string& text)
  {
    const auto folder = user_ / "perilymph" / "devices";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / (name + ".toml")) << text;
  }
  static std::string profile(const std::string& name)
  {
    return "name = \"" + name +
           "\"\nmaker = \"us\"\nkind = \"joystick\"\nsource = \"a test\"\nconfidence = "
           "\"low\"\n[[match]]\nvendor_id = 0xabcd\nproduct_id = 2\n[capability]\n"
           "nominal_period_ms = 10.0\nreporting = \"on_change\"\n[axes]\nmotion = \"place\"\n"
           "x = \"x\"\ntravel_mm = 15.0\n";
  }
  std::filesystem::path json() const { return user_ / "devices.json"; }

  RecordedTree tree_;
  const TemporaryFolder user_;
};

TEST_F(AJoystick, IsListedWithItsProfileAndHowSureThatIs)
{
  const auto outcome = devices();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("generic/joystick.toml, confidence"));
  EXPECT_THAT(contentOf(json()), HasSubstr("generic/joystick.toml"));
}

TEST_F(AJoystick, TakesTheUsersOwnProfileBeforeTheShippedOne)
{
  own("mine", profile("My stick"));
  EXPECT_THAT(devices().out, HasSubstr("My stick"));
  EXPECT_THAT(contentOf(json()), HasSubstr("perilymph/devices/mine.toml"));
}

TEST_F(AJoystick, WithTwoProfilesSaysSoAndUsesTheOneThatIsNamed)
{
  own("first", profile("First stick"));
  own("second", profile("Second stick"));
  const auto outcome = devices();
  EXPECT_THAT(outcome.out, HasSubstr("First stick"));
  EXPECT_THAT(outcome.out, HasSubstr("second.toml fits as well; choose it with --profile"));
  const auto named = devices({"--profile", "second"});
  EXPECT_EQ(named.status, 0) << named.err;
  EXPECT_THAT(named.out, HasSubstr("Second stick"));
  EXPECT_THAT(named.out, testing::Not(HasSubstr("First stick")));
}

TEST_F(AJoystick, WhoseProfileIsBrokenIsNotOpenedWithAnother)
{
  own("mine", profile("My stick") + "colour = \"red\"\n");
  const auto listed = devices();
  EXPECT_THAT(listed.out, HasSubstr("joystick.toml is not used instead"));
  EXPECT_THAT(listed.err, HasSubstr("colour"));
  const auto tested = devices({"--test", "1"});
  EXPECT_EQ(tested.status, 1);
  EXPECT_THAT(tested.err, HasSubstr("Correct or remove it"));
}

TEST_F(AJoystick, ThatTheKernelRefusedIsNamed)
{
  tree_.addRefused("0003:1234:0006.0002", "Odd handle");
  const auto outcome = devices();
  EXPECT_THAT(outcome.err, HasSubstr("1234:0006 (Odd handle) is plugged in, but the kernel"));
  EXPECT_THAT(outcome.err, testing::Not(HasSubstr("abcd:0002")));
}

TEST_F(AJoystick, IsAdvisedARuleThatHidesNoShippedOne)
{
  std::filesystem::permissions(tree_.dev() / "hidraw1", std::filesystem::perms::none);
  if (::geteuid() == 0) GTEST_SKIP() << "Root may open every node.";
  EXPECT_THAT(devices().out, HasSubstr("71-perilymph-local.rules"));
}

class ASilentJoystick : public AJoystick {
protected:
  ASilentJoystick()
      : AJoystick("D: 0\nN: Some joystick\nI: 3 abcd 0002\nE: 001000.000000 3 80 80 00\n")
  {
  }
};

TEST_F(ASilentJoystick, IsSaidToHaveSentNothing)
{
  const auto outcome = devices({"--test", "1"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("sent no report during the test"));
  EXPECT_THAT(contentOf(json()), HasSubstr("\"reports\": 0"));
}

TEST(CapturedDevice, IsReadAsTheCapturedDevice)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "stick.hid") << joystickTape;
  const auto json = folder / "stick.json";
  const auto outcome = run(
      cliCall({"devices", "--replay", (folder / "stick.hid").string(), "--json", json.string()}));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("abcd:0002  Some joystick"));
  EXPECT_THAT(outcome.out, HasSubstr("3 fresh, 0 lost"));
  EXPECT_THAT(contentOf(json), HasSubstr("\"rate_per_s\": 100.0"));
  EXPECT_THAT(contentOf(json), HasSubstr("\"buttons\": 1"));
}

TEST(CapturedDevice, ThatIsDamagedIsAnsweredWithItsLine)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "stick.hid") << joystickTape << "E: 000000.030000 3 80 0\nE: noon 1 00\n";
  const auto outcome = run(cliCall({"devices", "--replay", (folder / "stick.hid").string()}));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("stick.hid, line 8"));
}

TEST(CapturedDevice, IsCapturedFromATestAndReadAgain)
{
  // A tape replaces the device: the capture contains the same reports.
  RecordedTree tree;
  tree.add({"0003:ABCD:0002.0001", "Some joystick", "hidraw1", "00", joystickDescriptor()});
  tree.addTape("hidraw1", joystickTape);
  const TemporaryFolder folder;
  const auto capture = folder / "again.hid";
  const auto tested = devicesIn(tree, {"--test", "1", "--capture", capture.string()});
  EXPECT_EQ(tested.status, 0) << tested.err;
  EXPECT_THAT(contentOf(capture), HasSubstr("I: 0003 abcd 0002"));
  const auto outcome = run(cliCall({"devices", "--replay", capture.string()}));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("3 fresh, 0 lost"));
}

TEST(CapturedDevice, IsOfATest)
{
  EXPECT_EQ(devicesIn(RecordedTree(), {"--capture", "tape.hid"}).status, 2);
}

}  // namespace
}  // namespace perilymph::test
