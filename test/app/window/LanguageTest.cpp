// SPDX-License-Identifier: BSD-3-Clause

// The window in other languages: all texts are translated, and longer texts fit.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QCoreApplication>
#include <QKeySequence>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>
#include <algorithm>
#include <filesystem>

#include "CutTexts.h"
#include "WindowRig.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/insert/Pane.h"
#include "gui/pages/insert/SidePanel.h"
#include "gui/program/Languages.h"
#include "gui/setup/Catalog.h"
#include "gui/shell/GuideOverlay.h"
#include "gui/text/ChartLabels.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/Theme.h"
#include "perilymph/analysis/Reference.h"
#include "perilymph/analysis/Score.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/validation/ValidationReport.h"

namespace perilymph::test {
namespace {

/// A pseudo-language: every text in brackets, and every word 40 % longer.
class Bracketed : public QTranslator {
public:
  Bracketed()
  {
    gui::useLanguage(*QCoreApplication::instance(), "en");
    EXPECT_TRUE(german_.load(":/translations/perilymph_de.qm"));
    QCoreApplication::installTranslator(this);
  }
  ~Bracketed() override { QCoreApplication::removeTranslator(this); }
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char*, int) const override
  {
    // of the engine and of shipped files, only what has German
    if (QLatin1String(context) == QLatin1String("Data") &&
        german_.translate(context, source).isEmpty())
      return {};
    const QString text = QString::fromUtf8(source);
    QStringList words = text.split(QLatin1Char(' '));
    int added = 0;
    for (QString& word : words) {
      const int more = int(word.size()) * 2 / 5;
      word += QString(more, QLatin1Char('~'));
      added += more;
    }
    words.last() += QString(std::min(6, int(text.size()) * 2 / 5 - added), QLatin1Char('~'));
    return QLatin1Char('[') + words.join(QLatin1Char(' ')) + QLatin1Char(']');
  }

private:
  QTranslator german_;
};

/// The text of any widget.
QStringList textOf(const QWidget& widget)
{
  QStringList words{widget.toolTip(), widget.accessibleName()};
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) words << label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) words << button->text();
  if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) words << line->placeholderText();
  if (const auto* readOut = qobject_cast<const gui::ReadOut*>(&widget)) words << readOut->caption();
  return words;
}

/// Only numbers, signs, units and landmarks: no two adjacent letters except those of the latter.
bool needsNoTranslation(QString text)
{
  for (const char* unit : {"mm/s", "mm", "mN", "Hz", "ms", "SD", "CT", "RW", "LW"})
    text.remove(unit);
  for (int i = 1; i < text.size(); ++i)
    if (text[i - 1].isLetter() && text[i].isLetter()) return false;
  return true;
}

/// Names from data: arrays, patients, devices, languages in their own language.
bool isName(const QString& text, WindowRig& rig)
{
  const session::Scenario& scenario = rig.window().control().scenario();
  const QStringList names{QString::fromStdString(scenario.array().name),
                          QString::fromStdString(scenario.array().note),
                          QString::fromStdString(scenario.patient().label),
                          QString::fromUtf8(nameOf(scenario.anatomy())),
                          QString::fromStdString(rig.window().control().inputName()),
                          QStringLiteral("English"),
                          QStringLiteral("Deutsch")};
  for (const gui::CatalogFriction& friction : gui::catalogFrictions())
    if (text == friction.title || text == friction.source) return true;
  for (const gui::CatalogArray& array : gui::catalogArrays())
    if (text == array.title || text == array.maker) return true;
  // a scenario's title and sources come from its file, in English
  const QString title = QString::fromStdString(scenario.title());
  const bool isOfScenario = text == title || text.startsWith(QLatin1String("Todd and Naghdy, "));
  return isOfScenario || names.contains(text);
}

