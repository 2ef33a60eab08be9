// SPDX-License-Identifier: BSD-3-Clause

// The bone of a CT and the surgeon's landmarks in the pictures of CT and Insert.

#include <QApplication>
#include <QImage>
#include <QTest>
#include <set>

#include "KeptPicture.h"
#include "TheCtPage.h"
#include "gui/pages/ct/CtBone.h"
#include "gui/pages/ct/SurfaceView.h"
#include "gui/program/Languages.h"
#include "gui/scene/OperationView.h"
#include "gui/scene/SceneLabels.h"

namespace perilymph::test {
namespace {

bool hasLabel(const gui::SceneLabels& labels, const QString& text)
{
  return std::ranges::any_of(labels.labels(),
                             [&text](const gui::PlacedLabel& label) { return label.text == text; });
}

void expectApart(const gui::SceneLabels& labels)
{
  for (const gui::PlacedLabel& one : labels.labels()) {
    if (one.place.isNull()) continue;
    EXPECT_TRUE(QRectF(labels.rect()).contains(one.place)) << one.text.toStdString();
    for (const gui::PlacedLabel& other : labels.labels())
      EXPECT_FALSE(&one != &other && one.place.intersects(other.place))
          << one.text.toStdString() << " and " << other.text.toStdString();
  }
}

class TheBone : public TheCtPage {
protected:
  gui::SurfaceView& surface() { return *page().findChild<gui::SurfaceView*>("surfaceView"); }

  /// Until the bone of what is shown is computed.
  void waitForBone()
  {
    ASSERT_TRUE(WindowRig::waitUntil([this] { return !page().bone().isBusy(); }));
    ASSERT_NE(page().bone().model(), nullptr);
  }

  /// The fraction of the picture that is not ground.
  double drawnPart()
  {
    const QImage picture = surface().picture();
    const QRgb ground = picture.pixel(2, picture.height() - 3);
    int count = 0, drawn = 0;
    for (int y = 0; y < picture.height(); y += 2)
      for (int x = 0; x < picture.width(); x += 2, ++count) {
        const QRgb pixel = picture.pixel(x, y);
        const int apart = std::abs(qRed(pixel) - qRed(ground)) +
                          std::abs(qGreen(pixel) - qGreen(ground)) +
                          std::abs(qBlue(pixel) - qBlue(ground));
        drawn += apart > 40 ? 1 : 0;
      }
    return double(drawn) / count;
  }
};

TEST_F(TheBone, IsShownBeforeTheCochleaIsMeasured)
{
  waitForBone();
  EXPECT_EQ(study().measures(), nullptr);
  EXPECT_GT(drawnPart(), 0.15);
  EXPECT_EQ(page().bone().inAnatomy(), nullptr);  // no cochlea to place it by
  EXPECT_FALSE(hasLabel(surface().labels(), "Round window"));
  keepPicture(rig_.window(), "bone-before-measuring");
}

TEST_F(TheBone, IsCutAtTheMeasuredCochleaWithItsLandmarks)
{
  measure();
  waitForBone();
  const auto& bone = *page().bone().model();
  const ct::CochleaMeasures& measures = *study().measures();
  EXPECT_LT((1e3 * bone.center - measures.center_P).norm(), 4.0);
  EXPECT_NEAR(bone.cut.removed.dot(measures.axis_P), 1.0, 1e-9);
  // the wall that was fitted lies on the bone: half a voxel of the phantom and the fit's own error
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < measures.wall_P.size(); k += 37, ++count) {
    double nearest = 1e9;
    for (const auto& point : bone.fine.points)
      nearest = std::min(
          nearest,
          (1e3 * Eigen::Vector3d(point[0], point[1], point[2]) - measures.wall_P[k]).norm());
    sum += nearest;
  }
  EXPECT_LT(sum / count, 0.35);
  // the same bone in the frame of the anatomy
  const auto& inAnatomy = *page().bone().inAnatomy();
  ASSERT_EQ(inAnatomy.fine.points.size(), bone.fine.points.size());
  const auto &first = inAnatomy.fine.points.front(), &same = bone.fine.points.front();
  EXPECT_NEAR((measures.fromAnatomy(Eigen::Vector3d(first[0], first[1], first[2])) -
               1e3 * Eigen::Vector3d(same[0], same[1], same[2]))
                  .norm(),
              0.0, 1e-9);
  const gui::SceneLabels& labels = surface().labels();
  for (const char* name : {"Round window", "Axis of the basal turn", "Line of approach", "apex"})
    EXPECT_TRUE(hasLabel(labels, name)) << name;
  expectApart(labels);
  keepPicture(rig_.window(), "bone-measured");
}

TEST_F(TheBone, IsTurnedAndCutByKeys)
{
  measure();
  waitForBone();
  surface().setFocus();
  visualization::BoneLayer& layer = surface().scene()->bone();
  const auto cut = *layer.cut();
  QTest::keyClick(&surface(), Qt::Key_PageUp);
  QTest::keyClick(&surface(), Qt::Key_PageUp);
  EXPECT_NEAR(1e3 * cut.removed.dot(layer.cut()->origin - cut.origin), 2 * gui::cutOfKey_mm, 1e-9);
  QTest::keyClick(&surface(), Qt::Key_PageDown);
  EXPECT_NEAR(1e3 * cut.removed.dot(layer.cut()->origin - cut.origin), gui::cutOfKey_mm, 1e-9);
  const QPointF before = *surface().labels().handle();
  QTest::keyClick(&surface(), Qt::Key_Right);
  EXPECT_NE(*surface().labels().handle(), before);
  QTest::keyClick(&surface(), Qt::Key_V);  // it faces the viewer: dragged up and down
  EXPECT_GT(std::acos(std::clamp(layer.cut()->removed.dot(cut.removed), -1.0, 1.0)), 0.2);
  EXPECT_NEAR(surface().labels().cutMotion_mm({10.0, 0.0}), 0.0, 1e-9);
  EXPECT_GT(surface().labels().cutMotion_mm({0.0, -10.0}), 0.0);
}

TEST_F(TheBone, IsCoarseOnlyWhileItMoves)
{
  measure();
  waitForBone();
  visualization::BoneLayer& layer = surface().scene()->bone();
  const std::size_t fine = layer.triangles();
  QTest::keyClick(&surface(), Qt::Key_Left);
  EXPECT_LT(layer.triangles(), fine / 2);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return layer.triangles() == fine; }));
}

