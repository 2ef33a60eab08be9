// SPDX-License-Identifier: BSD-3-Clause

// The line of approach: turned on the page CT, and the same on the pages CT, Insert and Plan.

#include <QApplication>
#include <QLabel>
#include <QTest>
#include <cmath>

#include "CutTexts.h"
#include "KeptPicture.h"
#include "TheCtPage.h"
#include "gui/pages/ct/CtBone.h"
#include "gui/pages/ct/SurfaceView.h"
#include "gui/pages/plan/PlanPage.h"
#include "gui/run/ScenarioApproach.h"
#include "gui/scene/SceneLabels.h"
#include "gui/text/ApproachText.h"

namespace perilymph::test {
namespace {

class TheApproach : public TheCtPage {
protected:
  gui::SurfaceView& surface() { return *page().findChild<gui::SurfaceView*>("surfaceView"); }

  void measureWithBone()
  {
    measure();
    ASSERT_TRUE(WindowRig::waitUntil([this] { return !page().bone().isBusy(); }));
    ASSERT_TRUE(surface().labels().approachHandle());
  }
  template <QEvent::Type type>
  void mouse(const QPointF& at, Qt::MouseButton button)
  {
    QMouseEvent event(type, at, button, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&surface(), &event);
  }
  /// Drags the handle of the line, and leaves it held.
  void dragTo(const QPointF& by)
  {
    const QPointF handle = surface().labels().approachHandle()->at;
    mouse<QEvent::MouseButtonPress>(handle, Qt::LeftButton);
    mouse<QEvent::MouseMove>(handle + 0.5 * by, Qt::NoButton);
    mouse<QEvent::MouseMove>(handle + by, Qt::NoButton);
  }
  void release() { mouse<QEvent::MouseButtonRelease>({}, Qt::LeftButton); }
  anatomy::Approach scenarios() { return gui::approachOf(rig_.window().control().scenario()); }
  anatomy::Approach setups() { return gui::approachOf(rig_.window().setup().now().scenario); }
  void insert(const char* code)
  {
    rig_.type("ctPatientCode", code);
    rig_.click("insertCtButton");
    ASSERT_TRUE(WindowRig::waitUntil([this, code] {
      return rig_.window().control().scenario().patient().label == code &&
             rig_.window().page() == "insert";
    }));
  }
};

void expectSame(const anatomy::Approach& one, const anatomy::Approach& other)
{
  EXPECT_NEAR(inDegrees(one.tilt), inDegrees(other.tilt), 1e-6);
  EXPECT_NEAR(inDegrees(one.turn), inDegrees(other.turn), 1e-6);
}

/// Degrees between two directions.
double between_deg(const Eigen::Vector3d& one, const Eigen::Vector3d& other)
{
  return std::atan2(one.cross(other).norm(), one.dot(other)) * 180.0 / pi;
}

TEST_F(TheApproach, IsTurnedToWhereItsHandleIsDragged)
{
  measureWithBone();
  EXPECT_EQ(rig_.label("approachInPlane"), QStringLiteral("0.0°"));
  const Eigen::Vector3d opening = study().approachLine()->opening_P;
  const QPointF handle = surface().labels().approachHandle()->at;
  const QPointF by(-4.0, 14.0);
  dragTo(by);
  // the line points at the mouse
  const QPointF now = surface().labels().approachHandle()->at;
  visualization::BoneLayer& layer = surface().scene()->bone();
  const double ratio = surface().devicePixelRatioF();
  QPointF center;
  for (const auto& anchor : layer.anchors())
    if (anchor.kind == visualization::SceneAnchor::Kind::approach)
      center = QPointF(anchor.at_px.x(), anchor.at_px.y()) / ratio;
  const QLineF seen(center, now), wanted(center, handle + by);
  EXPECT_NEAR(std::remainder(seen.angle() - wanted.angle(), 360.0), 0.0, 2.0);
  EXPECT_LT((study().approachLine()->opening_P - opening).norm(), 1e-9);  // the pivot
  EXPECT_NE(rig_.label("approachInPlane") + rig_.label("approachOutOfPlane"),
            QStringLiteral("0.0°0.0°"));
  release();

  // what is shown agrees with the angles between the line, the axis and the tangent in the patient
  const auto angles = *study().approachAngles();
  const ct::CochleaMeasures& measures = *study().measures();
  const Eigen::Vector3d axis = measures.anatomyAxes_PW.col(2);
  const Eigen::Vector3d tangent = -(measures.anatomyAxes_PW * study().opening()->out_W);
  const Eigen::Vector3d into = -study().approachLine()->outward_P;
  const auto shadow = [&axis](const Eigen::Vector3d& v) -> Eigen::Vector3d {
    return v - v.dot(axis) * axis;
  };
  EXPECT_NEAR(std::fabs(inDegrees(angles.inPlane)), between_deg(shadow(into), shadow(tangent)),
              0.1);
  EXPECT_NEAR(inDegrees(angles.outOfPlane), between_deg(tangent, axis) - between_deg(into, axis),
              0.1);
  EXPECT_EQ(rig_.label("approachInPlane"), gui::inPlaneText(angles));
  keepPicture(rig_.window(), "approach-turned");

  rig_.click("undoMarkButton");
  EXPECT_EQ(rig_.label("approachInPlane"), QStringLiteral("0.0°"));
  rig_.click("redoMarkButton");
  EXPECT_EQ(rig_.label("approachInPlane"), gui::inPlaneText(angles));
  rig_.click("resetApproachButton");
  EXPECT_EQ(rig_.label("approachOutOfPlane"), QStringLiteral("0.0°"));
}

TEST_F(TheApproach, IsTakenBackByEscWhileItIsDragged)
{
  measureWithBone();
  QTest::keyClick(&surface(), Qt::Key_Right, Qt::ShiftModifier);
  const anatomy::Approach before = *study().approach();
  dragTo({3.0, 20.0});
  EXPECT_GT(std::fabs(inDegrees(study().approach()->turn - before.turn)) +
                std::fabs(inDegrees(study().approach()->tilt - before.tilt)),
            1.0);
  QTest::keyClick(&surface(), Qt::Key_Escape);
  expectSame(*study().approach(), before);
  mouse<QEvent::MouseMove>({5.0, 5.0}, Qt::NoButton);  // it is no longer held
  expectSame(*study().approach(), before);
}

TEST_F(TheApproach, IsTurnedByKeysUpToWhatTheSimulationAllows)
{
  measureWithBone();
  surface().setFocus();
  for (int k = 0; k < 3; ++k) QTest::keyClick(&surface(), Qt::Key_Right, Qt::ShiftModifier);
  QTest::keyClick(&surface(), Qt::Key_Left, Qt::ShiftModifier | Qt::ControlModifier);
  QTest::keyClick(&surface(), Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_EQ(rig_.label("approachInPlane"), QStringLiteral("2.9° toward the lateral wall"));
  EXPECT_EQ(rig_.label("approachOutOfPlane"), QStringLiteral("1.0° toward the basilar membrane"));
  EXPECT_TRUE(WindowRig::waitUntil([&] { return cutTextsOf(page()).empty(); }));  // of two lines
  EXPECT_FALSE(page().findChild<QLabel*>("approachLimit")->isVisible());
  for (int k = 0; k < 40; ++k) QTest::keyClick(&surface(), Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_TRUE(page().findChild<QLabel*>("approachLimit")->isVisible());
  EXPECT_NEAR(inDegrees(study().approach()->turn), -30.0, 0.1);
  EXPECT_TRUE(surface().labels().note().contains(gui::approachLimitText()));
  QTest::keyClick(&surface(), Qt::Key_Home);
  EXPECT_EQ(rig_.label("approachInPlane"), QStringLiteral("0.0°"));
}

TEST_F(TheApproach, StaysInThePatientWhenTheCochleaIsMeasuredAgain)
{
  measureWithBone();
  study().beginChange();
  study().turnApproach(anatomy::BasalTurnAngles{degrees(6), degrees(-4)});
  study().endChange();
  const Eigen::Vector3d outward = study().approachLine()->outward_P;
  ct::CochleaMeasures other = *study().measures();
  const Eigen::Matrix3d tilted =
      Eigen::AngleAxisd(0.05, other.anatomyAxes_PW.col(0)).toRotationMatrix();
  other.anatomyAxes_PW = tilted * other.anatomyAxes_PW;
  study().setMeasures(other);
  EXPECT_LT(between_deg(study().approachLine()->outward_P, outward), 0.02);
  EXPECT_GT(std::fabs(inDegrees(study().approachAngles()->outOfPlane) + 4.0), 0.5);
}

TEST_F(TheApproach, IsTheSameInTheInsertionAndInThePlan)
{
  measureWithBone();
  study().beginChange();
  study().turnApproach(anatomy::BasalTurnAngles{degrees(5), degrees(3)});
  study().endChange();
  const anatomy::Approach given = *study().approach();
  insert("CT-204");
  expectSame(scenarios(), given);
  EXPECT_EQ(rig_.label("approachNote"),
            "Approach: " + gui::approachText(*study().approachAngles()));
  rig_.pressKey(Qt::Key_C);
  keepPicture(rig_.window(), "approach-insert");

  // turned again on the page CT: a change of the setup, which undo takes back on both pages
  rig_.click("ctPageButton");
  surface().setFocus();
  QTest::keyClick(&surface(), Qt::Key_Right, Qt::ShiftModifier);
  const anatomy::Approach again = *study().approach();
  expectSame(setups(), again);
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return std::fabs((scenarios().turn - again.turn).si()) < 1e-9; }));
  rig_.click("insertPageButton");
  rig_.pressKey(Qt::Key_Z, Qt::ControlModifier);
  expectSame(setups(), given);
  rig_.click("ctPageButton");
  expectSame(*study().approach(), given);
  EXPECT_EQ(rig_.label("approachInPlane"), QStringLiteral("5.0° toward the lateral wall"));