void expectTranslated(WindowRig& rig, const char* where)
{
  for (const QWidget* widget : rig.window().findChildren<QWidget*>()) {
    if (!widget->isVisible()) continue;
    for (const QString& text : textOf(*widget))
      EXPECT_TRUE(text.contains(QLatin1Char('[')) || needsNoTranslation(text) || isName(text, rig))
          << where << ", " << widget->objectName().toStdString() << ": " << text.toStdString();
  }
}

/// Activates nested layouts, the outer ones first.
void settle()
{
  for (int i = 0; i < 8; ++i) QCoreApplication::processEvents();
}

void expectFits(WindowRig& rig, const char* where)
{
  for (const std::string& text : cutTextsOf(rig.window())) ADD_FAILURE() << where << ", " << text;
}

/// Waits until the measures of the patient shown have come. Their tooltips name formulas and sources.
bool measuresCome(WindowRig& rig)
{
  return rig.waitUntil([&] {
    const auto labels = rig.window().findChildren<QLabel*>(QStringLiteral("duct_length_mm"));
    return std::any_of(labels.begin(), labels.end(), [](const QLabel* each) {
      return each->isVisible() && !each->toolTip().isEmpty();
    });
  });
}

TEST(PseudoLanguage, FormulasAndSourcesOfThePatientsMeasuresAreTranslated)
{
  const Bracketed language;
  // each anatomy has its own formula of the duct's length
  for (const char* anatomy : {"\"published\"", "\"mean\""}) {
    WindowRig rig({{"anatomy", anatomy}, {"array", "\"flex28\""}});
    rig.window().showPage("insert");
    ASSERT_TRUE(measuresCome(rig)) << anatomy;
    int tips = 0;
    for (const char* row : {"duct_length_mm", "angular_insertion_depth_deg", "coverage_percent"})
      for (const QLabel* label : rig.window().findChildren<QLabel*>(QLatin1String(row))) {
        if (!label->isVisible()) continue;
        for (const QString& line : label->toolTip().split(QLatin1Char('\n'))) {
          ++tips;
          EXPECT_TRUE(line.startsWith(QLatin1Char('[')) || needsNoTranslation(line))
              << anatomy << ", " << row << ": " << line.toStdString();
        }
      }
    EXPECT_EQ(tips, 6) << anatomy;
  }
}

TEST(PseudoLanguage, EveryWordOfEveryPageComesFromATranslation)
{
  const Bracketed language;
  WindowRig rig;
  for (const gui::Page* page : rig.window().pages().all()) {
    rig.window().showPage(*page);
    expectTranslated(rig, qPrintable(page->id()));
  }
  rig.window().showPage("insert");
  EXPECT_TRUE(measuresCome(rig));
  rig.pressKey(Qt::Key_F1);
  rig.pressKey(Qt::Key_Comma, Qt::ControlModifier);
  rig.pressKey(Qt::Key_H);
  expectTranslated(rig, "sheets");
}

TEST(PseudoLanguage, WordsThatAreFortyPercentLongerHaveRoom)
{
  const Bracketed language;
  WindowRig rig;
  for (const gui::Page* page : rig.window().pages().all()) {
    if (page->id() == "ct") continue;  // its narrow buttons have no room for longer words
    rig.window().showPage(*page);
    settle();
    expectFits(rig, qPrintable(page->id()));
  }
  rig.window().showPage("insert");
  rig.window().views().setArrangement(gui::PaneLayout::four);
  settle();
  expectFits(rig, "four views");
  rig.window().views().setArrangement(gui::PaneLayout::two);
}

/// The texts of a figure.
QStringList textOf(const figures::Figure& figure)
{
  QStringList texts;
  const auto add = [&texts](const std::string& text) {
    if (!text.empty()) texts << QString::fromStdString(text);
  };
  add(figure.title);
  add(figure.x.title);
  add(figure.y.title);
  for (const auto& each : figure.bands) add(each.label);
  for (const auto& each : figure.levels) add(each.label);
  for (const auto& each : figure.curves) add(each.label);
  for (const auto& each : figure.values) add(each.label);
  for (const Sentence& note : figure.notes) add(note);
  return texts;
}

