// SPDX-License-Identifier: BSD-3-Clause

// A patient is copied while the window answers, and the copy can be canceled.

#include "gui/pages/start/PatientTransfer.h"

#include <gtest/gtest.h>

#include <QTest>
#include <fstream>
#include <future>
#include <stop_token>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

constexpr int transferPatience_ms = 60'000;

class PatientTransfers : public testing::Test {
protected:
  PatientTransfers()
  {
    QObject::connect(&transfer_, &gui::PatientTransfer::progressed,
                     [this](int percent) { percent_ = percent; });
    QObject::connect(&transfer_, &gui::PatientTransfer::copied,
                     [this](const QString& place) { place_ = place; });
    QObject::connect(&transfer_, &gui::PatientTransfer::failed,
                     [this](const QString& sentence) { sentence_ = sentence; });
  }

  /// Ends the wait of a copy that waits.
  std::promise<void> let_;
  gui::PatientTransfer transfer_{nullptr};
  int percent_ = -1;
  QString place_, sentence_;
};

TEST_F(PatientTransfers, ShowHowFarTheyAreWhileTheyRun)
{
  transfer_.start([let = let_.get_future().share()](const session::CopyProgress& progress,
                                                    const std::stop_token&) -> Result<fs::path> {
    progress(30, 120);
    let.wait();
    return fs::path("/there");
  });
  ASSERT_TRUE(QTest::qWaitFor([&] { return percent_ == 25; }, transferPatience_ms));
  EXPECT_TRUE(transfer_.isBusy());
  EXPECT_TRUE(place_.isEmpty());
  let_.set_value();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !place_.isEmpty(); }, transferPatience_ms));
  EXPECT_EQ(place_, "/there");
}

TEST_F(PatientTransfers, LeaveNothingIfTheyAreCanceled)
{
  const TemporaryFolder folder;
  anatomy::Patient patient;
  patient.label = "P-017";
  patient.basalTurn = anatomy::BasalTurn{millimeters(9.1), millimeters(6.7), std::nullopt};
  ASSERT_TRUE(anatomy::savePatient(patient, folder / "P-017-right.toml"));
  std::ofstream(folder / "one.insertion") << std::string(50'000'000, 'x');
  const fs::path file = folder / "P-017-right.toml", recording = folder / "one.insertion",
                 exported = folder / "exported/P-017";
  fs::create_directory(folder / "exported");
  transfer_.start(
      [=, let = let_.get_future().share()](const session::CopyProgress& progress,
                                           const std::stop_token& stop) -> Result<fs::path> {
        const session::CopyProgress waiting = [&](std::uintmax_t done, std::uintmax_t all) {
          if (done > 5'000'000) let.wait();
          progress(done, all);
        };
        const auto done = session::exportPatient(file, {recording}, exported, waiting, stop);
        if (!done) return done.error();
        return exported;
      });
  ASSERT_TRUE(QTest::qWaitFor([&] { return percent_ > 0; }, transferPatience_ms));
  transfer_.cancel();
  let_.set_value();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !sentence_.isEmpty(); }, transferPatience_ms));
  EXPECT_TRUE(sentence_.contains("canceled")) << sentence_.toStdString();
  EXPECT_TRUE(fs::is_empty(folder / "exported"));
  EXPECT_FALSE(transfer_.isBusy());
}

}  // namespace
}  // namespace perilymph::test
