// SPDX-License-Identifier: BSD-3-Clause

// What visitors of the booth read and take away: levels of force, sizes of type, languages, the QR
// code of their curve, read by another program from the screen.

#include <gtest/gtest.h>
#include <zbar.h>

#include <QLocale>
#include <QPushButton>
#include <cmath>
#include <set>

#include "BoothFixture.h"
#include "CutTexts.h"
#include "gui/kiosk/ForceLevel.h"
#include "gui/kiosk/KioskScreen.h"
#include "gui/kiosk/Legibility.h"
#include "gui/kiosk/LevelGauge.h"
#include "gui/kiosk/QrView.h"
#include "gui/kiosk/TakeAway.h"
#include "gui/program/Languages.h"
#include "gui/scene/PhaseLine.h"
#include "gui/widgets/Theme.h"
#include "perilymph/analysis/ForceProfile.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"

namespace perilymph::test {
namespace {

/// The texts of the QR codes in a picture, as ZBar reads them.
std::vector<QString> codesIn(const QImage& picture)
{
  const QImage gray = picture.convertToFormat(QImage::Format_Grayscale8);
  QByteArray pixels;
  for (int y = 0; y < gray.height(); ++y)
    pixels.append(reinterpret_cast<const char*>(gray.constScanLine(y)), gray.width());
  zbar::Image image(unsigned(gray.width()), unsigned(gray.height()), "Y800", pixels.constData(),
                    unsigned(pixels.size()));
  zbar::ImageScanner scanner;
  scanner.set_config(zbar::ZBAR_NONE, zbar::ZBAR_CFG_ENABLE, 0);
  scanner.set_config(zbar::ZBAR_QRCODE, zbar::ZBAR_CFG_ENABLE, 1);
  scanner.scan(image);
  std::vector<QString> codes;
  for (auto each = image.symbol_begin(); each != image.symbol_end(); ++each)
    codes.push_back(QString::fromStdString(each->get_data()));
  return codes;
}

/// The curve of a text: its last lines, "17.0: 28" each.
std::vector<std::pair<double, double>> curveOf(const QString& text)
{
  std::vector<std::pair<double, double>> curve;
  const QStringList lines = text.split('\n');
  for (const QString& line : lines.mid(lines.size() - gui::takeAwayPoints)) {
    const QStringList numbers = line.split(": ");
    EXPECT_EQ(numbers.size(), 2) << line.toStdString();
    curve.emplace_back(numbers.value(0).toDouble(), numbers.value(1).toDouble());
  }
  return curve;
}

/// A scripted insertion in virtual time, every tick of it.
analysis::ForceProfile computed(const session::Overrides& overrides)
{
  const auto scenario = session::loadScenario("contour-published", overrides);
  auto device =
      std::make_shared<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si());
  auto insertion = session::Insertion::prepare(scenario->parameters(), std::move(device));
  analysis::ForceProfiler profiler;
  const auto ran = (*insertion)->runToEnd([&](const haptics::TickRecord& record) {
    profiler.add(record);
    return true;
  });
  EXPECT_TRUE(ran);
  return profiler.profile();
}

class BoothResult : public Booth {
protected:
  /// Inserts to the goal with a finger at the slow end of the bar, 0.5 mm/s.
  void insertSlowly()
  {
    click("inviteButton");
    ASSERT_TRUE(waitUntil(KioskStage::turn));
    QTest::mousePress(&pad(), Qt::LeftButton, {}, QPoint(2, pad().height() / 2));
    ASSERT_TRUE(waitUntil(KioskStage::result));
    ASSERT_TRUE(framesPass());
  }
};

TEST_F(BoothResult, IsReadFromTheScreenByAPhoneAsTheEngineHadIt)
{
  const session::Overrides way{{"stop_travel_mm", "9.0"}};
  open(way);
  click("inviteButton");
  ASSERT_TRUE(waitUntil(KioskStage::turn));
  QTest::mousePress(&pad(), Qt::LeftButton, {}, QPoint(pad().width() / 3, pad().height() / 2));
  const double speed_mm_s = inMillimetersPerSecond(pad().speed());
  ASSERT_TRUE(waitUntil(KioskStage::result));
  ASSERT_TRUE(framesPass());
  const std::vector<QString> codes = codesIn(window_->grab().toImage());
  ASSERT_EQ(codes.size(), 1u);
  keepPicture(*window_, "kiosk-result");
  const haptics::Snapshot& now = window_->control().now();
  const QStringList lines = codes[0].split('\n');
  ASSERT_EQ(lines.size(), 6 + gui::takeAwayPoints) << codes[0].toStdString();
  EXPECT_EQ(lines[1], "Array: Nucleus 24 Contour");
  EXPECT_EQ(lines[2], QStringLiteral("Depth: %1 mm").arg(1e3 * now.output.depth, 0, 'f', 1));
  EXPECT_TRUE(lines[3].startsWith(
      QStringLiteral("Peak force: %1 mN (").arg(1e3 * now.peak.force, 0, 'f', 0)))
      << lines[3].toStdString();
  EXPECT_EQ(lines[4], "Rank today: 1 of 1");

  // against the same insertion of a script, all ticks of it; friction of paper has no speed
  session::Overrides script = way;
  script.emplace_back("speed_mm_s", std::to_string(speed_mm_s));
  const analysis::ForceProfile profile = computed(script);
  EXPECT_GT(profile.peak.force, 0.02);  // the outer wall is passed
  const auto curve = curveOf(codes[0]);
  constexpr double rounding_mN = 0.5, hand_mN = 2.0;  // a finger starts and stops
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const auto [depth_mm, force_mN] = curve[i];
    EXPECT_NEAR(depth_mm, 2.0 + 9.0 * double(i + 1) / gui::takeAwayPoints, 0.051);
    const double travel = 1e-3 * (depth_mm - 2.0);
    const auto point = std::min_element(
        profile.curve.begin(), profile.curve.end(), [&](const auto& a, const auto& b) {
          return std::abs(a.travel - travel) < std::abs(b.travel - travel);
        });
    EXPECT_NEAR(force_mN, 1e3 * point->force, rounding_mN + hand_mN) << depth_mm;
  }
}

