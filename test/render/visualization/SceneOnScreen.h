// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A scene with its render window, and arrays at given positions in the scala.

#include <vtkRenderer.h>

#include <cmath>
#include <memory>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/test/TestPicture.h"
#include "perilymph/visualization/InsertionScene.h"

namespace perilymph::test {

inline constexpr int arrayNodes = 100;

inline std::shared_ptr<const anatomy::ScalaTympani> publishedScala()
{
  static const auto scala = anatomy::buildPublished({}, millimeters(1));
  return scala;
}

/// A tapered array of 24 mm with ten contacts, two ribs and a stylet.
inline electrode::ArrayDesign plainArray()
{
  electrode::ArrayDesign array;
  array.name = "plain";
  array.length = millimeters(24);
  array.diameter = {{millimeters(0), millimeters(24)}, {millimeters(0.5), millimeters(0.8)}};
  for (int i = 0; i < 10; ++i) array.contactsFromTip.push_back(millimeters(1.0 + 1.2 * i));
  array.contactLength = millimeters(0.3);
  array.ribsFromTip = {millimeters(18), millimeters(20)};
  array.hasStylet = true;
  array.stylet.fromTip = millimeters(2);
  return array;
}

/// The array along the middle of the scala up to an angle, and straight out of the opening.
inline haptics::Snapshot insertedTo(Angle tip)
{
  const anatomy::ScalaTympani& scala = *publishedScala();
  const anatomy::Entry entry = scala.entry();
  std::vector<Eigen::Vector3d> line{entry.origin_W + 0.03 * entry.out_W, entry.origin_W};
  constexpr int steps = 2000;
  for (int i = 0; i <= steps; ++i) line.push_back(scala.center_W(tip.si() * i / steps));

  haptics::Snapshot now{};
  now.nodes = arrayNodes;
  // from the tip backward in equal steps
  std::size_t at = line.size() - 1;
  Eigen::Vector3d place = line[at];
  for (int node = arrayNodes - 1; node >= 0; --node) {
    for (int k = 0; k < 3; ++k)
      now.node_W[static_cast<std::size_t>(node)][static_cast<std::size_t>(k)] =
          static_cast<float>(place[k]);
    double left = plainArray().length.si() / (arrayNodes - 1);
    while (at > 0) {
      const double step = (line[at - 1] - place).norm();
      if (step > left) break;
      left -= step;
      place = line[--at];
    }
    if (at > 0) place += left * (line[at - 1] - place).normalized();
  }
  return now;
}

/// Applies a wall force to one node, toward the modiolus.
inline void press(haptics::Snapshot& now, int node, Force force)
{
  const std::size_t i = static_cast<std::size_t>(node);
  const Eigen::Vector2d outward(now.node_W[i][0], now.node_W[i][1]);
  const Eigen::Vector2d inward = -force.si() * outward.normalized();
  now.normalForce[i] = static_cast<float>(force.si());
  now.wallForce_W[i] = {static_cast<float>(inward.x()), static_cast<float>(inward.y()), 0.0f};
}

inline Eigen::Vector3d node_mm(const haptics::Snapshot& now, int node)
{
  const std::array<float, 3>& place = now.node_W[static_cast<std::size_t>(node)];
  return 1e3 * Eigen::Vector3d(place[0], place[1], place[2]);
}

/// A scene in an offscreen window of 640 x 400 pixels.
struct SceneOnScreen {
  explicit SceneOnScreen(anatomy::Side side = anatomy::Side::right,
                         const visualization::SceneStyle& style = {})
      : scene(*publishedScala(), plainArray(), side, visualization::Quality::software, style)
  {
    window->SetOffScreenRendering(true);
    window->SetSize(640, 400);
    scene.attachTo(*window);
  }

  DrawnPicture picture() { return draw(*window); }

  void showOnlyArray()
  {
    using visualization::Part;
    for (const Part part : {Part::wallForce, Part::contactArrows, Part::membrane,
                            Part::styletAndTweezers, Part::scala})
      scene.setVisible(part, false);
  }

  /// The pixel of a point in the scene's coordinates [mm].
  Eigen::Vector2d pixel(const Eigen::Vector3d& point_mm)
  {
    window->Render();
    vtkRenderer& renderer = scene.renderer();
    renderer.SetWorldPoint(point_mm.x(), point_mm.y(), point_mm.z(), 1.0);
    renderer.WorldToDisplay();
    const double* display = renderer.GetDisplayPoint();
    return {display[0], display[1]};
  }

  /// Lower and upper corner of the bounding box of all visible parts [mm].
  std::pair<Eigen::Vector3d, Eigen::Vector3d> bounds()
  {
    double b[6];
    scene.renderer().ComputeVisiblePropBounds(b);
    return {{b[0], b[2], b[4]}, {b[1], b[3], b[5]}};
  }

  visualization::InsertionScene scene;
  vtkNew<vtkRenderWindow> window;
};

}  // namespace perilymph::test
