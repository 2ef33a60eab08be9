// SPDX-License-Identifier: BSD-3-Clause

// An array whose wires have yielded stays bent when it is out again, and the 3D view draws it so.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/test/TestPicture.h"
#include "perilymph/visualization/InsertionScene.h"

namespace perilymph::visualization {
namespace {

constexpr int width_px = 1000, height_px = 700;

/// The picture of a Slim Straight that was pushed 18 mm into the published cochlea and withdrawn.
class WithdrawnArray {
public:
  explicit WithdrawnArray(const session::Overrides& further)
  {
    session::Overrides overrides = {{"array", "slim-straight"},
                                    {"withdraw", "true"},
                                    {"speed_mm_s", "8"},
                                    {"dt_ms", "2"},
                                    {"nodes", "60"},
                                    {"stop_travel_mm", "18"}};
    overrides.insert(overrides.end(), further.begin(), further.end());
    const auto scenario = session::loadScenario("contour-published", overrides);
    EXPECT_TRUE(scenario) << scenario.error().message;
    const session::InsertionParameters& parameters = scenario->parameters();
    auto insertion = session::Insertion::prepare(
        parameters,
        std::make_unique<device::ScriptedDevice>(parameters.speed.si(), parameters.timeStep.si()));
    EXPECT_TRUE(insertion) << insertion.error().message;
    EXPECT_TRUE((*insertion)->runToEnd({}));
    (*insertion)->refresh();
    const haptics::Snapshot& now = (*insertion)->latest();
    EXPECT_LT(now.output.travel, 0.1e-3) << "out again";

    window_->SetOffScreenRendering(true);
    window_->SetSize(width_px, height_px);
    scene_ = std::make_unique<InsertionScene>((*insertion)->anatomy(), parameters.array,
                                              anatomy::Side::right);
    scene_->attachTo(*window_);
    scene_->lookFrom(CameraPreset::surgeon);
    scene_->setMagnification(4.0);
    scene_->moveModel(6.0, -9.0);
    scene_->show(now);
  }

  /// How wide the array is drawn [mm]: its own width where it is straight, more where it is bent; the
  /// narrowest strip, at any angle, that holds all its pixels.
  ///
  /// @param picture  Name under which the whole picture is kept for people who look at it.
  double drawnWidth_mm(const std::string& picture)
  {
    if (const char* folder = std::getenv("PERILYMPH_SCREEN_PICTURES"))
      test::save(test::draw(*window_), std::filesystem::path(folder) / (picture + ".png"));
    for (const Part part : {Part::wallForce, Part::contactArrows, Part::membrane,
                            Part::styletAndTweezers, Part::scala})
      scene_->setVisible(part, false);
    const test::DrawnPicture with = test::draw(*window_);
    scene_->show(haptics::Snapshot{});
    const test::DrawnPicture without = test::draw(*window_);
    std::vector<std::pair<double, double>> pixels;
    for (int y = 0; y < height_px; ++y)
      for (int x = 0; x < width_px; ++x)
        if (test::difference(with.at(x, y), without.at(x, y)) > 20) pixels.emplace_back(x, y);
    EXPECT_GT(pixels.size(), 500u);
    double narrowest = std::numeric_limits<double>::infinity();
    for (int degree = 0; degree < 180; ++degree) {
      const double angle = degree * std::numbers::pi / 180.0;
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const auto& [x, y] : pixels) {
        const double across = x * std::cos(angle) + y * std::sin(angle);
        low = std::min(low, across);
        high = std::max(high, across);
      }
      narrowest = std::min(narrowest, high - low);
    }
    // at a magnification of 10 a picture is 17 mm high
    return narrowest * 17.0 * 10.0 / scene_->magnification() / height_px;
  }

private:
  vtkNew<vtkRenderWindow> window_;
  std::unique_ptr<InsertionScene> scene_;
};

TEST(BentArray, IsDrawnAsBentAfterItsWithdrawal)
{
  const double straight = WithdrawnArray(session::Overrides{}).drawnWidth_mm("withdrawn-elastic");
  const double bent =
      WithdrawnArray(session::Overrides{{"wire_yield_MPa", "250"}}).drawnWidth_mm("withdrawn-bent");
  // the array is 0.6 mm wide; the nodes of the elastic one are within 0.8 mm of a line, those of the other
  // are not (YieldingWires.LeaveThePublishedCochleaBent)
  EXPECT_LT(straight, 0.6 + 0.8);
  EXPECT_GT(bent, straight + 0.5);
}

}  // namespace
}  // namespace perilymph::visualization
