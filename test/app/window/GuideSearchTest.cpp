// SPDX-License-Identifier: BSD-3-Clause

// The search of the user guide, with words that users typed who had not read it.

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <algorithm>

#include "WindowRig.h"
#include "gui/shell/GuideOverlay.h"
#include "gui/shell/GuideSearch.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::test {
namespace {

constexpr std::ptrdiff_t seen = 3;  // without scrolling

struct Question {
  const char* words;
  const char* page;
  const char* heading;  // begin of it
};

void expectFound(const std::string& start, const std::vector<Question>& questions)
{
  const auto search = gui::GuideSearch::read(resource(start));
  ASSERT_TRUE(search) << search.error().message;
  for (const Question& each : questions) {
    const auto hits = search->find(each.words);
    const auto last = hits.begin() + std::min<std::ptrdiff_t>(seen, std::ssize(hits));
    EXPECT_TRUE(std::any_of(hits.begin(), last, [&](const gui::GuideHit& hit) {
      return hit.page.endsWith(QString("/") + each.page) && hit.heading.startsWith(each.heading);
    })) << each.words;
  }
}

TEST(GuideSearch, FindsWhatUsersAsk)
{
  expectFound("resources/guide/README.md",
              {{"tip fold over", "glossary.md", "tip fold-over"},
               {"what does peak force mean", "booth.md", "The levels"},
               {"force too high", "questions.md", "The force is too high"},
               {"import dicom", "questions.md", "My CT is not opened"},
               {"ct won't load", "questions.md", "My CT is not opened"},
               {"insertion depth angle", "glossary.md", "angular insertion depth"},
               {"cochlear duct length", "glossary.md", "cochlear duct length"},
               {"choose electrode", "glossary.md", "array"},
               {"replay insertion", "questions.md", "Can a result be reproduced"},
               {"export csv", "questions.md", "How do I print"},
               {"print report", "questions.md", "How do I print"},
               {"haptic device not connected", "questions.md", "My haptic device is not found"},
               {"calibrate force feedback", "questions.md", "How do I calibrate"},
               {"change language", "questions.md", "How do I change the language"},
               {"patient name anonymize", "questions.md", "How are patients anonymized"},
               {"compare two trials", "questions.md", "How do I compare"},
               {"scalar translocation", "glossary.md", "translocation"},
               {"set round window entry point", "glossary.md", "opening"},
               {"learning curve p value", "questions.md", "Is there a p value"},
               {"screen frozen no 3d picture", "questions.md", "The picture is slow"},
               {"keyboard shortcut", "questions.md", "Which keyboard shortcuts"}});
}

TEST(GuideSearch, FindsWhatUsersAskInGerman)
{
  expectFound("resources/guide/de/README.md",
              {{"ct einlesen", "questions.md", "Mein CT"},
               {"elektrode umgeknickt", "questions.md", "Die Kraft ist zu hoch"},
               {"einführtiefe", "glossary.md", "Insertionstiefe"},
               {"einfuhrtiefe", "glossary.md", "Insertionstiefe"},
               {"was bedeutet mN", "glossary.md", "Insertionskraft"},
               {"bericht drucken", "questions.md", "Wie drucke ich"},
               {"sprache umstellen", "questions.md", "Wie stelle ich Sprache"},
               {"kraftrückmeldung geht nicht", "questions.md", "Wie kalibriere ich"},
               {"patientendaten löschen", "questions.md", "Wie werden Patienten anonymisiert"},
               {"daten für statistik exportieren", "questions.md", "Wie drucke ich"},
               {"rundes fenster oder cochleostomie", "glossary.md", "Öffnung"},
               // part of a compound; a page that is English only
               {"umschlag", "glossary.md", "Spitzenumschlag"},
               {"tastenkürzel", "questions.md", "Welche Tastenkürzel"},
               {"OpenIGTLink", "navigation.md", ""}});
}

TEST(GuideSearch, ShowsRowsOfTablesAsText)
{
  const auto search = gui::GuideSearch::read(resource("resources/guide/README.md"));
  ASSERT_TRUE(search) << search.error().message;
  for (const char* words :
       {"speed", "force too high", "late ticks", "nodes", "keyboard", "shortcut"}) {
    const auto hits = search->find(words);
    EXPECT_FALSE(hits.empty()) << words;
    for (const gui::GuideHit& hit : hits)
      EXPECT_FALSE(hit.excerpt.contains(QLatin1String(" | "))) << hit.excerpt.toStdString();
  }
}

TEST(GuideSearch, TakesAnyLetters)
{
  const auto search = gui::GuideSearch::read(resource("resources/guide/README.md"));
  ASSERT_TRUE(search);
  for (const char* words : {"", " ", "?", "\"", "a\"b* OR NEAR(", "-", "''; DROP TABLE part", "力",
                            "body:force", "^force", "force AND NOT", "xyzzyx"})
    search->find(words);
  EXPECT_TRUE(search->find("xyzzyx").empty());
  EXPECT_FALSE(search->find("body:force").empty());
  EXPECT_FALSE(search->find(QString(100'000, 'e') + " force").empty());
}

TEST(WindowHabits, AWordIsSearchedInTheGuideAndItsPartIsShown)
{
  WindowRig rig;
  rig.pressKey(Qt::Key_F1, Qt::ShiftModifier);
  auto& sheet = *rig.window().findChild<gui::GuideOverlay*>();
  auto& words = *sheet.findChild<QLineEdit*>("guideWords");
  auto& page = *sheet.findChild<QTextBrowser*>("guidePage");
  auto& hits = *sheet.findChild<QTextBrowser*>("guideHits");
  QTest::keyClick(&page, Qt::Key_F, Qt::ControlModifier);
  QTest::keyClicks(&words, "calibrate force feedback");
  EXPECT_TRUE(hits.isVisible());
  EXPECT_TRUE(hits.toPlainText().startsWith("How do I calibrate the force feedback"));
  QTest::keyClick(&words, Qt::Key_Return);
  ASSERT_TRUE(page.isVisible());
  EXPECT_TRUE(page.textCursor().block().text().contains("How do I calibrate"));
  EXPECT_TRUE(page.viewport()->rect().contains(page.cursorRect().center()));
  rig.click("guideBackButton");
  EXPECT_TRUE(page.toPlainText().contains("Five tutorials"));
  words.setText("xyzzyx");
  EXPECT_TRUE(hits.toPlainText().contains("No page has"));
  words.clear();
  EXPECT_TRUE(page.isVisible());
  rig.pressKey(Qt::Key_Escape);
  EXPECT_FALSE(sheet.isVisible());
}

}  // namespace
}  // namespace perilymph::test
