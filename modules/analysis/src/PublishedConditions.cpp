// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/PublishedConditions.h"

namespace perilymph::analysis {

namespace {

bool hasSameArray(const session::Scenario& one, const session::Scenario& other)
{
  return one.arrayName() == other.arrayName() &&
         one.arrayFingerprint() == other.arrayFingerprint() && one.technique() == other.technique();
}

bool hasSameCochlea(const session::Scenario& one, const session::Scenario& other)
{
  const anatomy::Patient &mine = one.patient(), &theirs = other.patient();
  return one.anatomy() == other.anatomy() && one.leadIn() == other.leadIn() &&
         mine.scalaTympaniLength == theirs.scalaTympaniLength &&
         mine.roundWindowWidth == theirs.roundWindowWidth &&
         mine.roundWindowHeight == theirs.roundWindowHeight &&
         mine.basalTurn.has_value() == theirs.basalTurn.has_value();
}

bool hasSameFriction(const session::Scenario& one, const session::Scenario& other)
{
  const mechanics::FrictionLaw &mine = one.friction(), &theirs = other.friction();
  return mine.staticCoefficient == theirs.staticCoefficient &&
         mine.kineticCoefficient == theirs.kineticCoefficient &&
         mine.stoppingCoefficient == theirs.stoppingCoefficient &&
         mine.bySpeed.isEmpty() == theirs.bySpeed.isEmpty();
}

const Result<session::Scenario>& published()
{
  static const Result<session::Scenario> scenario = session::loadScenario("contour-published");
  return scenario;
}

}  // namespace

bool hasPublishedBasalTurn(const session::Scenario& insertion)
{
  return published() && hasSameArray(insertion, *published()) &&
         hasSameCochlea(insertion, *published());
}

bool hasPublishedConditions(const session::Scenario& insertion)
{
  return hasPublishedBasalTurn(insertion) && hasSameFriction(insertion, *published()) &&
         insertion.speed() == published()->speed();
}

}  // namespace perilymph::analysis
