// SPDX-License-Identifier: BSD-3-Clause

// Text from files and users is plain text: it is never interpreted as markup.

#include <gtest/gtest.h>

#include <QLabel>
#include <QTest>
#include <QToolTip>
#include <fstream>

#include "OwnFolders.h"
#include "WindowRig.h"
#include "gui/pages/sessions/SessionsPage.h"
#include "gui/report/ReportContent.h"
#include "gui/report/ReportText.h"
#include "gui/widgets/Notice.h"

namespace perilymph::test {
namespace {

constexpr auto image = "<img src=\"file:///gone.png\">";
constexpr auto bold = "<b>bold</b>";

/// A window with a patient and a scenario whose names contain markup.
class MarkupNames : public testing::Test {
protected:
  MarkupNames() { rig_.window().load({{scenario(), {}}}); }

  session::Scenario scenario() const
  {
    const auto patient = folder_ / "patient.toml";
    std::ofstream(patient) << "label = '" << image << "'\nside = 'left'\nst_length_mm = 35.58\n"
                           << "rw_width_mm = 1.94\nrw_height_mm = 1.85\n";
    const auto file = folder_ / "scenario.toml";
    std::ofstream(file) << "title = '" << bold << "'\narray = 'contour'\nanatomy = 'published'\n"
                        << "patient = '" << patient.string() << "'\n";
    const auto read = session::loadScenario(file.string());
    EXPECT_TRUE(read) << read.error().message;
    return *read;
  }
  /// All labels that show a text.
  std::vector<const QLabel*> labelsWith(const char* text)
  {
    std::vector<const QLabel*> found;
    for (const QLabel* label : rig_.window().findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(QLatin1String(text))) found.push_back(label);
    return found;
  }
  /// Every label is as wide as the characters of its plain text.
  static void expectLiteral(const QLabel& label)
  {
    EXPECT_EQ(label.textFormat(), Qt::PlainText) << label.text().toStdString();
    if (label.wordWrap()) return;
    EXPECT_GE(label.sizeHint().width(), QFontMetrics(label.font()).horizontalAdvance(label.text()));
  }

  DataFolder data_;
  TemporaryFolder folder_;
  WindowRig rig_;
};

TEST_F(MarkupNames, AreShownVerbatim)
{
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !labelsWith(image).empty(); }));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !labelsWith(bold).empty(); }));
  for (const QLabel* label : labelsWith("<")) expectLiteral(*label);
}

TEST_F(MarkupNames, AreShownVerbatimInEverySentence)
{
  rig_.window().notice().showMessage(bold);
  rig_.window().showError(image);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return labelsWith("<").size() >= 3; }));
  for (const QLabel* label : labelsWith("<")) expectLiteral(*label);
}

TEST_F(MarkupNames, AreShownVerbatimInTooltips)
{
  QToolTip::showText({10, 10}, bold, &rig_.window());
  const auto tip = [] {
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (widget->inherits("QTipLabel")) return qobject_cast<QLabel*>(widget);
    return static_cast<QLabel*>(nullptr);
  };
  ASSERT_TRUE(WindowRig::waitUntil([&] { return tip() != nullptr && tip()->isVisible(); }));
  expectLiteral(*tip());
  QToolTip::hideText();
}

TEST_F(MarkupNames, AreListedVerbatim)
{
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !labelsWith(image).empty(); }));
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.button("startButton").isEnabled(); }));
  rig_.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.travel_mm() > 0.1; }));
  rig_.click("sessionsPageButton");
  auto* page = rig_.window().findChild<gui::SessionsPage*>();
  page->showMessage(image, true);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !labelsWith(image).empty(); }));
  for (const QLabel* label : labelsWith("<")) expectLiteral(*label);
}

TEST_F(MarkupNames, AreEscapedInTheReport)
{
  gui::ReportContent content;
  content.scenario = scenario();
  content.facts.device = bold;
  content.facts.scenarioName = bold;
  content.file = "<u>.insertion";
  gui::References references;
  const QString text = gui::appendixText(content, references);
  EXPECT_TRUE(text.contains("&lt;img"));
  EXPECT_TRUE(text.contains("&lt;b&gt;bold"));
  EXPECT_FALSE(text.contains(image));
  EXPECT_FALSE(text.contains(bold));
  EXPECT_FALSE(text.contains("<u>"));
}

}  // namespace
}  // namespace perilymph::test