TEST_F(BoothResult, IsReadByAPhoneInGermanToo)
{
  gui::useLanguage(*QCoreApplication::instance(), "de");
  open({{"stop_travel_mm", "1.0"}});
  insertSlowly();
  keepPicture(*window_, "kiosk-result-de");
  const std::vector<QString> codes = codesIn(window_->grab().toImage());
  const std::vector<std::string> cut = cutTextsOf(*window_);
  const QString taken = window_->takeAway();
  gui::useLanguage(*QCoreApplication::instance(), "en");
  QLocale::setDefault(QLocale::c());
  ASSERT_EQ(codes.size(), 1u);
  EXPECT_EQ(codes[0], taken);
  EXPECT_TRUE(codes[0].contains("3,0: ")) << codes[0].toStdString();  // the depth of the goal
  // letters beyond these are read as others by phones that expect Latin-1
  for (const QChar letter : codes[0]) EXPECT_LT(letter.unicode(), 128) << codes[0].toStdString();
  for (const std::string& text : cut) ADD_FAILURE() << text;
}

TEST_F(BoothResult, SaysGoalWhereTheArrayIsPartlyOutside)
{
  open({{"stop_travel_mm", "1.0"}});
  insertSlowly();
  EXPECT_TRUE(label("kioskTitle").startsWith("Goal reached")) << label("kioskTitle").toStdString();
}

