// SPDX-License-Identifier: BSD-3-Clause
#include "ModelFingerprint.h"

#include "perilymph/foundation/Hash.h"
#include "points/PointSetModel.h"

namespace perilymph::mechanics {
namespace {

// Raised whenever the solver gives the same rod other bits: 4 since the prediction of a step makes the
// Newton step that the last one left, and friction is bounded by the expected pressure.
constexpr int rodSolver = 4;
// The same of the forceps' hold: 2 since a node takes the mean of it over its segment.
constexpr int hold = 2;

// Each of these functions names all members of its type, so that it does not compile once a member
// is added.

template <class Dimension>
void add(Hash& hash, Quantity<Dimension> value)
{
  hash.add(value.si());
}

template <class Dimension>
void add(Hash& hash, const std::vector<Quantity<Dimension>>& values)
{
  hash.add(values.size());
  for (const auto value : values) add(hash, value);
}

template <class Value>
void add(Hash& hash, const electrode::AlongArray<Value>& table)
{
  const auto& [fromTip, value] = table;
  add(hash, fromTip);
  add(hash, value);
}

void add(Hash& hash, const electrode::Stylet& stylet)
{
  const auto& [fromTip, bending, residualCurvature, holdDepth, provenance, stress, diameter] =
      stylet;
  add(hash, fromTip);
  add(hash, bending);
  hash.add(residualCurvature);
  hash.add(holdDepth.has_value());
  if (holdDepth) add(hash, *holdDepth);
  if (!(stress.value.si() > 0.0)) return;  // recordings of before have none
  add(hash, stress.value);
  add(hash, diameter);
}

void add(Hash& hash, const electrode::Wires& wires)
{
  const auto& [number, diameter, modulus, coupling, stress] = wires;
  add(hash, number.fromTip);
  for (const double n : number.value) hash.add(n);
  add(hash, diameter);
  add(hash, modulus);
  hash.add(coupling);
  // the range states what is known of the stress and moves nothing
  add(hash, stress.value);
}

void add(Hash& hash, const electrode::ArrayDesign& array)
{
  // a range of the taper states what is known of it and moves nothing, nor do the contacts' kind and numbers
  const auto& [name, maker, note, length, insertable, diameter, thickness, tip, taperRange, bending,
               bendingAcross, twisting, restCurvature, contactsFromTip, contactLength, plates,
               singlePlates, makerNumbering, ribsFromTip, ribHeight, ribLength, wires, hasStylet,
               stylet, provenance] = array;
  for (const Length value : {length, insertable, contactLength, ribHeight, ribLength})
    add(hash, value);
  const auto& [tipRadius, taper] = tip;
  add(hash, tipRadius);
  add(hash, taper);
  add(hash, diameter);
  add(hash, thickness);
  add(hash, bending);
  add(hash, bendingAcross);
  hash.add(twisting.has_value());
  if (twisting) add(hash, *twisting);
  add(hash, restCurvature);
  add(hash, contactsFromTip);
  add(hash, ribsFromTip);
  // recordings of before have none, and elastic ones are a part of the stiffness
  if (array.wiresYield()) add(hash, *wires);
  hash.add(hasStylet);
  if (hasStylet) add(hash, stylet);
}

void add(Hash& hash, const FrictionLaw& law)
{
  const auto& [staticCoefficient, kineticCoefficient, stoppingCoefficient, stribeck, bySpeed] = law;
  for (const double value :
       {staticCoefficient, kineticCoefficient, stoppingCoefficient, stribeck.si()})
    hash.add(value);
  bySpeed.addTo(hash);
}

void add(Hash& hash, const RelaxationLaw& law)
{
  const auto& [bending, film] = law;
  const auto addTerm = [&hash](const MaxwellElement& term) {
    const auto& [fraction, time] = term;
    hash.add(fraction);
    add(hash, time);
  };
  for (const MaxwellElement& term : bending) addTerm(term);
  addTerm(film);
}

void add(Hash& hash, const WallLaw& law)
{
  const auto& [perSamplePoint, tangentialPerSamplePoint, lining, rim, sectionDelay, edge] = law;
  add(hash, perSamplePoint);
  add(hash, tangentialPerSamplePoint);
  add(hash, lining);
  // recordings of before have none of them
  if (rim) add(hash, *rim);
  if (sectionDelay.si() > 0.0) hash.add(sectionDelay.si());
  if (edge.si() > 0.0) add(hash, edge);
}

void add(Hash& hash, const MembraneLaw& law)
{
  const auto& [perSamplePoint, hardening] = law;
  add(hash, perSamplePoint);
  add(hash, hardening);
}

void add(Hash& hash, const Opening& opening)
{
  const auto& [width, height, edgeRadius, outward, vertical, passage, modulus, friction, loss] =
      opening;
  for (const Length value : {width, height, edgeRadius, outward, vertical}) add(hash, value);
  if (!(passage.si() > 0.0)) return;  // recordings of before have none
  add(hash, passage);
  add(hash, modulus);
  hash.add(friction.has_value());
  if (friction) hash.add(*friction);
  if (loss > 0.0) hash.add(loss);  // recordings of before have none
}

void add(Hash& hash, const SolverParameters& solver)
{
  const auto& [evaluations, factorizations, tries, force, motion, fraction, atRest, stuck, gain,
               settled, longest, slope, far, near, ratio, reduction, kept, lag, passes, renewals,
               trend] = solver;
  for (const int value : {evaluations, factorizations, tries, passes, renewals}) hash.add(value);
  for (const double value : {force, motion, fraction, atRest, stuck, gain, settled, longest, slope,
                             far, near, ratio, reduction, kept, lag, trend})
    hash.add(value);
}

void add(Hash& hash, const anatomy::Surface& surface)
{
  const auto& [points, triangles] = surface;
  hash.add(points.size());
  for (const auto& point : points)
    for (const double value : point) hash.add(value);
  for (const auto& triangle : triangles)
    for (const int corner : triangle) hash.add(corner);
}

void add(Hash& hash, const anatomy::Entry& entry)
{
  const auto& [origin_W, out_W, outward_W, vertical_W] = entry;
  for (const auto& vector : {origin_W, out_W, outward_W, vertical_W})
    for (const double value : vector) hash.add(value);
}

}  // namespace

std::uint64_t fingerprintOf(const InsertionModel& model)
{
  const auto& [lumen, array, friction, relaxation, wall, membrane, strength, opening, nodes,
               timeStep, startInside, approachTilt, approachTurn, freeLength, kind, hapticSurface,
               solver] = model.parts;
  Hash hash;
  // Derived data: constants of the program affect results through it.
  hash.add(formerFingerprintOf(model));
  add(hash, model.entry);
  for (const unsigned char isStiffer : model.stifferAcross) hash.add(isStiffer);
  // The parts themselves.
  lumen->addTo(hash);
  add(hash, array);
  add(hash, friction);
  if (kind == ModelKind::rod) hash.add(rodSolver);
  add(hash, wall);
  hash.add(membrane.has_value());
  if (membrane) add(hash, *membrane);
  hash.add(opening.has_value());
  if (opening) add(hash, *opening);
  hash.add(nodes);
  add(hash, timeStep);
  add(hash, startInside);
  add(hash, approachTilt);
  add(hash, approachTurn);
  // recordings of before have none
  if (freeLength) {
    add(hash, *freeLength);
    hash.add(hold);
  }
  if (strength.si() > 0.0) add(hash, strength);
  if (relaxation != RelaxationLaw{}) add(hash, relaxation);
  if (solver != SolverParameters{}) add(hash, solver);
  hash.add(kind);
  if (kind == ModelKind::points) add(hash, *hapticSurface);
  return hash.value();
}

std::uint64_t formerFingerprintOf(const InsertionModel& model)
{
  Hash hash;
  const auto addAll = [&hash](const std::vector<double>& values) {
    for (const double value : values) hash.add(value);
  };
  for (const Eigen::Vector3d& vector :
       {model.startBase_W, model.startAxis_W, model.startCurl_W, model.entry.origin_W,
        model.entry.out_W, model.entry.outward_W})
    for (int k = 0; k < 3; ++k) hash.add(vector[k]);
  hash.add(model.nodes);
  hash.add(model.timeStep);
  hash.add(model.spacing);
  for (const auto* values :
       {&model.fromTip, &model.radius, &model.mass, &model.drag, &model.stretching,
        &model.bendingCarrier, &model.bendingExcess, &model.twisting, &model.halfWithin,
        &model.halfAcross, &model.restCurvature, &model.wallStiffness, &model.wallTangential})
    addAll(*values);
  for (const double value :
       {model.styletBending, model.styletFromTip, model.styletResidual, model.baseMass,
        model.parts.friction.staticCoefficient, model.parts.friction.kineticCoefficient,
        model.parts.friction.stoppingCoefficient, model.parts.friction.stribeck.si(),
        model.parts.wall.lining.si(), model.parts.wall.perSamplePoint.si(),
        model.parts.wall.tangentialPerSamplePoint.si()})
    hash.add(value);
  model.parts.friction.bySpeed.addTo(hash);
  hash.add(model.membrane.has_value());
  if (model.membrane) {
    hash.add(model.parts.membrane->perSamplePoint.si());
    hash.add(model.parts.membrane->hardening.si());
  }
  hash.add(model.parts.opening.has_value());
  if (model.parts.opening) {
    const Opening& opening = *model.parts.opening;
    for (const Length value :
         {opening.width, opening.height, opening.edgeRadius, opening.outward, opening.vertical,
          model.parts.array.ribHeight, model.parts.array.ribLength})
      hash.add(value.si());
    for (const Length rib : model.parts.array.ribsFromTip) hash.add(rib.si());
  }
  if (model.points) hash.add(model.points->fingerprint);
  return hash.value();
}

}  // namespace perilymph::mechanics
