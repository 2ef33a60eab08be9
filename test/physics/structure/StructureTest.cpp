// SPDX-License-Identifier: BSD-3-Clause

// Three published facts that depend on the structure of the model and hardly on its constants. What was
// expected is stated in the guide's page structure.md; its tables are what is computed here.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "bench/RodInChannel.h"
#include "perilymph/analysis/ExperimentDevice.h"
#include "perilymph/foundation/Quantile.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/session/Scenario.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::validation {
namespace {

/// The force of an insertion by machine over depth and angle.
struct Curve {
  std::vector<double> depth_mm, angle_deg, force;

  /// Mean force within a distance of a place; NaN if the array never came there.
  static double meanNear(const std::vector<double>& places, const std::vector<double>& force,
                         double place, double distance)
  {
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (std::fabs(places[i] - place) <= distance) {
        sum += force[i];
        count += 1.0;
      }
    return sum / count;
  }
  double atAngle(double angle) const { return meanNear(angle_deg, force, angle, 5.0); }
  double atDepth(double depth) const { return meanNear(depth_mm, force, depth, 0.25); }
};

Curve curveOf(const session::Overrides& overrides)
{
  session::Overrides all = {{"stop_force_N", "0"}, {"membrane", "rigid"}, {"dt_ms", "2"}};
  all.insert(all.end(), overrides.begin(), overrides.end());
  const auto scenario = session::loadScenario("surgery-flex28", all);
  EXPECT_TRUE(scenario) << scenario.error().message;
  const session::InsertionParameters parameters = scenario->parameters();
  const auto anatomy = session::buildAnatomy(parameters);
  EXPECT_TRUE(anatomy) << anatomy.error().message;
  auto insertion = session::Insertion::prepare(
      parameters,
      std::make_unique<analysis::ExperimentDevice>(
          analysis::TremblingPush{.speed = parameters.speed.si()}, parameters.timeStep),
      *anatomy);
  EXPECT_TRUE(insertion) << insertion.error().message;
  Curve curve;
  const auto each = [&](const haptics::TickRecord& record) {
    if (record.output.workflow != haptics::Workflow::inserting) return true;
    curve.depth_mm.push_back(inMillimeters(meters(record.output.depth)));
    curve.angle_deg.push_back(inDegrees(radians(record.output.angularDepth)));
    curve.force.push_back(record.output.axialForce);
    return true;
  };
  const auto ran =
      (*insertion)->runToEnd(each, session::maxTicks(parameters, (*insertion)->model()));
  EXPECT_TRUE(ran) << ran.error().message;
  return curve;
}

/// The numbers of the row of the page that begins with a name.
std::vector<double> pageNumbers(const std::string& name)
{
  std::ifstream page(test::projectFolder() / "resources/guide/structure.md");
  std::string line;
  while (std::getline(page, line)) {
    if (line.rfind("| " + name + " |", 0) != 0) continue;
    std::vector<double> numbers;
    for (std::size_t i = line.find('|', 2); i != std::string::npos; i = line.find('|', i + 1)) {
      const char* text = line.c_str() + i + 1;
      char* end = nullptr;
      const double number = std::strtod(text, &end);
      if (end != text) numbers.push_back(number);
    }
    return numbers;
  }
  ADD_FAILURE() << "structure.md has no row " << name;
  return {};
}

/// Prints a row and expects the page to have it.
void expectOnPage(const std::string& name, const std::vector<double>& found)
{
  std::printf("| %s |", name.c_str());
  for (const double value : found) std::printf(" %.2f |", value);
  std::printf("\n");
  const std::vector<double> page = pageNumbers(name);
  ASSERT_EQ(page.size(), found.size()) << name;
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], page[i], test::tolerance(0.02, "two decimals, and their rounding"))
        << name;
}

TEST(Structure, OfForceOverAngleInSmallAndLargeCochleae)
{
  for (const char* array : {"flex28", "slim-straight"}) {
    const auto cochlea = [&](const char* a, const char* b) {
      return curveOf({{"array", array},
                      {"stop_travel_mm", "19"},
                      {"start_inside_mm", "1"},
                      {"free_length_mm", "3"},
                      {"friction_static", "0.165"},
                      {"friction_dynamic", "0.165"},
                      {"speed_mm_s", "1"},
                      {"patient_numbers.a_mm", a},
                      {"patient_numbers.b_mm", b}});
    };
    const Curve small = cochlea("8.3", "5.95"), large = cochlea("10.4", "7.45");
    std::vector<double> ratios;
    for (const double angle : {120.0, 180.0, 240.0, 300.0})
      ratios.push_back(small.atAngle(angle) / large.atAngle(angle));
    expectOnPage(std::string(array) + ", small over large", ratios);
  }
}

TEST(Structure, OfTissueOverSoapInOneCochlea)
{
  const auto medium = [](const char* friction) {
    return curveOf({{"array", "slim-straight"},
                    {"stop_travel_mm", "14.2"},
                    {"start_inside_mm", "1"},
                    {"free_length_mm", "3"},
                    {"friction_static", friction},
                    {"friction_dynamic", friction},
                    {"friction_stopping", "0.02"},
                    {"speed_mm_s", "0.5"},
                    {"patient_numbers.a_mm", "7.55"},
                    {"patient_numbers.b_mm", "5.55"}});
  };
  const Curve soap = medium("0.05"), tissue = medium("0.165");
  std::vector<double> ratios;
  for (const double depth : {8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 14.9})
    ratios.push_back(tissue.atDepth(depth) / soap.atDepth(depth));
  expectOnPage("0.165 over 0.05", ratios);
}

TEST(Structure, OfTightOverWideChannels)
{
  // a uniform rod in a channel that is straight up to 1 mm and then has a constant radius
  const auto force = [](double radius, double friction, double depth) {
    const SpiralChannel channel{radius, 0.0, 1e-3, 2e-3};
    return ChannelForce(channel, friction, depth).at(depth).force(0.0, 2.667);
  };
  for (const auto& [friction, name] :
       {std::pair{0.05, "elastic, friction 0.05"}, std::pair{0.165, "elastic, friction 0.165"}}) {
    std::vector<double> ratios;
    for (const double depth : {10e-3, 15e-3, 20e-3})
      ratios.push_back(force(6.4e-3, friction, depth) / force(12.7e-3, friction, depth));
    expectOnPage(name, ratios);
  }
}

}  // namespace
}  // namespace perilymph::validation