  rig_.click("planCtButton");
  ASSERT_TRUE(WindowRig::waitUntil([this] { return rig_.window().page() == "plan"; }));
  EXPECT_EQ(rig_.label("planApproach"),
            "Approach: " + gui::approachText(*study().approachAngles()));
  keepPicture(rig_.window(), "approach-plan");
}

TEST_F(TheApproach, IsNotTurnedUnderAnInsertionThatRuns)
{
  measureWithBone();
  insert("CT-205");
  rig_.click("startButton");
  ASSERT_TRUE(rig_.runForTicks(200));
  rig_.click("ctPageButton");  // which pauses it
  QTest::keyClick(&surface(), Qt::Key_Right, Qt::ShiftModifier);
  expectSame(*study().approach(), {});
  expectSame(setups(), {});
  EXPECT_TRUE(rig_.label("ctStatus").startsWith("An insertion into this cochlea is in progress"));
}

TEST_F(TheApproach, HasItsDistanceFromAStructureMarkedInTheSlices)
{
  measureWithBone();
  study().setFrame(gui::PlaneFrame::patient);
  rig_.click("structure_facial_nerve");
  EXPECT_TRUE(page().findChild<QLabel*>("structureGuide")->isVisible());
  const Eigen::Vector3d beside = study().approachLine()->at(3.0);
  study().moveCrosshair(beside);
  const QPointF center = view(0).placeOf(beside);
  for (const QPointF& by : {QPointF(30, 10), QPointF(36, 40)})
    QTest::mouseClick(&view(0), Qt::LeftButton, Qt::NoModifier, (center + by).toPoint());
  rig_.click("structure_facial_nerve");  // ends it: clicks move the crosshair again
  EXPECT_FALSE(page().findChild<QLabel*>("structureGuide")->isVisible());
  QTest::mouseClick(&view(0), Qt::LeftButton, Qt::NoModifier, (center - QPointF(30, 0)).toPoint());
  const std::vector<Eigen::Vector3d> course = study().pointsOf(ct::MarkupKind::facialNerve);
  ASSERT_EQ(course.size(), 2u);
  EXPECT_LT((view(0).pointAt((center + QPointF(36, 40)).toPoint()) - course[1]).norm(), 0.3);

  // the least of a fine sampling, in the label as in the study
  const auto least = [&] {
    const ct::ApproachLine line = *study().approachLine();
    double nearest = 1e9;
    for (int i = 0; i <= 500; ++i)
      for (int j = 0; j <= 1500; ++j)
        nearest = std::min(
            nearest, (course[0] + i / 500.0 * (course[1] - course[0]) - line.at(0.02 * j)).norm());
    return nearest;
  };
  const auto shown = [this] {
    return rig_.label("distance_facial_nerve").section(QLatin1Char(' '), 0, 0).toDouble();
  };
  EXPECT_NEAR(shown(), least(), 0.06);
  const double before = shown();
  study().beginChange();
  study().turnApproach(anatomy::BasalTurnAngles{degrees(-20), degrees(10)});
  EXPECT_NEAR(shown(), least(), 0.06);  // while it is turned
  study().endChange();
  EXPECT_GT(std::fabs(shown() - before), 0.3);
  keepPicture(rig_.window(), "approach-structure");

  // a point is dragged, as one step for undo
  const QPointF at = view(0).placeOf(course[1]);
  drag(view(0), at, {0.0, 12.0});
  EXPECT_GT((study().pointsOf(ct::MarkupKind::facialNerve)[1] - course[1]).norm(), 0.1);
  rig_.click("undoMarkButton");
  EXPECT_LT((study().pointsOf(ct::MarkupKind::facialNerve)[1] - course[1]).norm(), 1e-12);
  EXPECT_EQ(rig_.label("distance_chorda_tympani"), QStringLiteral("–"));
}

TEST_F(TheApproach, IsKeptWithTheStructuresInThePatientsRecord)
{
  measureWithBone();
  study().beginChange();
  study().turnApproach(anatomy::BasalTurnAngles{degrees(-7), degrees(2)});
  study().endChange();
  study().beginChange();
  study().addPoint(ct::MarkupKind::chordaTympani, study().approachLine()->at(6.0));
  study().endChange();
  const anatomy::Approach given = *study().approach();
  insert("CT-206");
  rig_.click("ctPageButton");
  open(otherOnDisk());
  EXPECT_TRUE(study().markups().empty());
  open(onDisk().folder / "ct");
  measure();
  ASSERT_EQ(study().pointsOf(ct::MarkupKind::chordaTympani).size(), 1u);
  expectSame(*study().approach(), given);
  EXPECT_EQ(rig_.label("distance_chorda_tympani").left(3), QStringLiteral("0.0"));
}

}  // namespace
}  // namespace perilymph::test
