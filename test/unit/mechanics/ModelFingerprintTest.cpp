// SPDX-License-Identifier: BSD-3-Clause
// A model's fingerprint changes with every value that affects results, even by the smallest change.

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "lumen/GridLumen.h"
#include "lumen/PlainLumens.h"
#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::mechanics {
namespace {

void nudge(double& value) { value = std::nextafter(value, std::numeric_limits<double>::max()); }

template <class Dimension>
void nudge(Quantity<Dimension>& quantity)
{
  double value = quantity.si();
  nudge(value);
  quantity = Quantity<Dimension>::fromSi(value);
}

/// A rising ring of round sections, 30 degrees apart.
anatomy::SectionTables ringTables()
{
  anatomy::SectionTables tables;
  tables.step = degrees(30).si();
  tables.directions = 12;
  for (int i = 0; i < 19; ++i) {
    const double angle = i * tables.step;
    tables.centerRadius.push_back(3e-3 + 2.5e-3 * std::exp(-angle / 0.6));
    tables.centerHeight.push_back(3e-3 * i / 12.0);
    tables.membraneInner.push_back(-0.3e-3);
    tables.membraneOuter.push_back(0.3e-3);
    tables.membraneHeight.push_back(0.95e-3);
    tables.planRadius.push_back(tables.centerRadius.back());
    tables.wallRadius.insert(tables.wallRadius.end(), 12, 1e-3);
  }
  tables.leadIn = 1e-3;
  tables.measuredTo = degrees(360).si();
  return tables;
}

template <class Value>
electrode::AlongArray<Value> along(Value atTip, Value atBase)
{
  return {{millimeters(1), millimeters(18)}, {atTip, atBase}};
}

/// An array that uses every member of an ArrayDesign.
electrode::ArrayDesign fullArray()
{
  electrode::ArrayDesign array;
  array.length = millimeters(22);
  array.insertable = millimeters(18);
  array.diameter = along(millimeters(0.5), millimeters(0.8));
  array.thickness = along(millimeters(0.4), millimeters(0.7));
  array.tip = {millimeters(0.2), millimeters(0.5)};
  array.bending = along(newtonSquareMeters(1e-6), newtonSquareMeters(2e-6));
  array.bendingAcross = along(newtonSquareMeters(2e-6), newtonSquareMeters(3e-6));
  array.twisting = along(newtonSquareMeters(1e-6), newtonSquareMeters(2e-6));
  array.restCurvature = along(perMillimeter(0.2), perMillimeter(0.1));
  array.contactsFromTip = {millimeters(1), millimeters(3)};
  array.contactLength = millimeters(0.4);
  array.ribsFromTip = {millimeters(17), millimeters(19)};
  array.ribHeight = millimeters(0.1);
  array.ribLength = millimeters(0.3);
  array.hasStylet = true;
  array.stylet = {millimeters(2), newtonSquareMeters(5e-6), 0.1, millimeters(8), {}};
  return array;
}

ModelParts fullParts()
{
  ModelParts parts;
  static const auto ring = std::make_shared<const anatomy::ScalaTympani>(ringTables());
  parts.lumen = ring;
  parts.array = fullArray();
  parts.membrane = MembraneLaw{};
  parts.opening = cochleostomy();
  parts.opening->outward = millimeters(0.1);
  parts.opening->vertical = millimeters(0.1);
  parts.approachTilt = degrees(2);
  parts.approachTurn = degrees(3);
  return parts;
}

std::uint64_t fingerprintOf(const ModelParts& parts)
{
  return InsertionModel::build(parts)->fingerprint;
}

using Change = std::function<void(ModelParts&)>;
struct NamedChange {
  std::string name;
  Change change;
};

void expectEachChangesTheFingerprint(const ModelParts& parts,
                                     const std::vector<NamedChange>& changes)
{
  const std::uint64_t before = fingerprintOf(parts);
  EXPECT_EQ(before, fingerprintOf(parts)) << "the same parts give the same fingerprint";
  for (const auto& [name, change] : changes) {
    ModelParts changed = parts;
    change(changed);
    EXPECT_NE(fingerprintOf(changed), before) << name;
  }
}

TEST(ModelFingerprint, ChangesWithEveryNumberOfTheArray)
{
  using Parts = ModelParts;
  expectEachChangesTheFingerprint(
      fullParts(),
      {{"length", [](Parts& p) { nudge(p.array.length); }},
       {"insertable", [](Parts& p) { nudge(p.array.insertable); }},
       {"diameter", [](Parts& p) { nudge(p.array.diameter.value[1]); }},
       {"place of a diameter", [](Parts& p) { nudge(p.array.diameter.fromTip[1]); }},
       {"thickness of oval sections", [](Parts& p) { nudge(p.array.thickness.value[0]); }},
       {"radius of the tip", [](Parts& p) { nudge(p.array.tip.radius); }},
       {"taper of the tip", [](Parts& p) { nudge(p.array.tip.taper); }},
       {"bending stiffness", [](Parts& p) { nudge(p.array.bending.value[1]); }},
       {"bending stiffness across", [](Parts& p) { nudge(p.array.bendingAcross.value[0]); }},
       {"twisting stiffness", [](Parts& p) { nudge(p.array.twisting->value[0]); }},
       {"known twisting stiffness", [](Parts& p) { p.array.twisting.reset(); }},
       {"rest curvature", [](Parts& p) { nudge(p.array.restCurvature.value[0]); }},
       {"electrode contact", [](Parts& p) { nudge(p.array.contactsFromTip[1]); }},
       {"number of contacts", [](Parts& p) { p.array.contactsFromTip.pop_back(); }},
       {"contact length", [](Parts& p) { nudge(p.array.contactLength); }},
       {"rib", [](Parts& p) { nudge(p.array.ribsFromTip[0]); }},
       {"rib height", [](Parts& p) { nudge(p.array.ribHeight); }},
       {"rib length", [](Parts& p) { nudge(p.array.ribLength); }},
       {"presence of a stylet", [](Parts& p) { p.array.hasStylet = false; }},
       {"stylet's tip", [](Parts& p) { nudge(p.array.stylet.fromTip); }},
       {"stylet's stiffness", [](Parts& p) { nudge(p.array.stylet.bending); }},
       {"stylet's residual curvature", [](Parts& p) { nudge(p.array.stylet.residualCurvature); }},
       {"depth at which the stylet is held", [](Parts& p) { nudge(*p.array.stylet.holdDepth); }}});
}

TEST(ModelFingerprint, ChangesWithEveryTableOfTheLumen)
{
  using Tables = anatomy::SectionTables;
  const auto last = [](std::vector<double>& values) { nudge(values.back()); };
  const std::vector<std::pair<std::string, std::function<void(Tables&)>>> changes{
      {"step", [](Tables& t) { nudge(t.step); }},
      {"radius of a center", [&](Tables& t) { last(t.centerRadius); }},
      {"height of a center", [&](Tables& t) { last(t.centerHeight); }},
      {"wall", [&](Tables& t) { last(t.wallRadius); }},
      {"inner edge of the membrane", [&](Tables& t) { last(t.membraneInner); }},
      {"outer edge of the membrane", [&](Tables& t) { last(t.membraneOuter); }},
      {"height of the membrane", [&](Tables& t) { last(t.membraneHeight); }},
      {"path of the organ of Corti", [&](Tables& t) { last(t.planRadius); }},
      {"lead-in", [](Tables& t) { nudge(t.leadIn); }},
      {"end of what was measured", [](Tables& t) { nudge(t.measuredTo); }}};
  std::vector<NamedChange> all;
  for (const auto& [name, change] : changes)
    all.push_back({name, [change = change](ModelParts& parts) {
                     Tables tables = ringTables();
                     change(tables);
                     parts.lumen = std::make_shared<const anatomy::ScalaTympani>(tables);
                   }});
  expectEachChangesTheFingerprint(fullParts(), all);
}

TEST(ModelFingerprint, ChangesWithTheNumbersOfPlainLumens)
{
  const auto fingerprintIn = [](std::shared_ptr<const anatomy::Lumen> lumen) {
    ModelParts parts = fullParts();
    parts.lumen = std::move(lumen);
    parts.membrane.reset();
    return fingerprintOf(parts);
  };
  const auto duct = [&](double radius, double bend, double lead) {
    return fingerprintIn(std::make_shared<anatomy::CircularDuct>(radius, bend, lead));
  };
  const double more = 1.0 + std::numeric_limits<double>::epsilon();
  EXPECT_NE(duct(1e-3, 4e-3, 3e-3), duct(1e-3 * more, 4e-3, 3e-3));
  EXPECT_NE(duct(1e-3, 4e-3, 3e-3), duct(1e-3, 4e-3 * more, 3e-3));
  EXPECT_NE(duct(1e-3, 4e-3, 3e-3), duct(1e-3, 4e-3, 3e-3 * more));
  EXPECT_NE(fingerprintIn(std::make_shared<anatomy::StraightTube>(1e-3)),
            fingerprintIn(std::make_shared<anatomy::StraightTube>(1e-3 * more)));
  EXPECT_NE(fingerprintIn(std::make_shared<anatomy::FlatWall>(5e-3)),
            fingerprintIn(std::make_shared<anatomy::FlatWall>(5e-3 * more)));
}

/// A box below the plane of the entry, 2 mm wide, open or closed at the top.
anatomy::Surface box(double depth, bool isClosed)
{
  anatomy::Surface surface;
  for (const double z : {-depth, 0.0})
    for (const auto& [x, y] : {std::pair{-1e-3, -1e-3}, {1e-3, -1e-3}, {1e-3, 1e-3}, {-1e-3, 1e-3}})
      surface.points.push_back({x, y, z});
  surface.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {1, 2, 6},
                       {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  if (isClosed) surface.triangles.insert(surface.triangles.end(), {{4, 5, 6}, {4, 6, 7}});
  return surface;
}

TEST(ModelFingerprint, ChangesWithTheShapeOfALumenWithoutTables)
{
  const auto fingerprintIn = [](double depth) {
    ModelParts parts = fullParts();
    parts.lumen = std::make_shared<const anatomy::GridLumen>(box(depth, false), box(depth, true),
                                                             anatomy::Entry{});
    parts.membrane.reset();
    return fingerprintOf(parts);
  };
  EXPECT_EQ(fingerprintIn(2e-3), fingerprintIn(2e-3));
  EXPECT_NE(fingerprintIn(2e-3), fingerprintIn(2e-3 + 1e-8));
}

TEST(ModelFingerprint, ChangesWithEveryLawAndSetting)
{
  using Parts = ModelParts;
  const FrictionBySpeed bySpeed({metersPerSecond(1e-3), metersPerSecond(2e-3)}, {0.1, 0.2});
  expectEachChangesTheFingerprint(
      fullParts(),
      {{"static friction", [](Parts& p) { nudge(p.friction.staticCoefficient); }},
       {"kinetic friction", [](Parts& p) { nudge(p.friction.kineticCoefficient); }},
       {"stopping friction", [](Parts& p) { nudge(p.friction.stoppingCoefficient); }},
       {"Stribeck speed", [](Parts& p) { nudge(p.friction.stribeck); }},
       {"friction by speed", [&](Parts& p) { p.friction.bySpeed = bySpeed; }},
       {"wall stiffness", [](Parts& p) { nudge(p.wall.perSamplePoint); }},
       {"tangential wall stiffness", [](Parts& p) { nudge(p.wall.tangentialPerSamplePoint); }},
       {"lining of the wall", [](Parts& p) { nudge(p.wall.lining); }},
       {"delay of oval sections", [](Parts& p) { p.wall.sectionDelay = milliseconds(7); }},
       {"edge of the wall", [](Parts& p) { p.wall.edge = millimeters(0.5); }},
       {"rim stiffness", [](Parts& p) { p.wall.rim = newtonsPerMeter(500); }},
       {"presence of a membrane", [](Parts& p) { p.membrane.reset(); }},
       {"membrane stiffness", [](Parts& p) { nudge(p.membrane->perSamplePoint); }},
       {"hardening of the membrane", [](Parts& p) { nudge(p.membrane->hardening); }},
       {"presence of an opening", [](Parts& p) { p.opening.reset(); }},
       {"width of the opening", [](Parts& p) { nudge(p.opening->width); }},
       {"height of the opening", [](Parts& p) { nudge(p.opening->height); }},
       {"rim of the opening", [](Parts& p) { nudge(p.opening->edgeRadius); }},
       {"place of the opening", [](Parts& p) { nudge(p.opening->outward); }},
       {"height of its place", [](Parts& p) { nudge(p.opening->vertical); }},
       {"nodes", [](Parts& p) { ++p.nodes; }},
       {"time step", [](Parts& p) { nudge(p.timeStep); }},
       {"depth at the start", [](Parts& p) { nudge(p.startInside); }},
       {"tilt of the approach", [](Parts& p) { nudge(p.approachTilt); }},
       {"turn of the approach", [](Parts& p) { nudge(p.approachTurn); }},
       {"work of a step", [](Parts& p) { ++p.solver.maxEvaluations; }},
       {"tolerance of the solver", [](Parts& p) { nudge(p.solver.forceTolerance); }},
       {"gain of the prediction", [](Parts& p) { nudge(p.solver.trendGain); }}});
}

TEST(ModelFingerprint, ChangesWithWiresThatYield)
{
  using Parts = ModelParts;
  ModelParts parts = fullParts();
  electrode::Wires wires;
  wires.number = {{millimeters(1), millimeters(18)}, {1.0, 5.0}};
  wires.diameter = millimeters(0.025);
  wires.modulus = megapascals(168e3);
  wires.coupling = 0.4;
  wires.yieldStress.value = megapascals(250);
  parts.array.wires = wires;
  expectEachChangesTheFingerprint(
      parts, {{"presence of wires", [](Parts& p) { p.array.wires.reset(); }},
              {"number of wires", [](Parts& p) { nudge(p.array.wires->number.value[1]); }},
              {"diameter of a wire", [](Parts& p) { nudge(p.array.wires->diameter); }},
              {"modulus of the wires", [](Parts& p) { nudge(p.array.wires->modulus); }},
              {"coupling of the wires", [](Parts& p) { nudge(p.array.wires->coupling); }},
              {"yield stress", [](Parts& p) { nudge(p.array.wires->yieldStress.value); }}});
}

TEST(ModelFingerprint, ChangesWithRelaxation)
{
  using Parts = ModelParts;
  ModelParts parts = fullParts();
  parts.relaxation.bending = {{{0.1, seconds(1)}, {0.2, seconds(5)}}};
  parts.relaxation.film = {0.3, seconds(2)};
  expectEachChangesTheFingerprint(
      parts, {{"presence of relaxation", [](Parts& p) { p.relaxation = {}; }},
              {"a fraction", [](Parts& p) { nudge(p.relaxation.bending[0].fraction); }},
              {"a time", [](Parts& p) { nudge(p.relaxation.bending[1].time); }},
              {"fraction of the film", [](Parts& p) { nudge(p.relaxation.film.fraction); }},
              {"time of the film", [](Parts& p) { nudge(p.relaxation.film.time); }}});
}

TEST(ModelFingerprint, ChangesWithThePassage)
{
  using Parts = ModelParts;
  Parts parts = fullParts();
  parts.opening->passage = millimeters(1);
  expectEachChangesTheFingerprint(
      parts, {{"presence of a passage", [](Parts& p) { p.opening->passage = millimeters(0); }},
              {"length of the passage", [](Parts& p) { nudge(p.opening->passage); }},
              {"modulus in the passage", [](Parts& p) { nudge(p.opening->passageModulus); }},
              {"friction in the passage", [](Parts& p) { p.opening->passageFriction = 0.1; }},
              {"loss where a rib leaves it", [](Parts& p) { p.opening->ribExitLoss = 0.1; }}});
}

TEST(ModelFingerprint, ChangesWithTheSpeedsAndCoefficientsOfMeasuredFriction)
{
  const auto fingerprintWith = [](double speed, double coefficient) {
    ModelParts parts = fullParts();
    parts.friction.bySpeed =
        FrictionBySpeed({metersPerSecond(1e-3), metersPerSecond(speed)}, {0.1, coefficient});
    return fingerprintOf(parts);
  };
  const double more = 1.0 + std::numeric_limits<double>::epsilon();
  EXPECT_NE(fingerprintWith(2e-3, 0.2), fingerprintWith(2e-3 * more, 0.2));
  EXPECT_NE(fingerprintWith(2e-3, 0.2), fingerprintWith(2e-3, 0.2 * more));
}

TEST(ModelFingerprint, OfPointsChangesWithTheHapticSurface)
{
  ModelParts parts = fullParts();
  parts.kind = ModelKind::points;
  parts.nodes = publishedPoints;
  const auto scala = std::dynamic_pointer_cast<const anatomy::ScalaTympani>(parts.lumen);
  const anatomy::Surface surface = anatomy::wallSurface(*scala, 2000);
  parts.hapticSurface = std::make_shared<const anatomy::Surface>(surface);
  expectEachChangesTheFingerprint(
      parts, {{"corner of the surface",
               [&surface](ModelParts& p) {
                 anatomy::Surface changed = surface;
                 nudge(changed.points[7][2]);
                 p.hapticSurface = std::make_shared<const anatomy::Surface>(changed);
               }},
              {"kind of the model", [](ModelParts& p) { p.kind = ModelKind::rod; }},
              {"number of points", [](ModelParts& p) { ++p.nodes; }}});
}

TEST(ModelFingerprint, DoesNotChangeWithNamesAndSources)
{
  ModelParts parts = fullParts();
  const std::uint64_t before = fingerprintOf(parts);
  parts.array.name = "Another name";
  parts.array.maker = "Another maker";
  parts.array.note = "Another note";
  parts.array.stylet.provenance.source = "Another source";
  EXPECT_EQ(fingerprintOf(parts), before);
}

TEST(ModelFingerprint, OfAnEarlierRecordingIsStillTheModels)
{
  const auto model = InsertionModel::build(fullParts());
  EXPECT_NE(model->fingerprint, model->formerFingerprint);
  EXPECT_TRUE(model->hasFingerprint(model->fingerprint));
  EXPECT_TRUE(model->hasFingerprint(model->formerFingerprint));
  EXPECT_FALSE(model->hasFingerprint(model->fingerprint + 1));
}

TEST(ModelFingerprint, ChangesWithTheStrengthOfThePartition)
{
  ModelParts parts = fullParts();
  parts.partitionStrength = newtons(0.088);
  EXPECT_NE(fingerprintOf(parts), fingerprintOf(fullParts()));
  expectEachChangesTheFingerprint(
      parts, {{"strength", [](ModelParts& p) { nudge(p.partitionStrength); }}});
}

}  // namespace
}  // namespace perilymph::mechanics
