// SPDX-License-Identifier: BSD-3-Clause

// Comparison with accepted pictures, each of which was inspected first.

#include <gtest/gtest.h>
#include <vtkUnsignedCharArray.h>

#include "SceneOnScreen.h"
#include "perilymph/charts/ContactDistances.h"
#include "perilymph/charts/FigurePicture.h"
#include "perilymph/charts/TipSection.h"
#include "perilymph/charts/UnrolledScala.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::visualization {
namespace {

using test::SceneOnScreen;

/// An array with forces on its last third that increase toward the tip.
haptics::Snapshot pressed()
{
  haptics::Snapshot now = test::insertedTo(degrees(220));
  for (int node = 60; node < 97; ++node) test::press(now, node, millinewtons(0.3 * (node - 59)));
  return now;
}

const charts::ChartStyle lightCharts{figures::ColorScheme::light, {}};

/// A flat view drawn with three pixels per point.
test::DrawnPicture painted(const figures::Drawing& drawing)
{
  const test::TemporaryFolder folder;
  const auto written = charts::writePicture(drawing, folder / "view.png");
  EXPECT_TRUE(written) << written.error().message;
  return test::load(folder / "view.png");
}

struct FlatView : ::testing::Test {
  FlatView() { array.follow(pressed()); }
  charts::ArrayInScala array{*test::publishedScala(), test::plainArray()};
};

TEST_F(FlatView, UnrolledScalaLooksAsAccepted)
{
  const charts::UnrolledScala view(*test::publishedScala());
  EXPECT_EQ(test::comparedWithAccepted(painted(view.draw(array, 360.0, 160.0)), "unrolled"), "");
}

TEST_F(FlatView, UnrolledScalaLooksAsAcceptedOnAPageOfItsOwn)
{
  const charts::UnrolledScala view(*test::publishedScala(), lightCharts);
  EXPECT_EQ(
      test::comparedWithAccepted(painted(view.drawPage(array, 360.0, 220.0)), "unrolled-light"),
      "");
}

TEST_F(FlatView, TipSectionLooksAsAccepted)
{
  const charts::TipSection view(*test::publishedScala());
  EXPECT_EQ(test::comparedWithAccepted(painted(view.draw(array, 220.0, 240.0)), "tip-section"), "");
}

TEST_F(FlatView, ContactDistancesLookAsAccepted)
{
  const figures::Drawing view =
      charts::drawContactDistances(charts::contactDistances(array), 200.0, 240.0);
  EXPECT_EQ(test::comparedWithAccepted(painted(view), "contact-distances"), "");
}

TEST(WallForce, LooksAsAcceptedOnTheTranslucentWall)
{
  SceneOnScreen screen;
  screen.scene.setVisible(Part::contactArrows, false);
  screen.scene.show(pressed());
  screen.scene.lookFrom(CameraPreset::followTip);
  EXPECT_EQ(test::comparedWithAccepted(screen.picture(), "wall-force"), "");
}

TEST(LightLook, LooksAsAccepted)
{
  SceneOnScreen screen(anatomy::Side::right, {figures::ColorScheme::light, {}});
  screen.scene.show(pressed());
  EXPECT_EQ(test::comparedWithAccepted(screen.picture(), "surgeon-view-light"), "");
}

TEST(Anaglyph, LooksAsAccepted)
{
  SceneOnScreen screen;
  screen.scene.show(pressed());
  screen.scene.lookFrom(CameraPreset::overview);
  screen.scene.setStereo(Stereo::anaglyph);
  // the pictures of both eyes are combined in the front buffer
  screen.window->Render();
  test::DrawnPicture picture{screen.window->GetSize()[0], screen.window->GetSize()[1], {}};
  vtkNew<vtkUnsignedCharArray> pixels;
  screen.window->GetPixelData(0, 0, picture.width - 1, picture.height - 1, 1, pixels);
  picture.rgb.assign(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  EXPECT_EQ(test::comparedWithAccepted(picture, "anaglyph"), "");
}

}  // namespace
}  // namespace perilymph::visualization
