// SPDX-License-Identifier: BSD-3-Clause

// A page that the program does not know: one class and one line in the list, and the window shows its
// button, its key, its dropped files, its work and what it would lose.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QTest>
#include <utility>

#include "DroppedUrl.h"
#include "OwnFolders.h"
#include "WindowRig.h"
#include "gui/pages/Page.h"
#include "gui/shell/KeyList.h"
#include "gui/widgets/Notice.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

/// Counts, and opens files that end in .notes.
class NotesPage : public gui::Page {
public:
  explicit NotesPage(QWidget* parent)
      : Page("notes", "Surgeon's notes", gui::Icon::sessions, parent)
  {
  }

  bool isBusy() const override { return isWorking; }
  bool cancel() override { return std::exchange(isWorking, false); }
  Acceptance accepts(const fs::path& file) const override
  {
    return file.extension() == ".notes" ? Acceptance::always
           : file.extension() == ".txt" ? Acceptance::whileShown
                                        : Acceptance::none;
  }
  void open(const fs::path& file) override
  {
    opened = file;
    Q_EMIT pageRequested(id());
  }
  void onShown() override { ++shown; }
  void onChosenAgain() override { ++chosenAgain; }
  void onHidden() override { ++hidden; }
  std::optional<Unfinished> unfinished() const override
  {
    if (!isUnsaved) return std::nullopt;
    return Unfinished{"A note is not saved.", "Keep writing"};
  }
  void endUnfinished() override { isUnsaved = false; }

  bool isWorking = false, isUnsaved = false;
  int shown = 0, chosenAgain = 0, hidden = 0;
  fs::path opened;
};

/// A window with the page in place of the last one, for nine pages have keys.
class APageOfTheTestsOwn : public testing::Test {
protected:
  APageOfTheTestsOwn() : rig_({}, std::nullopt, WindowRig::sharedCochleae(), withNotes()) {}

  gui::PageList withNotes()
  {
    gui::PageList list = gui::standardPages();
    list.pop_back();
    list.push_back([this](const auto&, QWidget* parent) { return notes_ = new NotesPage(parent); });
    return list;
  }
  gui::MainWindow& window() { return rig_.window(); }

  DataFolder data_;
  NotesPage* notes_ = nullptr;
  WindowRig rig_;
};

TEST_F(APageOfTheTestsOwn, HasAButtonThatShowsAndMarksIt)
{
  auto& button = rig_.button("notesPageButton");
  window().resize(2600, 900);  // room for all names
  ASSERT_TRUE(QTest::qWaitFor([&] { return !button.text().isEmpty(); }));
  EXPECT_EQ(button.text(), "Surgeon's notes");
  EXPECT_FALSE(button.isChecked());
  button.click();
  EXPECT_EQ(window().page(), "notes");
  EXPECT_TRUE(notes_->isVisible());
  EXPECT_TRUE(button.isChecked());
  EXPECT_EQ(notes_->shown, 1);
  button.click();
  EXPECT_EQ(notes_->shown, 1);
  EXPECT_EQ(notes_->chosenAgain, 1);
  rig_.click("insertPageButton");
  EXPECT_FALSE(button.isChecked());
  EXPECT_EQ(notes_->hidden, 1);
}

TEST_F(APageOfTheTestsOwn, HasIconAndNameWhereThereIsRoomAndElseItsIcon)
{
  const auto& button = rig_.button("notesPageButton");
  window().resize(2600, 900);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window().width() == 2600; }));
  EXPECT_FALSE(button.icon().isNull());
  EXPECT_TRUE(QTest::qWaitFor([&] { return button.width() >= button.sizeHint().width(); }))
      << button.width() << " of " << button.sizeHint().width();
  window().resize(window().minimumSize());
  // patient and ear need the room: the name is in the tool tip, and for screen readers
  EXPECT_TRUE(QTest::qWaitFor([&] { return button.text().isEmpty(); }));
  EXPECT_FALSE(button.icon().isNull());
  EXPECT_EQ(button.toolTip(), "Surgeon's notes");
  EXPECT_EQ(button.accessibleName(), "Surgeon's notes");
}

