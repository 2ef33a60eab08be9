// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <QLabel>
#include <QPaintEvent>
#include <QTest>

#include "gui/scene/PlainVtkWidget.h"

namespace perilymph::test {
namespace {

constexpr int patience_ms = 60'000;

/// The picture that VTK has drawn.
QImage drawnBy(vtkRenderWindow& window)
{
  const int* const size = window.GetSize();
  const int width = size[0], height = size[1];
  vtkNew<vtkUnsignedCharArray> pixels;
  window.GetPixelData(0, 0, width - 1, height - 1, 1, pixels);
  const QImage upsideDown(pixels->GetPointer(0), width, height, 3 * width, QImage::Format_RGB888);
  return upsideDown.mirrored().convertToFormat(QImage::Format_ARGB32);
}

/// The difference of two pictures in words; empty for equal ones.
std::string difference(const QImage& shown, const QImage& drawn)
{
  if (shown.size() != drawn.size())
    return QStringLiteral("%1 x %2 pixels for %3 x %4")
        .arg(shown.width())
        .arg(shown.height())
        .arg(drawn.width())
        .arg(drawn.height())
        .toStdString();
  int others = 0;
  for (int y = 0; y < drawn.height(); ++y)
    for (int x = 0; x < drawn.width(); ++x) others += shown.pixel(x, y) != drawn.pixel(x, y);
  return others == 0 ? std::string() : std::to_string(others) + " pixels differ";
}

/// A view over the whole of a green window, with a picture that has another color in every row and
/// is transparent as VTK leaves it.
class AView : public testing::TestWithParam<gui::PictureWay> {
protected:
  AView()
  {
    renderer->GradientBackgroundOn();
    renderer->SetBackground(0.9, 0.1, 0.4);
    renderer->SetBackground2(0.1, 0.6, 0.8);
    right->SetBackground(0.3, 0.2, 0.1);
    right->SetViewport(0.5, 0.0, 1.0, 1.0);
    right->SetBackgroundAlpha(0.0);
    window.setStyleSheet(QStringLiteral("background: #00ff00"));
    window.resize(321, 203);
    view = new gui::PlainVtkWidget(&window, GetParam());
    QObject::connect(view, &gui::PlainVtkWidget::presented, view, [this] { ++presented; });
    view->setGeometry(window.rect());
    view->renderWindow()->AddRenderer(renderer);
    view->renderWindow()->AddRenderer(right);
    window.show();
  }

  /// The view as the user sees it once it has painted.
  QImage shown()
  {
    const int before = presented;
    view->renderWindow()->Render();
    return seenAfter(before);
  }

  /// The view after it was presented once more.
  QImage seenAfter(int before)
  {
    EXPECT_TRUE(QTest::qWaitFor([&] { return presented > before; }, patience_ms));
    return view->grab().toImage().convertToFormat(QImage::Format_ARGB32);
  }

  /// The difference of the view from the picture that VTK draws in it.
  std::string differenceNow()
  {
    const QImage seen = shown();
    return difference(seen, drawnBy(*view->renderWindow()));
  }

  vtkNew<vtkRenderer> renderer, right;
  QWidget window;
  gui::PlainVtkWidget* view = nullptr;
  int presented = 0;
};

TEST_P(AView, ShowsEveryPixelOfThePictureAndNothingOfWhatIsBehind)
{
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  EXPECT_EQ(differenceNow(), "");
  renderer->SetBackground(0.2, 0.7, 0.4);
  right->SetBackground(0.8, 0.2, 0.1);
  EXPECT_EQ(differenceNow(), "");
}

TEST_P(AView, ShowsThePictureInItsNewSize)
{
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  for (const QSize size : {QSize(400, 150), QSize(123, 77), QSize(321, 203)}) {
    window.resize(size);
    view->resize(size);
    EXPECT_EQ(differenceNow(), "") << size.width();
    EXPECT_EQ(view->renderWindow()->GetSize()[0], qRound(size.width() * view->devicePixelRatioF()));
  }
}

TEST_P(AView, IsDrawnWhenItIsFirstShownAndAfterAChangeOfSize)
{
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  const int before = presented;
  window.resize(200, 150);
  view->resize(200, 150);
  const QImage seen = seenAfter(before);
  EXPECT_EQ(difference(seen, drawnBy(*view->renderWindow())), "");
  EXPECT_NE(seen.pixelColor(3, 3), QColor(0, 255, 0));
}

TEST_P(AView, KeepsItsTextsAboveThePicture)
{
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  QLabel text(view);
  text.setStyleSheet(QStringLiteral("background: #102030"));
  text.setGeometry(20, 30, 50, 20);
  text.show();
  const QImage seen = shown();
  const double ratio = view->devicePixelRatioF();
  EXPECT_EQ(seen.pixelColor(qRound(30 * ratio), qRound(40 * ratio)), QColor(0x10, 0x20, 0x30));
  const QImage drawn = drawnBy(*view->renderWindow());
  EXPECT_EQ(seen.pixel(qRound(10 * ratio), qRound(40 * ratio)),
            drawn.pixel(qRound(10 * ratio), qRound(40 * ratio)));
}

/// What a widget paints.
class PaintedRegion : public QObject {
public:
  explicit PaintedRegion(QWidget& widget) : QObject(&widget) { widget.installEventFilter(this); }
  QRegion region;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override
  {
    if (event->type() == QEvent::Paint) region += static_cast<QPaintEvent*>(event)->region();
    return QObject::eventFilter(watched, event);
  }
};

TEST(ACopiedView, PaintsOnlyWhatChanged)
{
  QWidget window;
  gui::PlainVtkWidget view(&window, gui::PictureWay::copied);
  int presented = 0;
  QObject::connect(&view, &gui::PlainVtkWidget::presented, &view, [&presented] { ++presented; });
  window.resize(320, 200);
  view.setGeometry(window.rect());
  vtkNew<vtkRenderer> whole, corner;
  corner->SetViewport(0.75, 0.75, 1.0, 1.0);
  view.renderWindow()->AddRenderer(whole);
  view.renderWindow()->AddRenderer(corner);
  window.show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return presented > 0; }, patience_ms));
  const PaintedRegion painted(view);
  corner->SetBackground(1.0, 1.0, 1.0);
  const int before = presented;
  view.renderWindow()->Render();
  ASSERT_TRUE(QTest::qWaitFor([&] { return presented > before; }, patience_ms));
  const QRect area = painted.region.boundingRect();
  EXPECT_TRUE(area.contains(QRect(240, 0, 80, 50)));
  EXPECT_LT(area.width() * area.height(), 320 * 200 / 4);
}

INSTANTIATE_TEST_SUITE_P(EachWay, AView,
                         testing::Values(gui::PictureWay::composed, gui::PictureWay::copied),
                         [](const auto& way) {
                           return way.param == gui::PictureWay::copied ? "Copied" : "Composed";
                         });

}  // namespace
}  // namespace perilymph::test
