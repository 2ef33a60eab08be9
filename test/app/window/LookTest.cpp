// SPDX-License-Identifier: BSD-3-Clause

// Readability of the window: nothing clipped, no overlaps, units everywhere.

#include <gtest/gtest.h>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkRenderWindow.h>

#include <QLabel>
#include <algorithm>
#include <cstdlib>
#include <vector>

#include "KeptPicture.h"
#include "WindowRig.h"
#include "gui/run/UserSettings.h"
#include "gui/scene/ForceLabel.h"
#include "gui/setup/LandmarkDrawing.h"
#include "gui/shell/OverlayStack.h"
#include "gui/widgets/ElidedLabel.h"
#include "gui/widgets/Theme.h"
#include "perilymph/anatomy/Population.h"

namespace perilymph::test {
namespace {

/// A narrow window may cut the status line and labels that end in an ellipsis; both have a tooltip.
bool mayBeCut(const QLabel& label)
{
  return label.wordWrap() || label.objectName() == "statusLabel" ||
         qobject_cast<const gui::ElidedLabel*>(&label) != nullptr;
}

/// What is cut off or lies on another read-out; empty if nothing.
std::string illegible(WindowRig& rig)
{
  std::string found;
  for (const QLabel* label : rig.window().findChildren<QLabel*>()) {
    if (!label->isVisible() || label->text().isEmpty() || mayBeCut(*label)) continue;
    if (label->width() < label->sizeHint().width())
      found += "cut: " + label->text().toStdString() + '\n';
  }
  const auto readOuts = rig.window().findChildren<gui::ReadOut*>();
  for (const gui::ReadOut* one : readOuts) {
    const std::string name = one->objectName().toStdString();
    if (one->width() < one->sizeHint().width()) found += "cut: " + name + '\n';
    for (const gui::ReadOut* other : readOuts)
      if (one != other && one->geometry().intersects(other->geometry()))
        found += name + " lies on " + other->objectName().toStdString() + '\n';
  }
  return found;
}

/// Values that are computed in the background, such as the derived measures, may still be laid out.
void expectEverythingLegible(WindowRig& rig)
{
  EXPECT_EQ(rig.window().findChildren<gui::ReadOut*>().size(), 4);
  EXPECT_TRUE(WindowRig::waitUntil([&] { return illegible(rig).empty(); })) << illegible(rig);
}

TEST(WindowLook, NothingIsClippedDuringAnInsertion)
{
  WindowRig rig(session::Overrides{{"speed_mm_s", "10.0"}});
  rig.click("startButton");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 10.5; }));
  expectEverythingLegible(rig);
}

TEST(WindowLook, NothingIsClippedInTheSmallestWindow)
{
  WindowRig rig;
  rig.window().resize(rig.window().minimumSize());
  ASSERT_TRUE(
      WindowRig::waitUntil([&] { return rig.window().size() == rig.window().minimumSize(); }));
  expectEverythingLegible(rig);
}

TEST(WindowLook, TheCaptionOfTheForceSaysWhatItIs)
{
  WindowRig rig;
  EXPECT_EQ(rig.window().findChild<gui::ReadOut*>("forceReadOut")->caption(), "insertion force");
  EXPECT_TRUE(rig.window().findChild<gui::ForceLabel*>()->handText().contains("20 mN"));
}

TEST(WindowLook, WordsOfPictureAndChartsAreScaledOnceOnAScreenOfManyPixels)
{
  WindowRig rig;
  const auto views = rig.window().findChildren<gui::PlainVtkWidget*>();
  // array, two charts, the cochlea measured in a CT, a study, up to four arrays of a plan
  EXPECT_EQ(views.size(), 9);
  // scenes and charts get the device pixel ratio; VTK's own scaling would be applied on top
  constexpr int unscaledDpi = 72;
  for (const gui::PlainVtkWidget* view : views)
    EXPECT_EQ(view->renderWindow()->GetDPI(), unscaledDpi);
  gui::PlainVtkWidget composed(nullptr, gui::PictureWay::composed);
  EXPECT_FALSE(composed.findChild<QVTKOpenGLNativeWidget*>()->enableHiDPI());
}

TEST(WindowLook, SaysWhatItIsNot)
{
  WindowRig rig;
  EXPECT_TRUE(rig.label("statusLabel").contains("not a medical device"));
}

TEST(WindowLook, NamesThePatientAndTheEar)
{
  WindowRig rig(session::Overrides{{"side", "\"left\""}});
  EXPECT_TRUE(rig.label("patientLabel").contains("left ear"));
}

