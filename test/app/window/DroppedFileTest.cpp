// SPDX-License-Identifier: BSD-3-Clause

// Files dropped on the window, and what its top bar and its title say about them.

#include <gtest/gtest.h>

#include <fstream>

#include "DroppedUrl.h"
#include "OwnFolders.h"
#include "WindowRig.h"
#include "gui/pages/ct/CtPage.h"
#include "gui/pages/insert/ReplayBar.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

class DroppedFile : public testing::Test {
protected:
  bool drop(const fs::path& file) { return test::drop(rig_.window(), file); }

  /// A recording of a short insertion.
  fs::path record()
  {
    rig_.click("startButton");
    EXPECT_TRUE(WindowRig::waitUntil([&] { return rig_.travel_mm() > 0.5; }));
    const fs::path file = *rig_.window().control().recording();
    rig_.click("resetButton");
    return file;
  }

  DataFolder data_;
  WindowRig rig_;
};

TEST_F(DroppedFile, OfAPatientIsOpened)
{
  rig_.window().showPage("start");
  EXPECT_TRUE(drop(resource("resources/patients/left.toml")));
  EXPECT_TRUE(WindowRig::waitUntil([&] {
    return rig_.window().control().scenario().patient().side == anatomy::Side::left &&
           rig_.window().page() == "insert";
  }));
}

TEST_F(DroppedFile, OfARecordingIsReplayedAndNamedOnceInTheTitle)
{
  EXPECT_TRUE(drop(record()));
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return rig_.window().findChild<gui::ReplayBar*>()->isVisible(); }));
  EXPECT_EQ(rig_.window().windowTitle(),
            QString::fromUtf8("Replay of contour-published — Perilymph"));
}

/// A file that is named when the program is started goes where one goes that is dropped.
TEST_F(DroppedFile, IsOpenedByItsNameAlone)
{
  gui::MainWindow& window = rig_.window();
  const fs::path recording = record();
  window.showPage("start");
  window.openFile(resource("resources/patients/left.toml"));
  EXPECT_TRUE(WindowRig::waitUntil([&] {
    return window.control().scenario().patient().side == anatomy::Side::left &&
           window.page() == "insert";
  }));
  window.openFile(recording);
  EXPECT_TRUE(
      WindowRig::waitUntil([&] { return window.findChild<gui::ReplayBar*>()->isVisible(); }));
  const fs::path plan = data_.path() / "plan/plan.json";
  for (const auto& [file, page] : {std::pair{plan, "plan"}, std::pair{plan.parent_path(), "plan"},
                                   std::pair{data_.path() / "study.sqlite", "studies"},
                                   std::pair{data_.path() / "scans", "ct"}}) {
    fs::create_directories(plan.parent_path());
    std::ofstream(plan) << "{}";
    window.openFile(file);
    EXPECT_EQ(window.page(), page) << file;
  }
}

TEST_F(DroppedFile, OfAnotherKindIsNotTaken)
{
  EXPECT_FALSE(drop(resource("README.md")));
  EXPECT_FALSE(drop("/no/such/picture.png"));
}

TEST_F(DroppedFile, ThatIsNoPatientSaysWhy)
{
  EXPECT_TRUE(drop(resource("resources/scenarios/contour-published.toml")));
  EXPECT_TRUE(rig_.label("noticeText").contains("contour-published.toml"))
      << rig_.label("noticeText").toStdString();
}

TEST_F(DroppedFile, OfAnExaminationIsReadOnThePageOfTheCtFromEveryPage)
{
  const fs::path zip = data_.path() / "ct.zip", disc = data_.path() / "disc";
  fs::create_directories(disc);
  std::ofstream(disc / "DICOMDIR") << "no DICOM";
  std::ofstream(zip) << "PK\x03\x04 cut off";
  for (const fs::path& file : {zip, disc, disc / "DICOMDIR"}) {
    rig_.window().showPage("start");
    EXPECT_TRUE(drop(file)) << file;
    EXPECT_EQ(rig_.window().page(), "ct") << file;
    gui::CtPage& page = *rig_.window().pages().find<gui::CtPage>();
    EXPECT_TRUE(WindowRig::waitUntil([&] { return !page.isBusy(); }));
    EXPECT_FALSE(rig_.label("ctStatus").isEmpty()) << file;  // why it is none
    EXPECT_FALSE(page.study().hasCt());
  }
}

TEST_F(DroppedFile, OnThePageOfTheCtIsReadThereWhateverItIs)
{
  rig_.window().showPage("ct");
  EXPECT_TRUE(drop(resource("README.md")));
  EXPECT_TRUE(rig_.window().pages().find<gui::CtPage>()->isBusy());
  EXPECT_EQ(rig_.window().page(), "ct");
}

TEST(TopBar, NamesThePatientOnlyWhereThePageIsAboutOne)
{
  WindowRig rig;
  EXPECT_EQ(rig.label("patientLabel"), "Published cochlea · right ear");
  for (const char* page : {"sessionsPageButton", "validatePageButton", "comparePageButton"}) {
    rig.click(page);
    EXPECT_EQ(rig.label("patientLabel"), "") << page;
  }
  rig.click("insertPageButton");
  EXPECT_EQ(rig.label("patientLabel"), "Published cochlea · right ear");
}

}  // namespace
}  // namespace perilymph::test