TEST(PseudoLanguage, TextsOfDataFilesAndOfTheEngineAreTranslated)
{
  const Bracketed translator;
  QStringList texts;
  for (const gui::CatalogFriction& friction : gui::catalogFrictions()) texts << friction.title;
  const auto score = analysis::scoreOf(analysis::ComparedInsertion{});
  ASSERT_TRUE(score);
  for (const analysis::ScoreCriterion& each : score->criteria)
    for (const Sentence& text : {each.name, each.found, each.band, each.source})
      texts << gui::dataText(text);
  const auto experiment = analysis::shippedReference("todd-naghdy-experiment");
  const auto simulator = analysis::shippedReference("todd-naghdy-simulator");
  const auto difference = analysis::shippedReference("todd-naghdy-difference");
  ASSERT_TRUE(experiment && simulator && difference);
  const validation::ValidationResult none{};
  for (const figures::Figure& figure : {validation::experimentFigure(*experiment, *simulator),
                                        validation::simulationFigure(none, *experiment),
                                        validation::differenceFigure(none, *difference)})
    texts << textOf(gui::translated(figure));
  for (const validation::Verdict& verdict : validation::verdictsOf(none, *experiment))
    for (const Sentence& text : {verdict.what, verdict.wanted}) texts << gui::dataText(text);
  for (const QString& text : texts)
    EXPECT_TRUE(text.contains(QLatin1Char('['))) << text.toStdString();
}

TEST(PseudoLanguage, LimitsOfPlansAreTranslated)
{
  const Bracketed bracketed;
  for (const Sentence& limit : planning::limitsOfPlans())
    EXPECT_TRUE(gui::dataText(limit).startsWith(QLatin1Char('['))) << limit;
}

TEST(PseudoLanguage, SourcesInAReportAreTranslated)
{
  const Bracketed bracketed;
  int sources = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(resource("plugins/electrodes"))) {
    if (entry.path().extension() != ".toml") continue;
    const auto array = electrode::loadArray(entry.path());
    ASSERT_TRUE(array) << array.error().message;
    for (const auto& [part, provenance] : array->provenance) {
      ++sources;
      EXPECT_TRUE(gui::dataText(provenance.source).startsWith(QLatin1Char('[')))
          << entry.path() << ": " << provenance.source;
    }
  }
  EXPECT_GT(sources, 90);
  const auto inVitro = analysis::shippedReference("in-vitro");
  ASSERT_TRUE(inVitro);
  const auto* rupture = inVitro->findRange("rupture of the partition");
  ASSERT_NE(rupture, nullptr);
  EXPECT_TRUE(gui::dataText(rupture->source).startsWith(QLatin1Char('['))) << rupture->source;
}

TEST(PseudoLanguage, TitlesOfShippedScenariosAreTranslated)
{
  const Bracketed bracketed;
  int scenarios = 0;
  for (const auto& entry : std::filesystem::directory_iterator(resource("resources/scenarios"))) {
    if (entry.path().extension() != ".toml") continue;
    const auto scenario = session::loadScenario(entry.path().string());
    ASSERT_TRUE(scenario) << scenario.error().message;
    ++scenarios;
    EXPECT_TRUE(gui::dataText(scenario->title()).startsWith(QLatin1Char('['))) << entry.path();
  }
  EXPECT_GE(scenarios, 4);
}

TEST(PseudoLanguage, FlagsOfAMeasurementInACtAreTranslated)
{
  const Bracketed bracketed;
  for (const ct::Flag flag : ct::allFlags())
    EXPECT_TRUE(gui::dataText(ct::sentenceOf(flag)).startsWith(QLatin1Char('[')))
        << ct::nameOf(flag);
}