TEST_F(APageOfTheTestsOwn, HasTheNextKeyWhichTheListOfKeysNames)
{
  const auto place = window().pages().all().size() - 1;
  rig_.pressKey(Qt::Key(Qt::Key_0 + int(place)), Qt::AltModifier);
  EXPECT_EQ(window().page(), "notes");
  QStringList texts;
  rig_.pressKey(Qt::Key_F1);
  for (const QLabel* label : window().findChild<gui::KeyList*>()->findChildren<QLabel*>())
    texts << label->text();
  EXPECT_TRUE(texts.join('\n').contains("Studies, Surgeon's notes"))
      << texts.join('\n').toStdString();
}

TEST_F(APageOfTheTestsOwn, OpensFilesDroppedOnAnyPageOrOnlyOnItself)
{
  EXPECT_FALSE(drop(window(), "/tmp/letter.txt"));
  EXPECT_TRUE(drop(window(), "/tmp/today.notes"));
  EXPECT_EQ(notes_->opened, "/tmp/today.notes");
  EXPECT_EQ(window().page(), "notes");
  EXPECT_TRUE(drop(window(), "/tmp/letter.txt"));
  EXPECT_EQ(notes_->opened, "/tmp/letter.txt");
  EXPECT_FALSE(drop(window(), "/tmp/letter.odt"));
}

TEST_F(APageOfTheTestsOwn, EndsItsWorkAtEscapeOnlyWhileItIsShown)
{
  notes_->isWorking = true;
  rig_.pressKey(Qt::Key_Escape);
  EXPECT_TRUE(notes_->isBusy());
  window().showPage("notes");
  rig_.pressKey(Qt::Key_Escape);
  EXPECT_FALSE(notes_->isBusy());
}

TEST_F(APageOfTheTestsOwn, IsAskedAboutBeforeTheWindowClosesAndKeepsItOpen)
{
  notes_->isUnsaved = true;
  window().close();
  EXPECT_TRUE(window().isVisible());
  EXPECT_EQ(window().notice().sentence(), "A note is not saved.");
  rig_.click("noticeDismissButton");
  EXPECT_TRUE(notes_->isUnsaved);
  window().close();
  rig_.click("noticeButton");
  EXPECT_FALSE(notes_->isUnsaved);
  EXPECT_FALSE(window().isVisible());
}

TEST_F(APageOfTheTestsOwn, ThatWouldLoseWorkIsAskedAboutAfterAnInsertion)
{
  rig_.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.travel_mm() > 0.1; }));
  notes_->isUnsaved = true;
  window().close();
  EXPECT_TRUE(window().notice().sentence().startsWith("Insertion in progress ("));
  rig_.click("noticeButton");
  EXPECT_TRUE(window().isVisible());
  EXPECT_EQ(window().notice().sentence(), "A note is not saved.");
  rig_.click("noticeButton");
  EXPECT_FALSE(window().isVisible());
}

TEST_F(APageOfTheTestsOwn, ReplaysAndShowsAMessageAndAnotherPage)
{
  Q_EMIT notes_->noted("Saved.");
  EXPECT_EQ(window().notice().sentence(), "Saved.");
  Q_EMIT notes_->pageRequested("validate");
  EXPECT_EQ(window().page(), "validate");
  auto scenario = session::loadScenario("mean-contour");
  ASSERT_TRUE(scenario);
  Q_EMIT notes_->insertionRequested({{*scenario, {}}});
  EXPECT_EQ(window().page(), "insert");
  EXPECT_TRUE(WindowRig::waitUntil(
      [&] { return window().control().scenario().anatomy() == anatomy::AnatomySource::mean; }));
}

TEST(TitleOfTheWindow, NamesTheScenarioOnlyWhereItIsShown)
{
  WindowRig rig;
  EXPECT_TRUE(rig.window().windowTitle().startsWith("Published experiment"));
  rig.click("ctPageButton");
  EXPECT_EQ(rig.window().page().toStdString(), "ct");
  EXPECT_EQ(rig.window().windowTitle(), QString::fromUtf8("CT — Perilymph"));
  rig.click("insertPageButton");
  EXPECT_TRUE(rig.window().windowTitle().startsWith("Published experiment"));
}

TEST(PageList, OfTheWindowHasPagesWithDifferentNames)
{
  WindowRig rig;
  QStringList ids, names;
  for (const gui::Page* page : rig.window().pages().all()) ids << page->id(), names << page->name();
  EXPECT_EQ(ids.removeDuplicates(), 0);
  EXPECT_EQ(names.removeDuplicates(), 0);
  EXPECT_THROW(rig.window().showPage("nowhere"), std::out_of_range);
}

}  // namespace
}  // namespace perilymph::test
