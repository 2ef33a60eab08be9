// SPDX-License-Identifier: BSD-3-Clause

// Readability in both color schemes of the window.

#include <gtest/gtest.h>

#include <QRegularExpression>
#include <QTextBlock>
#include <QTextBrowser>

#include "Contrast.h"
#include "WindowRig.h"
#include "gui/pages/validate/ValidatePage.h"
#include "gui/widgets/DrawingView.h"
#include "gui/widgets/Theme.h"

namespace perilymph::test {
namespace {

constexpr double ofText = 4.5;
constexpr double ofMarks = 3.0;  // WCAG 2.1, 1.4.11: graphics

TEST(Contrast, OfBlackOnWhiteIsTwentyOne)
{
  EXPECT_NEAR(contrast(Qt::black, Qt::white), 21.0, 1e-9);
}

class EveryColorScheme : public testing::TestWithParam<gui::ColorScheme> {
protected:
  ~EveryColorScheme() override { gui::setShownColorScheme(gui::ColorScheme::dark); }
};

TEST_P(EveryColorScheme, HasReadableText)
{
  const gui::Theme& theme = gui::themeOf(GetParam());
  const std::pair<const char*, QColor> inks[] = {
      {"text", theme.text}, {"quiet text", theme.quietText}, {"warning", theme.warning}};
  const std::pair<const char*, QColor> grounds[] = {{"ground", theme.ground},
                                                    {"panel", theme.panel},
                                                    {"raised", theme.raised},
                                                    {"line", theme.line},
                                                    {"banner", theme.banner}};
  for (const auto& [ink, color] : inks)
    for (const auto& [ground, below] : grounds)
      EXPECT_GE(contrast(color, below), ofText) << ink << " on " << ground;
  for (const QColor& below : {theme.ground, theme.panel, theme.raised})
    EXPECT_GE(contrast(theme.accent, below), ofText) << "accent";
  EXPECT_GE(contrast(theme.onAccent, theme.accent), ofText);
  EXPECT_GE(contrast(theme.onAccent, theme.accentHover), ofText);
  EXPECT_GE(contrast(theme.onWarning, theme.warning), ofText);
  EXPECT_GE(contrast(theme.alarm, theme.panel), ofMarks);
  EXPECT_GE(contrast(theme.ghost, theme.ground), ofMarks);
  EXPECT_GE(contrast(theme.ahead, theme.ground), ofMarks);
  EXPECT_GE(contrast(theme.ahead, theme.panel), ofMarks);
  EXPECT_GE(contrast(theme.border, theme.ground), ofMarks);
  EXPECT_GE(contrast(theme.border, theme.panel), ofMarks);
}

TEST_P(EveryColorScheme, WritesOverThePictureSoThatItCanBeReadOverAnything)
{
  const gui::Theme& theme = gui::themeOf(GetParam());
  const double cover = gui::plateAlpha / 255.0;
  for (const QColor& behind : {QColor(Qt::white), QColor(Qt::black)}) {
    const auto over = [cover](double plate, double back) {
      return float(cover * plate + (1.0 - cover) * back);
    };
    const QColor plate = QColor::fromRgbF(over(theme.ground.redF(), behind.redF()),
                                          over(theme.ground.greenF(), behind.greenF()),
                                          over(theme.ground.blueF(), behind.blueF()));
    for (const QColor& ink : {theme.text, theme.quietText, theme.warning})
      EXPECT_GE(contrast(ink, plate), ofText) << ink.name().toStdString();
  }
}

TEST_P(EveryColorScheme, NamesEveryColorOfItsStyleSheet)
{
  gui::setShownColorScheme(GetParam());
  EXPECT_FALSE(gui::windowStyle().contains(QLatin1Char('%')));
}

TEST_P(EveryColorScheme, HasNoOtherColorsInItsStyleSheet)
{
  gui::setShownColorScheme(GetParam());
  const gui::Theme& theme = gui::themeOf(GetParam());
  QStringList own;
  for (const QColor& color :
       {theme.ground, theme.panel, theme.raised, theme.pressed, theme.line, theme.border,
        theme.text, theme.quietText, theme.accent, theme.accentHover, theme.onAccent, theme.warning,
        theme.onWarning, theme.banner})
    own << color.name();
  // the stop button is red and white in every scheme, as on machines
  own << QStringLiteral("#c4161c") << QStringLiteral("#8e0f14") << QStringLiteral("#ffffff");
  auto found =
      QRegularExpression(QStringLiteral("#[0-9A-Fa-f]{6}\\b")).globalMatch(gui::windowStyle());
  while (found.hasNext()) {
    const QString color = found.next().captured().toLower();
    EXPECT_TRUE(own.contains(color)) << color.toStdString() << " is of no look";
  }
}

TEST_P(EveryColorScheme, IsThatOfPicturesAndChartsToo)
{
  gui::setShownColorScheme(GetParam());
  WindowRig rig;
  const QImage window = rig.window().grab().toImage();
  const bool isLight = GetParam() == gui::ColorScheme::light;
  // edges of the scene, away from the array, and of the chart column
  const QImage scene = rig.picture();
  EXPECT_EQ(qGray(scene.pixel(scene.width() - 4, 3)) > 128, isLight);
  EXPECT_EQ(qGray(window.pixel(window.width() - 4, window.height() / 2)) > 128, isLight);
  EXPECT_EQ(qGray(window.pixel(4, window.height() / 2)) > 128, isLight);
}

TEST_P(EveryColorScheme, IsThatOfTheStartCardsAndOfTheFigures)
{
  gui::setShownColorScheme(GetParam());
  WindowRig rig;
  const bool isLight = GetParam() == gui::ColorScheme::light;
  rig.window().showPage("start");
  for (const char* name : {"patientCard", "meanCard", "demonstrationCard"}) {
    const QImage card = rig.button(name).grab().toImage();
    EXPECT_EQ(qGray(card.pixel(card.width() / 2, card.height() - 6)) > 128, isLight) << name;
    // a CT is as gray in every scheme
    if (QLatin1String(name) == QLatin1String("patientCard")) continue;
    EXPECT_EQ(qGray(card.pixel(card.width() / 2, 8)) > 128, isLight) << name;
  }
  rig.click("validatePageButton");
  auto* figure = rig.window().findChild<gui::ValidatePage*>()->findChild<gui::DrawingView*>();
  const QImage sheet = figure->grab().toImage();
  EXPECT_EQ(sheet.pixelColor(sheet.rect().center()), gui::themeOf(GetParam()).ground);
}

TEST_P(EveryColorScheme, DimsWhatCannotBePressed)
{
  gui::setShownColorScheme(GetParam());
  WindowRig rig;
  rig.click("sessionsPageButton");  // nothing is selected
  QAbstractButton& off = rig.button("compareButton");
  ASSERT_FALSE(off.isEnabled());
  const auto groundOf = [](QWidget& button) {
    return button.grab().toImage().pixelColor(8, button.height() / 2);
  };
  const gui::Theme& theme = gui::themeOf(GetParam());
  // closer to the page than an enabled button
  EXPECT_LT(std::abs(luminance(groundOf(off)) - luminance(theme.panel)),
            std::abs(luminance(theme.raised) - luminance(theme.panel)));
}

TEST_P(EveryColorScheme, ColorsTheLinksOfTheGuide)
{
  gui::setShownColorScheme(GetParam());
  WindowRig rig;
  rig.pressKey(Qt::Key_F1, Qt::ShiftModifier);
  const auto* page = rig.window().findChild<QTextBrowser*>("guidePage");
  int links = 0;
  for (QTextBlock block = page->document()->begin(); block.isValid(); block = block.next())
    for (auto part = block.begin(); !part.atEnd(); ++part) {
      const QTextCharFormat format = part.fragment().charFormat();
      if (!format.isAnchor()) continue;
      ++links;
      EXPECT_EQ(format.foreground().color(), gui::themeOf(GetParam()).accent);
      EXPECT_GT(block.blockFormat().bottomMargin(), 0.0);
    }
  EXPECT_GT(links, 5);
  EXPECT_FALSE(page->toPlainText().contains("make-pictures"));
}

INSTANTIATE_TEST_SUITE_P(OfTheWindow, EveryColorScheme,
                         testing::Values(gui::ColorScheme::dark, gui::ColorScheme::light));

}  // namespace
}  // namespace perilymph::test
