// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/ArrayTour.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

namespace perilymph::gui {

namespace {

/// One array of each of the other makers, whose forces in the shipped scenario are not above those
/// measured in patients (choice).
constexpr std::array otherArrays{"slim-modiolar", "hifocus-slimj", "evo"};

QString translated(const char* text) { return QCoreApplication::translate("ArrayTour", text); }

std::string quoted(const std::string& name) { return '"' + name + '"'; }

bool isPrecurved(const electrode::ArrayDesign& array)
{
  const auto& curvature = array.restCurvature.value;
  return std::any_of(curvature.begin(), curvature.end(),
                     [](Curvature value) { return value.si() != 0.0; });
}

}  // namespace

std::vector<session::Scenario> arrayTour(const session::Scenario& booth)
{
  std::vector<session::Scenario> tour{booth};
  for (const char* name : otherArrays) {
    if (name == booth.arrayName()) continue;
    // a stylet is held back, as surgeons do, so that the array curls
    session::Overrides values{{"array", quoted(name)}};
    auto scenario = booth.with(values);
    if (scenario && scenario->array().hasStylet) {
      values.emplace_back("technique",
                          quoted(session::nameOf(session::Technique::advanceOffStylet)));
      scenario = booth.with(values);
    }
    if (scenario) tour.push_back(*scenario);
  }
  return tour;
}

QString arraySentence(const session::Scenario& scenario)
{
  if (isPrecurved(scenario.array()))
    return translated(QT_TRANSLATE_NOOP("ArrayTour",
                                        "This array is pre-curved: it curls around the core of the "
                                        "snail, close to the hearing nerve."));
  return translated(
      QT_TRANSLATE_NOOP("ArrayTour",
                        "This array is straight: it bends along the outer wall of the "
                        "snail and slides on."));
}

}  // namespace perilymph::gui
