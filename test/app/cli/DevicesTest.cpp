#include "Cli.h"

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

TEST(Devices, SayWhichHandsThereAreWithoutAnyDevice)
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

TEST(Devices, CannotTryWhatIsNotThere)
{
  const auto outcome = devicesIn(RecordedTree(), {"--test", "7"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("no hidraw7"));
}

TEST(Devices, TakeANumberForTheTest)
{
  EXPECT_EQ(devicesIn(RecordedTree(), {"--test", "mouse"}).status, 2);
}

}  // namespace
}  // namespace perilymph::test
