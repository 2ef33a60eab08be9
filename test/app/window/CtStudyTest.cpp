// SPDX-License-Identifier: BSD-3-Clause

// A fit, its landmarks and its undo are one value: what goes onward from the page CT is the fit of the
// landmarks that are shown, whatever was dragged, undone, measured or canceled before.

#include <gmock/gmock.h>

#include <QLabel>
#include <QTest>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <random>

#include "KeptPicture.h"
#include "TheCtPage.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/session/PatientRecord.h"

namespace perilymph::test {
namespace {

/// A length that no two sets of landmarks share: what the measurement in these tests gives for A.
double aOf_mm(const ct::Marks& byHand)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < ct::markCount; ++k)
    if (const auto& point = byHand.points_P[k])
      sum += double(k + 1) * (0.37 * point->x() + 0.53 * point->y() + 0.71 * point->z() + 1.0);
  return 9.0 + 0.4 * std::sin(sum);
}

/// A page CT whose measurement takes no time and gives A of the landmarks.
class KnownFits {
public:
  /// @param page  Shows measures.
  KnownFits(WindowRig& rig, gui::CtPage& page)
      : rig_(rig), page_(page), fitted_(*page.study().measures())
  {
    page_.setMeasurement([this](const ct::CtVolume&,
                                const ct::MeasureRequest& request) -> Result<ct::CochleaMeasures> {
      std::unique_lock lock(mutex_);
      released_.wait(lock, request.stop, [this] { return !isHeld_; });
      if (request.stop.stop_requested()) return Error{"Canceled."};
      ct::CochleaMeasures measures = fitted_;
      measures.marksByHand = request.marks;
      measures.a.value = aOf_mm(request.marks);
      return measures;
    });
    // also without landmarks A follows from them
    page_.study().moveCrosshair(onDisk().phantom.inside_P);
    remeasure();
    rig_.type("ctPatientCode", "CT-7");
  }
  ~KnownFits() { page_.cancel(); }
  KnownFits(const KnownFits&) = delete;
  KnownFits& operator=(const KnownFits&) = delete;

  void move(ct::Mark mark, const Eigen::Vector3d& by_mm)
  {
    page_.study().beginChange();
    page_.study().placeMark(mark, *page_.study().marks()[mark] + by_mm);
  }
  void remeasure()
  {
    rig_.click("measureHereButton");
    ASSERT_TRUE(WindowRig::waitUntil([this] { return !page_.isBusy(); }));
  }
  bool isShown(const char* label) { return page_.findChild<QLabel*>(label)->isVisible(); }
  /// Goes onward to a plan, and again if the page stays to show a contradiction; then returns.
  void plan()
  {
    for (int k = 0; k < 2 && rig_.window().page() == "ct"; ++k) {
      rig_.click("planCtButton");
      ASSERT_TRUE(WindowRig::waitUntil([this] { return !page_.isBusy(); }));
      if (page_.findChild<QWidget*>("versionQuestion")->isVisible()) rig_.click("newVersionButton");
    }
    ASSERT_EQ(rig_.window().page(), "plan");
    rig_.click("ctPageButton");
  }
  /// The file of the patient says what is shown, and which landmarks steered it.
  void expectSavedIsShown()
  {
    ASSERT_FALSE(page_.study().isStale());
    const std::filesystem::path file =
        patientFolder() /
        (fitted_.side == anatomy::Side::left ? "CT-7-left.toml" : "CT-7-right.toml");
    const auto saved = anatomy::loadPatient(file);
    ASSERT_TRUE(saved) << saved.error().message;
    const ct::Marks byHand = page_.study().marksByHand();
    EXPECT_NEAR(inMillimeters(saved->basalTurn->a), aOf_mm(byHand), 6e-4);
    std::string names;
    for (std::size_t k = 0; k < ct::markCount; ++k)
      if (byHand.points_P[k])
        names += (names.empty() ? "" : ", ") + std::string(nameOf(static_cast<ct::Mark>(k)));
    EXPECT_EQ(saved->origin.landmarksByHand, names);
    const auto record = session::loadPatientRecord(file);
    ASSERT_TRUE(record) << record.error().message;
    ct::Marks recorded;
    for (const auto& landmark : record->versions.back().landmarks)
      if (landmark.isByHand)
        recorded[*ct::markNamed(landmark.name)] = Eigen::Vector3d(landmark.lps_mm.data());
    EXPECT_TRUE(recorded == byHand);
  }
  /// A fit that is not marked as stale is that of the landmarks that are shown.
  void expectShownIsOne()
  {
    ASSERT_TRUE(page_.study().measures());
    EXPECT_EQ(page_.study().isStale(), std::fabs(page_.study().measures()->a.value -
                                                 aOf_mm(page_.study().marksByHand())) > 1e-12);
    EXPECT_EQ(isShown("ctStale"), page_.study().isStale());
    EXPECT_EQ(page_.findChild<QLabel*>("fittedA")->isEnabled(), !page_.study().isStale());
  }

