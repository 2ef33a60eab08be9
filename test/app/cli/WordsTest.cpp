#include "Cli.h"

namespace perilymph::test {
namespace {

TEST(CommandLine, ExplainsItself)
{
  const auto help = cli({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* command : {"simulate", "anatomy", "replay", "render", "devices"}) {
    EXPECT_THAT(help.out, testing::HasSubstr(command));
    EXPECT_EQ(cli({command, "--help"}).status, 0) << command;
  }
  EXPECT_EQ(cli({"--version"}).status, 0);
}

TEST(CommandLine, KnowsItsCommands)
{
  expectWrongWords(cli({}), "subcommand");
  expectWrongWords(cli({"banana"}), "no command 'banana'");
  expectWrongWords(cli({"simulate"}), "--scenario");
  expectWrongWords(cli({"simulate", "--scenario"}), "--scenario");
  expectWrongWords(cli({"replay"}), "file");
  expectWrongWords(cli({"anatomy"}), "--preset");
  expectWrongWords(cli({"render", "--out", "x.png"}), "--scenario");
  expectWrongWords(cli(shortSimulation({"--banana"})), "--banana");
  expectWrongWords(cli(shortSimulation({"--every-ms", "5"})), "--csv");
  expectWrongWords(cli(shortSimulation({"--set", "speed_mm_s"})), "key=value");
  expectWrongWords(cli({"anatomy", "--preset", "banana"}), "banana");
  expectWrongWords(cli({"anatomy", "--preset", "published", "--patient", "small"}), "1 option");
  expectWrongWords(cli({"anatomy", "--st-length-mm", "33"}), "--rw-");
  expectWrongWords(
      cli({"anatomy", "--st-length-mm", "long", "--rw-width-mm", "2", "--rw-height-mm", "2"}),
      "long");
}

}  // namespace
}  // namespace perilymph::test