TEST_F(BoothResult, AnotherLanguageIsShownAtOnceAndTheInsertionGoesOn)
{
  open({{"stop_travel_mm", "6.0"}});
  QObject::connect(
      window_.get(), &gui::KioskWindow::languageRequested, window_.get(),
      [](const QString& word) { gui::useLanguage(*QCoreApplication::instance(), word); });
  // in the demonstration, too, it begins nothing
  click("languageButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return label("kioskTitle").contains("Implantat"); }));
  EXPECT_EQ(window_->stage(), KioskStage::attract);
  click("languageButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return label("kioskTitle").contains("implant"); }));

  click("inviteButton");
  pressPad();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return travel_mm() > 1.0; }));
  releasePad();
  const double before_mm = travel_mm();
  click("languageButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return label("kioskTitle") == "Sie sind dran"; }));
  EXPECT_EQ(window_->stage(), KioskStage::turn);
  EXPECT_GE(travel_mm(), before_mm - 0.01);
  EXPECT_EQ(window_->findChild<QAbstractButton*>("languageButton")->text(), "English");
  pressPad();
  ASSERT_TRUE(waitUntil(KioskStage::result));
  EXPECT_TRUE(window_->takeAway().contains("Maximalkraft"));
  // the next visitor finds the operator's language
  click("doneButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return label("kioskTitle").contains("implant"); }));
  gui::useLanguage(*QCoreApplication::instance(), "en");
  QLocale::setDefault(QLocale::c());
}

TEST_F(BoothResult, CountsAVisitorOnceAndOnlyIfTheArrayWasMoved)
{
  open({{"stop_travel_mm", "1.0"}});
  click("inviteButton");  // looks, and goes away
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  ASSERT_TRUE(waitUntil(KioskStage::attract));
  insertSlowly();
  click("againButton");
  ASSERT_TRUE(waitUntil(KioskStage::turn));
  releasePad();
  pressPad();
  ASSERT_TRUE(waitUntil(KioskStage::result));
  gui::Leaderboard kept(boardFile());
  EXPECT_EQ(kept.statisticsOf(aDay).visitors, 1);
  EXPECT_EQ(kept.statisticsOf(aDay).insertions, 2);
}

TEST_F(BoothResult, InsertsSeveralArraysInTurnAndTheVisitorsOwnAfterwards)
{
  open({{"stop_travel_mm", "0.5"}}, "booth");
  std::set<std::string> arrays;
  const auto isNew = [&] {
    return arrays.insert(window_->control().scenario().array().name).second;
  };
  isNew();
  for (int round = 0; round < 3; ++round) {
    ASSERT_TRUE(WindowRig::waitUntil([&] { return window_->control().isAtDepth(); }));
    ASSERT_TRUE(framesPass());
    seconds_ += 5.0;
    ASSERT_TRUE(WindowRig::waitUntil(isNew)) << round;
    ASSERT_TRUE(framesPass());
    const QString name = QString::fromStdString(window_->control().scenario().array().name);
    EXPECT_TRUE(label("kioskTitle").contains(name.section(" (", 0, 0))) << name.toStdString();
  }
  EXPECT_EQ(arrays.size(), 4u);
  click("inviteButton");
  EXPECT_EQ(window_->control().scenario().array().name, "FLEX24");
}

TEST_F(BoothResult, EveryTextForVisitorsIsSeenUnderSixteenMinutesOfArc)
{
  open();
  // NUREG-0700, 1.3.1-4: height = 6.283 D (MA) / 21600; the tests' screen has 96 pixels per inch
  const double capital_mm = 6.283 * 1500.0 * 16.0 / 21600.0;
  const double pitch_mm = gui::pixelPitch_mm(window_->screen());
  // the window of the tests has 1280 pixels: room for letters of a 36th of it
  const double room_px = 1280.0 / 36.0 - 1.0;
  const auto seen = [&](const QWidget* text) { return QFontMetricsF(text->font()).capHeight(); };
  const double least_px = std::min(capital_mm / pitch_mm, 0.72 * room_px);
  for (const char* name : {"kioskTitle", "kioskSentence"})
    EXPECT_GE(seen(window_->findChild<QLabel*>(name)), least_px) << name;
  for (const QPushButton* button : window_->findChildren<QPushButton*>())
    EXPECT_GE(seen(button), least_px) << button->objectName().toStdString();
  for (const QLabel* text : window_->findChild<QWidget*>("dayView")->findChildren<QLabel*>())
    EXPECT_GE(seen(text), least_px) << text->text().toStdString();
  keepPicture(*window_, "booth");
}

TEST(PhaseLine, NamesTheGoalOfAPartialInsertionForVisitors)
{
  gui::PhaseLine line(nullptr);
  line.setForVisitors(30);
  line.setPartial(true);
  line.setPhase(analysis::Phase::full);
  EXPECT_EQ(line.accessibleName(), "Goal");
  line.setPartial(false);
  EXPECT_EQ(line.accessibleName(), "Full depth");
}

TEST(Legibility, GivesTypeWhoseCapitalsAreSeenUnderTheAngle)
{
  EXPECT_NEAR(gui::heightSeen_mm(20.0, 1500.0), 8.727, 1e-3);  // 1500 tan(20')
  for (const double pitch_mm : {0.1, 0.25, 0.63}) {
    QFont font = gui::typeface(gui::letterSize_px(16.0, pitch_mm));
    const double capital_mm = QFontMetricsF(font).capHeight() * pitch_mm;
    EXPECT_GE(capital_mm, 0.97 * 6.981) << pitch_mm;  // 1500 tan(16'), in whole pixels
    EXPECT_LE(capital_mm, 6.981 + 2.0 * pitch_mm) << pitch_mm;
  }
}

TEST(ForceLevel, ComparesWithThePeaksMeasuredInPatients)
{
  const auto peaks = analysis::peaksInPatients();
  ASSERT_TRUE(peaks);
  // peaks of 44.8 to 102.4 mN: Rau et al. 2024
  EXPECT_EQ(gui::levelOf(0.0447, *peaks), gui::ForceLevel::gentle);
  EXPECT_EQ(gui::levelOf(0.0449, *peaks), gui::ForceLevel::firm);
  EXPECT_EQ(gui::levelOf(0.1023, *peaks), gui::ForceLevel::firm);
  EXPECT_EQ(gui::levelOf(0.1025, *peaks), gui::ForceLevel::tooMuch);
}

TEST(ForceLevel, IsToldWithoutColors)
{
  std::set<QString> signs, words;
  for (const auto level :
       {gui::ForceLevel::gentle, gui::ForceLevel::firm, gui::ForceLevel::tooMuch}) {
    signs.insert(gui::signOf(level));
    words.insert(gui::wordOf(level));
  }
  EXPECT_EQ(signs.size(), 3u);
  EXPECT_EQ(words.size(), 3u);
}

TEST(TakeAway, TakesTheCurveAtEquallySpacedDepths)
{
  std::vector<analysis::CurvePoint> line;  // 10 mN per millimeter
  for (int i = 0; i <= 150; ++i) line.push_back({1e-4 * i, 1e-3 * i});
  const auto points = gui::takeAwayCurve(line, millimeters(2));
  ASSERT_EQ(points.size(), std::size_t(gui::takeAwayPoints));
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(inMillimeters(points[i].first), 2.0 + 0.75 * double(i + 1), 1e-9);
    EXPECT_NEAR(inMillinewtons(points[i].second), 7.5 * double(i + 1), 1e-9);
  }
}

TEST(QrCode, IsReadAgain)
{
  for (const QString& text :
       {QStringLiteral("1"), QStringLiteral("a\nb: 17,0"), QString(1500, 'x')}) {
    const QImage code = gui::qrCode(text);
    ASSERT_FALSE(code.isNull());
    const auto read = codesIn(code.scaled(4 * code.size()));
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0], text);
  }
  EXPECT_TRUE(gui::qrCode({}).isNull());
  EXPECT_TRUE(gui::qrCode(QString(3000, 'x')).isNull());  // a QR code holds 2,953 bytes
}

}  // namespace
}  // namespace perilymph::test