  void hold(bool isHeld)
  {
    const std::scoped_lock lock(mutex_);
    isHeld_ = isHeld;
    released_.notify_all();
  }

private:
  WindowRig& rig_;
  gui::CtPage& page_;
  ct::CochleaMeasures fitted_;
  std::mutex mutex_;
  std::condition_variable_any released_;
  bool isHeld_ = false;
};

TEST_F(TheCtPage, MarksTheStepToTakeNext)
{
  const auto next = [this] {
    QString marked;
    for (const QLabel* label : page().findChildren<QLabel*>())
      if (!label->styleSheet().isEmpty() && label->text().at(0).isDigit()) marked += label->text();
    return marked.toStdString();
  };
  EXPECT_EQ(next(), "2  CHECK");  // a CT without measures yet
  measure();
  EXPECT_EQ(next(), "2  CHECK");
  rig_.type("ctPatientCode", "CT-9");
  EXPECT_EQ(next(), "3  USE");
  KnownFits fits(rig_, page());
  fits.move(ct::Mark::roundWindow, {0.05, 0.0, 0.0});
  EXPECT_EQ(next(), "2  CHECK");
}

TEST_F(TheCtPage, MeasuresLandmarksThatMovedBeforeAPlan)
{
  measure();
  KnownFits fits(rig_, page());
  EXPECT_EQ(rig_.label("fittedHeading"), "used: fitted (95 % CI)");
  EXPECT_FALSE(fits.isShown("ctStale"));
  fits.move(ct::Mark::roundWindow, {0.05, 0.0, 0.0});
  EXPECT_TRUE(fits.isShown("ctStale"));
  EXPECT_EQ(rig_.label("ctStale"), "Landmarks moved: measure again.");
  EXPECT_EQ(rig_.label("fittedHeading"), "fitted before (95 % CI)");
  EXPECT_FALSE(page().findChild<QLabel*>("fittedA")->isEnabled());
  fits.plan();
  fits.expectSavedIsShown();
}

TEST_F(TheCtPage, MeasuresLandmarksThatMovedBeforeAnInsertion)
{
  measure();
  KnownFits fits(rig_, page());
  fits.move(ct::Mark::roundWindow, {0.05, 0.0, 0.0});
  for (int k = 0; k < 2 && rig_.window().page() == "ct"; ++k) {
    rig_.click("insertCtButton");
    ASSERT_TRUE(WindowRig::waitUntil([this] { return !page().isBusy(); }));
  }
  EXPECT_EQ(rig_.window().page(), "insert");
  fits.expectSavedIsShown();
}

TEST_F(TheCtPage, BringsTheFitBackByUndoWithItsLandmarks)
{
  measure();
  KnownFits fits(rig_, page());
  const double before = study().measures()->a.value;
  fits.move(ct::Mark::roundWindow, {0.3, 0.1, 0.0});
  fits.remeasure();
  const double after = study().measures()->a.value;
  ASSERT_NE(before, after);
  rig_.click("undoMarkButton");  // of the measurement
  EXPECT_EQ(study().measures()->a.value, before);
  EXPECT_TRUE(study().isStale());
  rig_.click("undoMarkButton");  // of the landmark
  EXPECT_FALSE(study().isStale());
  EXPECT_FALSE(study().isCorrected());
  fits.plan();
  fits.expectSavedIsShown();
  rig_.click("redoMarkButton");
  rig_.click("redoMarkButton");
  EXPECT_EQ(study().measures()->a.value, after);
  EXPECT_FALSE(study().isStale());
}

