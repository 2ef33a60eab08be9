// SPDX-License-Identifier: BSD-3-Clause
#include "TrialSettings.h"

namespace perilymph::test {
namespace {

mechanics::FrictionLaw coulomb(double coefficient)
{
  return {coefficient, coefficient, 0.4 * coefficient, millimetersPerSecond(0.1), {}};
}

/// Rises and falls with the speed (Dohr et al. 2021).
mechanics::FrictionLaw tissue()
{
  mechanics::FrictionLaw law = coulomb(0.24);
  law.bySpeed = {{millimetersPerSecond(0.1), millimetersPerSecond(1.5), millimetersPerSecond(2.0)},
                 {0.24, 0.59, 0.45}};
  return law;
}

std::vector<Setting> all()
{
  using mechanics::Coupling;
  const mechanics::FrictionLaw paper;
  const auto row = [](const char* name, const char* anatomy, const char* array,
                      const mechanics::FrictionLaw& friction, double wall, Coupling coupling,
                      StyletUse stylet) {
    Setting setting;
    setting.name = name;
    setting.anatomy = anatomy;
    setting.array = array;
    setting.friction = friction;
    setting.wall = wall;
    setting.coupling = coupling;
    setting.stylet = stylet;
    return setting;
  };
  const auto rigid = Coupling::rigid, spring = Coupling::spring;
  const auto stays = StyletUse::stays, pulled = StyletUse::pulled, held = StyletUse::held,
             out = StyletUse::out;
  std::vector<Setting> rows = {
      row("published", "published", "contour", paper, 441, rigid, stays),
      row("published_on_a_spring", "published", "contour", paper, 441, spring, stays),
      row("no_friction", "mean", "contour", coulomb(0.0), 441, rigid, stays),
      row("rough", "mean", "contour", coulomb(0.6), 441, rigid, stays),
      row("bone", "mean", "contour", paper, 10'000, rigid, stays),
      row("rough_bone", "mean", "contour", coulomb(0.6), 10'000, rigid, stays),
      row("rough_bone_on_a_spring", "mean", "contour", coulomb(0.6), 10'000, spring, stays),
      row("tissue_that_rises_and_falls", "mean", "contour", tissue(), 2'000, rigid, stays),
      row("stylet_pulled_anywhere", "mean", "contour", paper, 441, rigid, pulled),
      row("stylet_pulled_from_rough_bone", "mean", "contour-advance", coulomb(0.6), 10'000, spring,
          pulled),
      row("advance_off_stylet", "mean", "contour-advance", paper, 2'000, rigid, held),
      row("sheath", "mean", "slim-modiolar", coulomb(0.2), 2'000, spring, held),
      row("released_at_once", "mean", "contour-advance", paper, 441, rigid, out),
      row("straight_and_soft", "mean", "flex28", paper, 441, rigid, stays),
      row("straight_on_a_spring", "mean", "flex28", tissue(), 441, spring, stays),
      row("straight_in_rough_bone", "mean", "slim-straight", coulomb(0.6), 10'000, rigid, stays),
      row("too_thick_at_its_base", "mean", "flexsoft", paper, 2'000, spring, stays),
      row("round_window_and_membrane", "mean", "contour", paper, 2'000, spring, pulled),
      row("straight_through_the_round_window", "mean", "flex28", coulomb(0.3), 441, rigid, stays),
      row("short_steps", "mean", "evo", coulomb(0.3), 10'000, spring, stays),
      row("long_steps", "published", "contour", paper, 441, rigid, stays),
  };
  rows[1].isWatchedLonger = true;
  rows[rows.size() - 4].hasRim = rows[rows.size() - 4].hasSoftMembrane = true;
  rows[rows.size() - 3].hasRim = true;
  rows[rows.size() - 2].timeStep = 0.2e-3;
  rows.back().timeStep = 5e-3;
  rows.push_back(row("oval_against_lined_bone", "mean", "flex28", coulomb(0.3), 0, rigid, stays));
  rows.back().isLined = true;
  rows.push_back(row("lined_bone_on_a_spring", "mean", "contour", tissue(), 0, spring, pulled));
  rows.back().isLined = true;
  const mechanics::RelaxationLaw relaxation{{{{0.3, seconds(0.05)}, {0.4, seconds(2)}}},
                                            {0.5, seconds(0.1)}};
  rows.push_back(row("relaxing", "mean", "flex28", coulomb(0.3), 2'000, rigid, stays));
  rows.back().relaxation = relaxation;
  rows.push_back(row("relaxing_on_a_spring", "published", "contour", paper, 441, spring, stays));
  rows.back().relaxation = relaxation;
  rows.push_back(row("yielding", "mean", "flex28", coulomb(0.3), 2'000, rigid, stays));
  rows.back().yieldMoment = 0.5e-6;
  rows.push_back(row("yielding_and_relaxing", "published", "contour", paper, 441, spring, stays));
  rows.back().yieldMoment = 10e-6;
  rows.back().relaxation = relaxation;
  return rows;
}

}  // namespace

const std::vector<Setting>& settings()
{
  static const std::vector<Setting> rows = all();
  return rows;
}

}  // namespace perilymph::test