TEST(German, NamesTheModifiedScenarioInTheTitleOfTheWindow)
{
  gui::useLanguage(*QCoreApplication::instance(), "de");
  {
    WindowRig rig;
    EXPECT_TRUE(rig.label("scenarioTitle").startsWith("Veröffentlichter Versuch"));
    EXPECT_TRUE(rig.window().windowTitle().startsWith("Veröffentlichter Versuch"));
    rig.choose("techniqueSelector", "aos");
    EXPECT_TRUE(WindowRig::waitUntil([&] {
      return rig.window().windowTitle().startsWith("Geändert (Technik): Veröffentlichter Versuch");
    })) << rig.window().windowTitle().toStdString();
  }
  gui::useLanguage(*QCoreApplication::instance(), "en");
  QLocale::setDefault(QLocale::c());
}

TEST(German, TranslatesNumbersInTextsOfData)
{
  gui::useLanguage(*QCoreApplication::instance(), "de");
  EXPECT_EQ(gui::dataText(std::string("Soap 10 %: speed-independent")),
            "Seife 10 %: geschwindigkeitsunabhängig");
  EXPECT_EQ(gui::dataText(Sentence{"%1 mN", "95.0"}), "95,0 mN");
  EXPECT_EQ(gui::dataText(std::string("unknown 1.5")), "unknown 1.5");
  gui::useLanguage(*QCoreApplication::instance(), "en");
  QLocale::setDefault(QLocale::c());
}

TEST(German, IsShownWhenRequested)
{
  gui::useLanguage(*QCoreApplication::instance(), "de");
  {
    WindowRig rig;
    EXPECT_EQ(rig.button("resetButton").text(), "Zurücksetzen");
    EXPECT_TRUE(rig.readOut("travelReadOut").contains(QLatin1Char(',')));
    const auto keyName = [](const QKeySequence& keys) {
      return keys.toString(QKeySequence::NativeText);
    };
    EXPECT_EQ(keyName(Qt::Key_Space), "Leertaste");
    EXPECT_EQ(keyName(Qt::Key_Backspace), "Rücktaste");
    EXPECT_EQ(keyName(QKeySequence(Qt::ControlModifier | Qt::Key_R)), "Strg+R");
    EXPECT_EQ(gui::guideStart(gui::guideFolder()).parent_path().filename(), "de");
    // texts drawn by VTK in the scene and the charts
    EXPECT_EQ(gui::sceneStyle(gui::shownColorScheme()).strings.wallForce, "Wandkraft, mN je mm");
    EXPECT_EQ(gui::sceneStyle(gui::shownColorScheme()).strings.friction,
              "Reibkraft (Pfeile %1-fach)");
    EXPECT_EQ(gui::chartStyle(gui::shownColorScheme()).strings.outerWall, "Außenwand");
    EXPECT_EQ(gui::chartStyle(gui::shownColorScheme()).strings.decimalSign, ',');
    const auto reference = analysis::shippedReference("todd-naghdy-experiment");
    ASSERT_TRUE(reference);
    EXPECT_TRUE(gui::referenceName(reference->label).startsWith("veröffentlichte Messungen"));
  }
  gui::useLanguage(*QCoreApplication::instance(), "en");
  EXPECT_EQ(gui::sceneStyle(gui::shownColorScheme()).strings.wallForce,
            visualization::SceneStrings().wallForce);
  WindowRig rig;
  EXPECT_EQ(rig.button("resetButton").text(), "Reset");
  QLocale::setDefault(QLocale::c());
}

// 34,125 and 34.125 are the same length, typed in two conventions; neither is 34125.
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
      EXPECT_TRUE(WindowRig::waitUntil([&] {
        return rig.window().control().scenario().patient().scalaTympaniLength ==
               millimeters(34.125);
      })) << typed;
    }
    // a thousand in German notation is not read as one
    rig.type("panelNodes", "1.000");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.button("startButton").isEnabled(); }));
    rig.click("startButton");
    EXPECT_TRUE(rig.label("bannerText").contains("1024")) << rig.label("bannerText").toStdString();
    EXPECT_EQ(rig.window().control().scenario().nodes(), 100);
  }
  QLocale::setDefault(QLocale::c());
}

}  // namespace
}  // namespace perilymph::test