TEST_F(TheBone, IsCutWhereTheHandleIsDraggedTo)
{
  measure();
  waitForBone();
  visualization::BoneLayer& layer = surface().scene()->bone();
  const auto cut = *layer.cut();
  const QPointF handle = *surface().labels().handle();
  ASSERT_TRUE(surface().labels().isHandleAt(handle));
  const QPointF by(3.0, -8.0);
  const double expected_mm = surface().labels().cutMotion_mm(by);
  QMouseEvent press(QEvent::MouseButtonPress, handle, Qt::LeftButton, Qt::LeftButton,
                    Qt::NoModifier);
  QCoreApplication::sendEvent(&surface(), &press);
  QMouseEvent move(QEvent::MouseMove, handle + by, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&surface(), &move);
  QMouseEvent release(QEvent::MouseButtonRelease, handle + by, Qt::LeftButton, Qt::NoButton,
                      Qt::NoModifier);
  QCoreApplication::sendEvent(&surface(), &release);
  EXPECT_NEAR(1e3 * cut.removed.dot(layer.cut()->origin - cut.origin), expected_mm, 1e-6);
  EXPECT_NE(expected_mm, 0.0);
}

TEST_F(TheBone, GoesToTheInsertionOfItsPatientAndLeavesWithItsCt)
{
  measure();
  waitForBone();
  rig_.type("ctPatientCode", "CT-203");
  rig_.click("insertCtButton");
  ASSERT_TRUE(WindowRig::waitUntil([this] {
    return rig_.window().control().scenario().patient().label == "CT-203" &&
           rig_.window().page() == "insert";
  }));
  auto* view = rig_.window().findChild<gui::OperationView*>("operationView");
  EXPECT_FALSE(view->scene()->bone().isVisible());  // until it is asked for
  rig_.pressKey(Qt::Key_C);
  ASSERT_TRUE(WindowRig::waitUntil([view] { return hasLabel(view->labels(), "Round window"); }));
  EXPECT_EQ(view->scene()->bone().bone(), page().bone().inAnatomy());
  EXPECT_EQ(view->labels().note(), "Bone of the patient’s CT");
  EXPECT_TRUE(hasLabel(view->labels(), "1"));  // the contact at the tip
  expectApart(view->labels());
  const auto cut = *view->scene()->bone().cut();
  rig_.pressKey(Qt::Key_PageDown);
  EXPECT_LT(cut.removed.dot(view->scene()->bone().cut()->origin - cut.origin), 0.0);
  keepPicture(rig_.window(), "bone-insert");

  rig_.click("ctPageButton");
  open(otherOnDisk());
  rig_.click("insertPageButton");
  EXPECT_EQ(view->scene()->bone().bone(), nullptr);
  ASSERT_TRUE(
      WindowRig::waitUntil([view] { return view->labels().note().startsWith("Schematic"); }));
  EXPECT_TRUE(view->labels().note().contains("once the CT of this patient is open"));
  EXPECT_TRUE(hasLabel(view->labels(), "Line of approach"));
  keepPicture(rig_.window(), "bone-insert-schematic");
}

TEST(Landmarks, AreASchematicWithoutACt)
{
  WindowRig rig;
  auto* view = rig.window().findChild<gui::OperationView*>("operationView");
  rig.pressKey(Qt::Key_C);
  ASSERT_TRUE(WindowRig::waitUntil([view] { return hasLabel(view->labels(), "Round window"); }));
  EXPECT_TRUE(view->labels().note().startsWith("Schematic: landmarks of this model"));
  expectApart(view->labels());
  rig.pressKey(Qt::Key_C);
  EXPECT_TRUE(WindowRig::waitUntil([view] { return !view->labels().isVisible(); }));
  EXPECT_TRUE(view->labels().labels().empty());
}

TEST(Landmarks, HaveGermanNames)
{
  gui::useLanguage(*QCoreApplication::instance(), "de");
  {
    WindowRig rig;
    auto* view = rig.window().findChild<gui::OperationView*>("operationView");
    rig.pressKey(Qt::Key_C);
    EXPECT_TRUE(
        WindowRig::waitUntil([view] { return hasLabel(view->labels(), "Rundes Fenster"); }));
    EXPECT_TRUE(hasLabel(view->labels(), "Achse der Basalwindung"));
    EXPECT_TRUE(view->labels().note().startsWith("Schema"));
  }
  gui::useLanguage(*QCoreApplication::instance(), "en");
  QLocale::setDefault(QLocale::c());
}

}  // namespace
}  // namespace perilymph::test