TEST_F(TheCtPage, StaysWhereLandmarksContradictTheFit)
{
  measure();
  KnownFits fits(rig_, page());
  // far beyond an interval of some tenths
  const Eigen::Vector3d out =
      2.5 * (*study().marks()[ct::Mark::farWall] - study().measures()->center_P).normalized();
  fits.move(ct::Mark::farWall, out);
  rig_.click("planCtButton");
  ASSERT_TRUE(WindowRig::waitUntil([this] { return !page().isBusy(); }));
  EXPECT_EQ(rig_.window().page(), "ct");
  EXPECT_THAT(rig_.label("ctFlags").toStdString(),
              testing::HasSubstr("A between the landmarks is"));
  rig_.click("planCtButton");  // read and accepted
  EXPECT_EQ(rig_.window().page(), "plan");
  fits.expectSavedIsShown();
}

TEST_F(TheCtPage, KeepsLandmarksThatMoveWhileItMeasures)
{
  measure();
  KnownFits fits(rig_, page());
  fits.move(ct::Mark::roundWindow, {0.05, 0.0, 0.0});
  fits.hold(true);
  rig_.click("planCtButton");
  fits.move(ct::Mark::apex, {0.0, 0.05, 0.0});
  const auto apex = study().marks()[ct::Mark::apex];
  fits.hold(false);
  ASSERT_TRUE(WindowRig::waitUntil([this] { return !page().isBusy(); }));
  EXPECT_EQ(study().marks()[ct::Mark::apex], apex);
  EXPECT_EQ(rig_.window().page(), "ct");  // not of these landmarks
  fits.expectShownIsOne();
  EXPECT_TRUE(study().isStale());
}

TEST_F(TheCtPage, ShowsMeasuresLandmarksAndUndoWithoutScrollingAt1366x768)
{
  rig_.window().resize(1366, 768);
  measure();
  QCoreApplication::processEvents();
  for (const char* name : {"fittedA", "fittedCdl", "markedH", "markRW", "markOW", "markB2", "markC",
                           "undoMarkButton", "redoMarkButton", "insertCtButton", "planCtButton"}) {
    const auto* each = page().findChild<QWidget*>(name);
    EXPECT_EQ(each->visibleRegion().boundingRect(), each->rect()) << name;
  }
  rig_.type("ctPatientCode", "CT-9");
  keepPicture(rig_.window(), "ct-three-steps");
}

