// SPDX-License-Identifier: BSD-3-Clause

// Work in a background thread: answered once, even if it throws, and never waited for without
// limit.

#include "gui/run/Background.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QTest>
#include <chrono>
#include <future>
#include <new>
#include <stdexcept>
#include <stop_token>
#include <thread>
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

using gui::Background;
using ::testing::ElementsAre;

constexpr int patience_ms = 60'000;

TEST(Background, AnswersWithTheResultOfItsWork)
{
  Background background(nullptr);
  int answered = 0;
  background.run(
      "The sum", [](const std::stop_token&) { return Result<int>(2 + 3); },
      [&](const Result<int>& sum) { answered = *sum; });
  EXPECT_TRUE(background.isBusy());
  EXPECT_TRUE(QTest::qWaitFor([&] { return answered == 5; }, patience_ms));
  EXPECT_FALSE(background.isBusy());
}

TEST(Background, IsWaitedForAndAnswersBeforeItGoesOn)
{
  Background background(nullptr);
  int answered = 0;
  background.run(
      "The sum", [](const std::stop_token&) { return Result<int>(2 + 3); },
      [&](const Result<int>& sum) { answered += *sum; });
  background.finish();
  EXPECT_EQ(answered, 5);
  EXPECT_FALSE(background.isBusy());
  background.finish();  // nothing is left
  EXPECT_EQ(answered, 5);
}

TEST(Background, AnswersMissingMemoryWithASentence)
{
  Background background(nullptr);
  std::string sentence;
  background.run(
      "The recording a.insertion",
      [](const std::stop_token&) -> Result<int> { throw std::bad_alloc(); },
      [&](const Result<int>& result) { sentence = result.error().message; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !sentence.empty(); }, patience_ms));
  EXPECT_THAT(sentence, ::testing::StartsWith("The recording a.insertion needs more memory"));
}

TEST(Background, WorksOnAfterAnException)
{
  Background background(nullptr);
  bool hasFailed = false, hasWorked = false;
  background.run(
      "The first", [](const std::stop_token&) -> Result<int> { throw std::runtime_error("no"); },
      [&](const Result<int>& result) { hasFailed = !result; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return hasFailed; }, patience_ms));
  background.run(
      "The second", [](const std::stop_token&) { return Result<int>(1); },
      [&](const Result<int>& result) { hasWorked = bool(result); });
  EXPECT_TRUE(QTest::qWaitFor([&] { return hasWorked; }, patience_ms));
}

TEST(Background, AnswersOnlyTheLastOfSeveralRequests)
{
  Background background(nullptr);
  std::vector<int> answers;
  for (int number : {1, 2, 3})
    background.run(
        "The number", [number](const std::stop_token&) { return Result<int>(number); },
        [&](const Result<int>& answer) { answers.push_back(*answer); });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !background.isBusy(); }, patience_ms));
  EXPECT_THAT(answers, ElementsAre(3));
}

/// Whether the result arrives within two minutes.
bool isSetSoon(std::promise<void>& promise)
{
  return promise.get_future().wait_for(std::chrono::minutes(2)) == std::future_status::ready;
}

TEST(Background, DoesNotAnswerForgottenWork)
{
  std::promise<void> begun, ended;
  bool isAnswered = false;
  Background background(nullptr);
  background.run(
      "The work",
      [&](const std::stop_token& stop) {
        begun.set_value();
        EXPECT_TRUE(test::waitUntil([&] { return stop.stop_requested(); }));
        ended.set_value();
        return Result<void>();
      },
      [&](const Result<void>&) { isAnswered = true; });
  ASSERT_TRUE(isSetSoon(begun));
  background.cancel();
  EXPECT_FALSE(background.isBusy());
  ASSERT_TRUE(isSetSoon(ended));
  QCoreApplication::processEvents();
  EXPECT_FALSE(isAnswered);
}

TEST(Background, EndsEvenIfItsWorkDoesNot)
{
  std::promise<void> begun, gate;
  auto opened = gate.get_future().share();
  auto background = std::make_unique<Background>(nullptr);
  bool isAnswered = false;
  background->run(
      "The work",
      [&begun, opened](const std::stop_token&) {
        begun.set_value();
        opened.wait();
        return Result<void>();
      },
      [&](const Result<void>&) { isAnswered = true; });
  ASSERT_TRUE(isSetSoon(begun));
  background.reset();
  EXPECT_TRUE(Background::isAnyThreadLeft());
  gate.set_value();
  QCoreApplication::processEvents();
  EXPECT_FALSE(isAnswered);
}

}  // namespace
}  // namespace perilymph::test