TEST(WindowLook, KeepsThePartsOfTheBarApart)
{
  WindowRig rig(session::Overrides{{"side", "\"left\""}, {"speed_mm_s", "1.0"}});
  auto* patient = rig.window().findChild<gui::ElidedLabel*>("patientLabel");
  rig.window().findChild<QWidget*>("modifiedLabel")->show();
  // parts that are nearer to their neighbor on the left than they may be, or beyond the edge
  const auto crowded = [&] {
    std::vector<const QWidget*> parts;
    for (const QWidget* part : patient->parentWidget()->findChildren<QWidget*>())
      if (part->isVisible()) parts.push_back(part);
    std::ranges::sort(parts, {}, [](const QWidget* part) { return part->geometry().left(); });
    std::string names;
    QRect before;
    for (const QWidget* part : parts) {
      if (part->geometry().left() - before.right() < (part == patient ? 24 : 4))
        names += part->objectName().toStdString() + " ";
      before = part->geometry();
    }
    return before.right() > rig.window().width() ? names + "edge" : names;
  };
  for (const int width : {1024, 1280, 1366}) {
    rig.window().resize(width, 700);
    ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.window().width() == width; }));
    EXPECT_TRUE(WindowRig::waitUntil([&] { return crowded().empty(); })) << crowded() << width;
    EXPECT_TRUE(patient->isWhole() || width < 1280) << width;
  }
}

TEST(WindowLook, TheWordsOnThePictureAreOnAGrabOfTheWindow)
{
  WindowRig rig;
  auto* travel = rig.window().findChild<gui::ReadOut*>("travelReadOut");
  const QRect place(travel->mapTo(&rig.window(), QPoint(0, 0)), travel->size());
  const QImage image = rig.window().grab(place).toImage();
  int bright = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (qGray(image.pixel(x, y)) > 180) ++bright;
  EXPECT_GT(bright, 50);  // strokes of "0.0" and its unit, 46 pixels high
}

TEST(WindowLook, ACheckBoxTakesItsPartOutOfThePicture)
{
  WindowRig rig;
  const QImage before = rig.picture();
  rig.click("show2");  // basilar membrane
  const QImage without = rig.picture();
  EXPECT_NE(without, before);
  rig.click("show2");
  EXPECT_EQ(rig.picture(), before);
}

/// Fraction of the points that differ by a quarter of the range from black to white.
double differing(const QImage& one, const QImage& other)
{
  int differs = 0;
  for (int y = 0; y < one.height(); ++y)
    for (int x = 0; x < one.width(); ++x)
      differs += std::abs(qGray(one.pixel(x, y)) - qGray(other.pixel(x, y))) > 64 ? 1 : 0;
  return double(differs) / (one.width() * one.height());
}

TEST(WindowLook, TheCardsOfTheStartPageHavePicturesOfThreeSubjects)
{
  WindowRig rig;
  rig.window().showPage("start");
  std::vector<QImage> pictures;
  for (const char* card : {"patientCard", "meanCard", "demonstrationCard"})
    pictures.push_back(rig.button(card).grab(QRect(10, 10, 270, 100)).toImage());
  for (std::size_t i = 0; i < pictures.size(); ++i)
    for (std::size_t j = i + 1; j < pictures.size(); ++j)
      EXPECT_GT(differing(pictures[i], pictures[j]), 0.1) << i << ", " << j;
}

TEST(WindowLook, TheDiameterAOfTheFormLiesAsInTheCochlearViewOfACt)
{
  const WindowRig rig;  // its theme
  for (const auto side : {anatomy::Side::left, anatomy::Side::right}) {
    gui::LandmarkDrawing drawing(nullptr);
    drawing.show({anatomy::spreadOfA().mean, anatomy::spreadOfB().mean, std::nullopt}, side);
    drawing.emphasize(gui::LandmarkDrawing::Landmark::a);
    drawing.resize(400, 250);
    const QImage picture = drawing.grab().toImage();
    QRect line;  // around the points of the emphasized line and its letter
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x)
        if (picture.pixelColor(x, y) == gui::shownTheme().accent) line |= QRect(x, y, 1, 1);
    EXPECT_GT(line.height(), 0.5 * picture.height());
    EXPECT_LT(line.width(), 0.3 * line.height());
    keepPicture(drawing, side == anatomy::Side::left ? "form-left" : "form-right");
  }
}

TEST(WindowLook, TheTextSizeIsChosenFromAList)
{
  WindowRig rig;
  rig.window().sheets().toggleSettings();
  bool isRequested = false;
  QObject::connect(&rig.window(), &gui::MainWindow::reopenRequested, [&] { isRequested = true; });
  rig.choose("textSize", "130");
  EXPECT_TRUE(isRequested);
  EXPECT_EQ(gui::UserSettings().value("textSize").toString(), "130");
  keepPicture(rig.window(), "settings");
  gui::UserSettings().remove("textSize");
}

}  // namespace
}  // namespace perilymph::test
