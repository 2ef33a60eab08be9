// The window in other languages: every word comes from a translation, and longer words have room.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QCoreApplication>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QTranslator>

#include "Catalog.h"
#include "Languages.h"
#include "Numbers.h"
#include "Pane.h"
#include "SidePanel.h"
#include "WindowRig.h"

namespace perilymph::test {
namespace {

/// A language that no one speaks: brackets around every word, and 40 % more of it.
class Bracketed : public QTranslator {
public:
  Bracketed() { QCoreApplication::installTranslator(this); }
  ~Bracketed() override { QCoreApplication::removeTranslator(this); }
  bool isEmpty() const override { return false; }
  QString translate(const char*, const char* source, const char*, int) const override
  {
    const QString text = QString::fromUtf8(source);
    return QLatin1Char('[') + text + QString(text.size() * 2 / 5, QLatin1Char('~')) +
           QLatin1Char(']');
  }
};

/// The words of a widget, whatever it is.
QStringList wordsOf(const QWidget& widget)
{
  QStringList words{widget.toolTip(), widget.accessibleName()};
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) words << label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) words << button->text();
  if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) words << line->placeholderText();
  if (const auto* readOut = qobject_cast<const gui::ReadOut*>(&widget)) words << readOut->caption();
  return words;
}

/// Numbers, signs and units: no two letters beside each other but those of a unit.
bool needsNoTranslation(QString text)
{
  for (const char* unit : {"mm/s", "mm", "mN", "Hz", "ms", "SD", "CT"}) text.remove(unit);
  for (int i = 1; i < text.size(); ++i)
    if (text[i - 1].isLetter() && text[i].isLetter()) return false;
  return true;
}

/// Names that stand in data: arrays, patients, devices, languages by their own names.
bool isName(const QString& text, WindowRig& rig)
{
  const session::Scenario& scenario = rig.window().control().scenario();
  const QStringList names{QString::fromStdString(scenario.array.name),
                          QString::fromStdString(scenario.array.note),
                          QString::fromStdString(scenario.patient.label),
                          QString::fromStdString(scenario.anatomy),
                          QString::fromStdString(rig.window().control().handName()),
                          QStringLiteral("English"),
                          QStringLiteral("Deutsch")};
  for (const gui::CatalogFriction& friction : gui::catalogFrictions())
    if (text == friction.title || text == friction.source) return true;
  // a scenario's title and where its numbers were printed stand in its file, in English
  const QString title = QString::fromStdString(scenario.title);
  const bool isOfScenario = text == title || text.startsWith(QLatin1String("Todd and Naghdy, "));
  return isOfScenario || names.contains(text);
}

void expectTranslated(WindowRig& rig, const char* where)
{
  for (const QWidget* widget : rig.window().findChildren<QWidget*>()) {
    if (!widget->isVisible()) continue;
    for (const QString& text : wordsOf(*widget))
      EXPECT_TRUE(text.contains(QLatin1Char('[')) || needsNoTranslation(text) || isName(text, rig))
          << where << ", " << widget->objectName().toStdString() << ": " << text.toStdString();
  }
}

template <class Part>
bool isInside(const QWidget* widget)
{
  while (widget != nullptr && qobject_cast<const Part*>(widget) == nullptr)
    widget = widget->parentWidget();
  return widget != nullptr;
}

void expectRoom(WindowRig& rig, const char* where)
{
  for (const QLabel* label : rig.window().findChildren<QLabel*>()) {
    // Not covered: the side panel and the titles over the charts, which have a fixed width.
    const bool isNarrow = isInside<gui::SidePanel>(label) || isInside<gui::Pane>(label);
    const bool mayBeCut = isNarrow || label->wordWrap() || label->objectName() == "statusLabel";
    if (!label->isVisible() || label->text().isEmpty() || mayBeCut) continue;
    EXPECT_GE(label->width(), label->sizeHint().width())
        << where << ": " << label->text().toStdString();
  }
  for (const QAbstractButton* button : rig.window().findChildren<QAbstractButton*>()) {
    if (!button->isVisible() || button->text().isEmpty()) continue;
    const int needed = QFontMetrics(button->font()).horizontalAdvance(button->text());
    EXPECT_GE(button->width(), needed) << where << ": " << button->text().toStdString();
  }
}

