// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Program.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace perilymph {
namespace {

using namespace std::chrono_literals;

TEST(Programs, AnswerWithBothStreamsApart)
{
  const auto answer = runProgram("sh", {"-c", "echo one; echo two >&2; exit 3"}, 10s);
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_EQ(answer->output, "one\n");
  EXPECT_EQ(answer->errors, "two\n");
  EXPECT_EQ(answer->status, 3);
}

TEST(Programs, ReceiveTheirArgumentsAsTheyAre)
{
  const std::vector<std::string> words = {"a b", "$(id)", "`id`", "'", "\"", "a;b|c>d", "", "\n"};
  std::vector<std::string> arguments = {"%s|"};
  arguments.insert(arguments.end(), words.begin(), words.end());
  const auto answer = runProgram("printf", arguments, 10s);
  ASSERT_TRUE(answer) << answer.error().message;
  std::string expected;
  for (const std::string& word : words) expected += word + "|";
  EXPECT_EQ(answer->output, expected);
}

TEST(Programs, ThatAreAbsentAreAnError)
{
  const auto answer = runProgram("no-such-program-anywhere", {}, 10s);
  ASSERT_FALSE(answer);
  EXPECT_THAT(answer.error().message, testing::HasSubstr("No such file"));
}

TEST(Programs, ThatHangAreEnded)
{
  const auto before = std::chrono::steady_clock::now();
  EXPECT_FALSE(runProgram("sleep", {"60"}, 200ms));
  EXPECT_LT(std::chrono::steady_clock::now() - before, 10s);
}

TEST(Programs, ThatASignalEndedHaveNoStatus)
{
  const auto answer = runProgram("sh", {"-c", "kill -9 $$"}, 10s);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, -1);
}

TEST(Programs, AreReadToABoundOfMemory)
{
  const auto answer = runProgram("head", {"-c", "3000000", "/dev/zero"}, 10s);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->output.size(), std::size_t{1} << 20);
}

TEST(Programs, ReceiveDescriptorsThoughTheNumbersCross)
{
  // The numbers are swapped: a copy one after the other would lose one of them.
  int one[2], two[2];
  ASSERT_EQ(pipe2(one, O_CLOEXEC), 0);
  ASSERT_EQ(pipe2(two, O_CLOEXEC), 0);
  const auto id = startProgram({"sh",
                                {"-c", "printf one >&" + std::to_string(two[1]) +
                                           "; printf two >&" + std::to_string(one[1])},
                                {{one[1], two[1]}, {two[1], one[1]}},
                                false});
  ASSERT_TRUE(id) << id.error().message;
  close(one[1]);
  close(two[1]);
  waitpid(*id, nullptr, 0);
  char text[4] = {};
  EXPECT_EQ(read(one[0], text, 3), 3);
  EXPECT_STREQ(text, "one");
  EXPECT_EQ(read(two[0], text, 3), 3);
  EXPECT_STREQ(text, "two");
  close(one[0]);
  close(two[0]);
}

TEST(Programs, HaveTheirLinesWrittenAsOne)
{
  EXPECT_EQ(linesTogether("sbatch: error: one\n\n  two\r\nthree\x1b\n"),
            "sbatch: error: one; two; three");
  EXPECT_EQ(linesTogether("\n"), "");
}

}  // namespace
}  // namespace perilymph
