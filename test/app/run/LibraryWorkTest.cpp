// SPDX-License-Identifier: BSD-3-Clause

// The list of recordings while it is read: a file that blocks its reader does not hide others.

#include "gui/pages/sessions/LibraryWork.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QTest>
#include <future>
#include <new>
#include <optional>

namespace perilymph::test {
namespace {

using session::SessionSummary;
using Sessions = std::vector<SessionSummary>;

constexpr int patience_ms = 60'000;

SessionSummary good()
{
  SessionSummary summary;
  summary.file = "good.insertion";
  return summary;
}

/// Reads one of two recordings, and the other one only when the test allows it.
class SlowLibrary : public testing::Test {
protected:
  SlowLibrary()
      : work_(
            nullptr,
            [let = let_.get_future().share()](const auto&, const auto&, const auto& progress,
                                              const auto& listed, const auto&) -> Result<Sessions> {
              progress(0, 2);
              listed(good());
              progress(1, 2);
              let.wait();
              return Sessions{good(), good()};
            })
  {
    QObject::connect(&work_, &gui::LibraryWork::progressed,
                     [this](int done, int all, const Sessions& fresh) {
                       done_ = done;
                       all_ = all;
                       fresh_.insert(fresh_.end(), fresh.begin(), fresh.end());
                     });
    QObject::connect(&work_, &gui::LibraryWork::listed, [this](const Sessions& sessions, int all) {
      listed_ = sessions;
      all_ = all;
    });
  }
  ~SlowLibrary() override
  {
    if (!isLet_) let_.set_value();
  }
  void let()
  {
    isLet_ = true;
    let_.set_value();
  }

  std::promise<void> let_;
  bool isLet_ = false;
  gui::LibraryWork work_;
  int done_ = 0, all_ = 0;
  Sessions fresh_;
  std::optional<Sessions> listed_;
};

TEST_F(SlowLibrary, ShowsWhatItHasReadBeforeItHasReadAll)
{
  work_.list("folder", {});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !fresh_.empty(); }, patience_ms));
  EXPECT_EQ(fresh_.front().file, "good.insertion");
  EXPECT_EQ(done_, 1);
  EXPECT_EQ(all_, 2);
  EXPECT_FALSE(listed_);
  let();
  ASSERT_TRUE(QTest::qWaitFor([&] { return listed_.has_value(); }, patience_ms));
  EXPECT_EQ(listed_->size(), 2u);
}

TEST_F(SlowLibrary, CanceledListsWhatItHasReadThoughTheReadingDoesNotEnd)
{
  work_.list("folder", {});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !fresh_.empty(); }, patience_ms));
  work_.cancel();
  ASSERT_TRUE(QTest::qWaitFor([&] { return listed_.has_value(); }, patience_ms));
  EXPECT_EQ(listed_->size(), 1u);
  EXPECT_EQ(all_, 2);
  EXPECT_FALSE(work_.isBusy());
}

TEST(ALibrary, ThatNeedsTooMuchMemorySaysSo)
{
  gui::LibraryWork work(nullptr,
                        [](const auto&, const auto&, const auto&, const auto&,
                           const auto&) -> Result<Sessions> { throw std::bad_alloc(); });
  QString sentence;
  QObject::connect(&work, &gui::LibraryWork::failed,
                   [&sentence](const QString& said) { sentence = said; });
  work.list("folder", {});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !sentence.isEmpty(); }, patience_ms));
  EXPECT_TRUE(sentence.contains("needs more memory")) << sentence.toStdString();
}

}  // namespace
}  // namespace perilymph::test