constexpr std::pair<gui::Page, const char*> pages[] = {{gui::Page::start, "start"},
                                                       {gui::Page::insert, "insert"},
                                                       {gui::Page::compare, "compare"},
                                                       {gui::Page::validate, "validate"},
                                                       {gui::Page::sessions, "sessions"}};

TEST(PseudoLanguage, EveryWordOfEveryPageComesFromATranslation)
{
  const Bracketed language;
  WindowRig rig;
  for (const auto& [page, name] : pages) {
    rig.window().showPage(page);
    expectTranslated(rig, name);
  }
  rig.window().showPage(gui::Page::insert);
  rig.pressKey(Qt::Key_F1);
  rig.pressKey(Qt::Key_Comma, Qt::ControlModifier);
  rig.pressKey(Qt::Key_H);
  expectTranslated(rig, "sheets");
}

TEST(PseudoLanguage, WordsThatAreFortyPercentLongerHaveRoomOutsideThePanelAndTheCharts)
{
  const Bracketed language;
  WindowRig rig;
  for (const auto& [page, name] : pages) {
    rig.window().showPage(page);
    QCoreApplication::processEvents();
    expectRoom(rig, name);
  }
}

TEST(German, IsSpokenWhenAskedFor)
{
  gui::useLanguage(*QCoreApplication::instance(), "de");
  {
    WindowRig rig;
    EXPECT_EQ(rig.button("resetButton").text(), "Neu");
    EXPECT_TRUE(rig.readOut("travelReadOut").contains(QLatin1Char(',')));
  }
  gui::useLanguage(*QCoreApplication::instance(), "en");
  WindowRig rig;
  EXPECT_EQ(rig.button("resetButton").text(), "Reset");
  QLocale::setDefault(QLocale::c());
}

// 34,125 and 34.125 are the same length, typed by two people; neither is 34125 of them.
TEST(ALengthTyped, MeansTheSameWithCommaAndPointInEveryLocale)
{
  for (const char* language : {"en", "de", "de_CH", "fr"}) {
    QLocale::setDefault(QLocale(QLatin1String(language)));
    for (const char* typed : {"34,125", "34.125", " 34.125 "})
      EXPECT_EQ(gui::typedNumber(QLatin1String(typed)), 34.125) << language << ": " << typed;
    for (const char* typed : {"34.125,0", "3,4,1", "1.234.567", "34 125", "34'125", "", "nan"})
      EXPECT_FALSE(gui::typedNumber(QLatin1String(typed))) << language << ": " << typed;
    EXPECT_EQ(gui::typedNumber(gui::numberText(1234.5, 1)), 1234.5) << language;
  }
  QLocale::setDefault(QLocale::c());
}

TEST(ALengthTyped, IsThePatientsInAGermanWindow)
{
  QLocale::setDefault(QLocale(QLocale::German));
  {
    WindowRig rig;
    for (const char* typed : {"34,125", "34.125"}) {
      rig.type("panelScalaLength", "30");
      rig.type("panelScalaLength", typed);
      EXPECT_TRUE(WindowRig::comes([&] {
        return rig.window().control().scenario().patient.scalaTympaniLength == millimeters(34.125);
      })) << typed;
    }
    // what could be meant either way as thousands of nodes gets a sentence
    rig.type("panelNodes", "1.000");
    rig.click("startButton");
    EXPECT_TRUE(rig.label("bannerText").contains("1024"));
  }
  QLocale::setDefault(QLocale::c());
}

}  // namespace
}  // namespace perilymph::test
