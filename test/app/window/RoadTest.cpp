// SPDX-License-Identifier: BSD-3-Clause

// The surgeon's road, from a CT on disk to a filed report, with what it takes of the surgeon.

#include <gtest/gtest.h>

#include <QApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <chrono>
#include <regex>

#include "KeptPicture.h"
#include "TheCtPage.h"
#include "gui/pages/insert/InsertionController.h"
#include "gui/pages/insert/ResultCard.h"
#include "gui/pages/plan/PlanList.h"
#include "gui/pages/plan/PlanPage.h"
#include "perilymph/test/ChildProcess.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

/// Counts what a surgeon does; typed text is not counted.
class Surgeon {
public:
  explicit Surgeon(WindowRig& rig) : rig_(rig) {}

  void press(const char* button)
  {
    ASSERT_TRUE(rig_.button(button).isVisible()) << button;
    ASSERT_TRUE(rig_.button(button).isEnabled()) << button;
    rig_.click(button);
    ++steps_;
  }
  /// Presses a button that opens a dialog, types a path there and presses its default button.
  void press(const char* button, const fs::path& path)
  {
    QTimer poll;
    QObject::connect(&poll, &QTimer::timeout, &poll, [&] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return;
      poll.stop();
      auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
      name->setText(QString::fromStdString(path.string()));
      auto* buttons = dialog->findChild<QDialogButtonBox*>("buttonBox");
      for (QAbstractButton* each : buttons->buttons())
        if (buttons->buttonRole(each) == QDialogButtonBox::AcceptRole) each->click();
      ++steps_;
    });
    poll.start(10);
    press(button);
  }
  /// Holds two keys until something holds.
  void hold(Qt::Key first, Qt::Key second, const std::function<bool()>& until)
  {
    rig_.window().setFocus();
    rig_.holdKey(first);
    rig_.holdKey(second);
    EXPECT_TRUE(WindowRig::waitUntil(until));
    rig_.releaseKey(second);
    rig_.releaseKey(first);
    ++steps_;
  }
  int steps() const { return steps_; }

private:
  WindowRig& rig_;
  int steps_ = 0;
};

class TheRoad : public testing::Test {
protected:
  DataFolder data_;
  StateFolder state_;
  TemporaryFolder folder_;
  WindowRig rig_;
};

TEST_F(TheRoad, FromACtToASavedReportTakesTwelveSteps)
{
  const auto began = std::chrono::steady_clock::now();
  gui::CtPage& ct = *rig_.window().pages().find<gui::CtPage>();
  Surgeon surgeon(rig_);
  rig_.window().showPage("start");
  surgeon.press("ctPageButton");
  surgeon.press("openCtFolderButton", onDisk().folder / "ct");
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return ct.study().measures() != nullptr && !ct.isBusy(); }));
  EXPECT_NEAR(ct.study().measures()->a.value, onDisk().phantom.a, 0.4);
  rig_.type("ctPatientCode", "P-301");
  keepPicture(rig_.window(), "road-ct");

  surgeon.press("planCtButton");
  auto& plan = *rig_.window().findChild<gui::PlanPage*>();
  surgeon.press("plan-array-evo");  // beside the five that are chosen
  rig_.choose("planDraws", "16");   // a surgeon leaves the 64; this takes less time
  surgeon.press("computePlanButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return plan.plan() && !plan.isBusy(); }, 300'000));
  EXPECT_EQ(plan.plan()->arrays.size(), 6u);
  keepPicture(rig_.window(), "road-plan");
  surgeon.press("insertPlanArrayButton");
  keepPicture(rig_.window(), "road-loading");
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    return rig_.window().control().scenario().patient().label == "P-301" &&
           rig_.button("startButton").isEnabled();
  }));

  surgeon.press("pointerChoice");
  surgeon.press("startButton");
  surgeon.hold(Qt::Key_Space, Qt::Key_Down,
               [&] { return rig_.now().output.workflow == haptics::Workflow::finished; });
  const auto& card = *rig_.window().findChild<gui::ResultCard*>();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return card.isVisible(); }));
  keepPicture(rig_.window(), "road-result");
  const fs::path pdf = folder_ / "report.pdf";
  surgeon.press("resultReportButton", pdf);
  ASSERT_TRUE(fs::exists(pdf));
  if (const QString kept = qEnvironmentVariable("PERILYMPH_SCREEN_PICTURES"); !kept.isEmpty())
    fs::copy_file(pdf, fs::path(kept.toStdString()) / "road-report.pdf",
                  fs::copy_options::overwrite_existing);
  EXPECT_LE(surgeon.steps(), 12);
  RecordProperty("steps", surgeon.steps());
  RecordProperty("seconds", static_cast<int>(std::chrono::duration_cast<std::chrono::seconds>(
                                                 std::chrono::steady_clock::now() - began)
                                                 .count()));

  // the plan stands beside the results
  ASSERT_TRUE(rig_.window().insertion().result()->plan);
  const auto text = run({"pdftotext", {"-layout", pdf.string(), "-"}, {}, {}});
  EXPECT_NE(text.out.find("P-301"), std::string::npos);
  EXPECT_NE(text.out.find("plan of 20"), std::string::npos) << text.out;
  EXPECT_TRUE(std::regex_search(text.out,
                                std::regex("Peak insertion force.* [0-9]+ \\([0-9]+–[0-9]+\\) mN")))
      << text.out;
}

}  // namespace
}  // namespace perilymph::test