TEST_F(TheCtPage, AsksBeforeOtherMeasuresAreSavedUnderACodeAndComparesBoth)
{
  measure();
  ct::CochleaMeasures first = *study().measures();
  first.a = {8.87, 0.1, 0.06, 0.03};
  first.b = {6.20, 0.1, 0.05, 0.02};
  first.h = {4.00, 0.1, 0.05, 0.02};
  study().setMeasures(first);
  rig_.type("ctPatientCode", "P-301");
  rig_.click("planCtButton");
  ASSERT_EQ(rig_.window().page(), "plan");  // a new code: nothing to ask
  rig_.click("ctPageButton");
  rig_.click("planCtButton");
  ASSERT_EQ(rig_.window().page(), "plan");  // the same measures
  rig_.click("ctPageButton");

  ct::CochleaMeasures second = first;
  second.a.value = 8.70;
  second.h.value = 4.60;
  study().setMeasures(second);
  rig_.click("planCtButton");
  ASSERT_EQ(rig_.window().page(), "ct");
  const auto* question = page().findChild<QWidget*>("versionQuestion");
  ASSERT_TRUE(question->isVisible());
  const bool isLeft = first.side == anatomy::Side::left;
  const auto file = patientFolder() / (isLeft ? "P-301-left.toml" : "P-301-right.toml");
  const auto before = session::loadPatientRecord(file);
  ASSERT_TRUE(before) << before.error().message;
  EXPECT_EQ(rig_.label("versionTitle"),
            QStringLiteral("P-301 %1 exists, saved %2.")
                .arg(isLeft ? "left" : "right",
                     QString::fromStdString(before->versions.back().savedUtc).left(10)));
  // sqrt(0.1^2 + 0.06^2 + 0.03^2) 1.96 = 0.236, and sqrt(2) of it
  EXPECT_EQ(rig_.label("savedA"), "8.87 ± 0.24");
  EXPECT_EQ(rig_.label("newA"), "8.70 ± 0.24");
  EXPECT_EQ(rig_.label("differenceA"), "-0.17 ± 0.33");
  EXPECT_EQ(page().findChild<QLabel*>("differenceA")->toolTip(),
            "Within the 95 % interval of the difference");
  EXPECT_EQ(rig_.label("differenceH"), "+0.60 ± 0.31");
  EXPECT_EQ(page().findChild<QLabel*>("differenceH")->toolTip(),
            "Beyond the 95 % interval of the difference");
  // 1.71 (1.18 (A - 1) + 2.69 (B - 1) - sqrt(0.72 (A - 1) (B - 1))) + 0.18, computed apart
  EXPECT_EQ(rig_.label("savedCdl").section(' ', 0, 0), "30.7");
  EXPECT_EQ(rig_.label("newCdl").section(' ', 0, 0), "30.5");
  // with what A alone gives, 32.9 and 32.2 mm; the difference has the errors of A and B only
  EXPECT_EQ(rig_.label("savedCdl"), "30.7 ± 2.4");
  EXPECT_EQ(rig_.label("newCdl"), "30.5 ± 2.0");
  EXPECT_EQ(rig_.label("differenceCdl"), "-0.2 ± 1.3");

  rig_.click("otherCodeButton");
  EXPECT_FALSE(question->isVisible());
  EXPECT_EQ(session::loadPatientRecord(file)->versions, before->versions);
  rig_.click("planCtButton");
  rig_.click("newVersionButton");
  EXPECT_EQ(rig_.window().page(), "plan");
  const auto after = session::loadPatientRecord(file);
  ASSERT_EQ(before->versions.size(), 2U);  // the automatic fit, and what replaced it
  ASSERT_EQ(after->versions.size(), 3U);
  EXPECT_EQ(after->versions[0], before->versions[0]);
  EXPECT_EQ(after->versions[1], before->versions[1]);
  EXPECT_NEAR(inMillimeters(anatomy::loadPatient(file)->basalTurn->a), 8.70, 1e-9);
}

TEST_F(TheCtPage, SavesTheFitOfTheLandmarksAfterAnySequence)
{
  measure();
  KnownFits fits(rig_, page());
  std::mt19937 random(20261127);
  const auto upTo = [&random](int end) { return int(random() % unsigned(end)); };
  for (int step = 0; step < 60; ++step) {
    const int what = upTo(9);
    SCOPED_TRACE(testing::Message() << "step " << step << " is " << what);
    if (what < 3) {
      fits.move(static_cast<ct::Mark>(upTo(ct::markCount)),
                0.01 * Eigen::Vector3d(upTo(21) - 10, upTo(21) - 10, upTo(21) - 10));
    } else if (what == 3) {
      study().undo();
    } else if (what == 4) {
      study().redo();
    } else if (what == 5) {
      if (rig_.button("measureHereButton").isEnabled()) fits.remeasure();
    } else if (what == 6) {  // canceled, or overtaken by a change
      fits.hold(true);
      if (rig_.button("measureHereButton").isEnabled()) rig_.click("measureHereButton");
      if (upTo(2) == 0) study().undo();
      if (upTo(2) == 0) fits.move(ct::Mark::apex, {0.01, 0.0, 0.01});
      if (upTo(2) == 0) page().cancel();
      fits.hold(false);
      ASSERT_TRUE(WindowRig::waitUntil([this] { return !page().isBusy(); }));
    } else if (what == 7) {
      study().beginChange();  // pressed, not dragged
    } else if (study().measures()) {
      fits.plan();
      fits.expectSavedIsShown();
    }
    if (HasFatalFailure()) return;
    if (study().measures())
      fits.expectShownIsOne();
    else
      study().redo();
  }
}

}  // namespace
}  // namespace perilymph::test
