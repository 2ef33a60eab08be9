// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/mechanics/InsertionModel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <stdexcept>
#include <string>

#include "ModelFingerprint.h"
#include "PublishedCarrier.h"
#include "contact/Mouth.h"
#include "contact/Passage.h"
#include "perilymph/anatomy/Approach.h"
#include "perilymph/foundation/Math.h"
#include "points/PointSetModel.h"

namespace perilymph::mechanics {
namespace {

// Silicone rubber with platinum wires (medium): density, and drag in perilymph (low).
constexpr double siliconeDensity = 1150.0;  // [kg/m^3]
constexpr double dragPerLength = 0.05;      // [N.s/m^2]

// Bone is 2,000 to 10,000 N/m. Upper limits (choices, low): ten times that for a rough wall; for a
// frictionless one, what a device check needs for an unyielding wall.
constexpr Stiffness stiffestWall = newtonsPerMeter(1e5);
constexpr Stiffness stiffestSmoothWall = newtonsPerMeter(1e6);

void require(bool holds, const std::string& sentence)
{
  if (!holds) throw std::invalid_argument(sentence);
}

/// With at most one decimal.
std::string rounded(double value)
{
  const long tenths = std::lround(10.0 * value);
  std::string text = std::to_string(tenths / 10);
  if (tenths % 10 != 0) text += "." + std::to_string(tenths % 10);
  return text;
}

void check(const Opening& opening, const electrode::ArrayDesign& array)
{
  const double width_mm = inMillimeters(std::min(opening.width, opening.height));
  const double tip_mm = inMillimeters(array.diameter.value.front());
  require(width_mm >= tip_mm, "The opening is " + std::to_string(width_mm) +
                                  " mm wide, and the tip of the array " + std::to_string(tip_mm) +
                                  " mm; it must be wide enough for the tip.");
  require(inMillimeters(std::max(opening.width, opening.height)) <= 10.0,
          "The opening is wider than 10 mm; a round window is 1 to 2 mm wide.");
  require(opening.edgeRadius.si() >= 0.0 && inMillimeters(opening.edgeRadius) <= 1.0,
          "The rim of the opening is rounded by " +
              std::to_string(inMillimeters(opening.edgeRadius)) + " mm; it must be 0 to 1 mm.");
  require(std::fabs(inMillimeters(opening.outward)) <= 2.0 &&
              std::fabs(inMillimeters(opening.vertical)) <= 2.0,
          "The opening's center must be within 2 mm of the entry.");
  if (!(opening.passage.si() > 0.0)) {
    require(opening.passage.si() == 0.0, "The passage of the opening is " +
                                             std::to_string(inMillimeters(opening.passage)) +
                                             " mm long; it must be 0 to 2 mm.");
    return;
  }
  require(opening.passage.si() <= longestPassage,
          "The passage of the opening is " + std::to_string(inMillimeters(opening.passage)) +
              " mm long; it must be 0 to 2 mm.");
  require(opening.width == opening.height,
          "The opening is " + std::to_string(inMillimeters(opening.width)) + " by " +
              std::to_string(inMillimeters(opening.height)) +
              " mm wide; only a round one can have a passage.");
  require(opening.passageModulus.si() > 0.0 && inMegapascals(opening.passageModulus) <= 100.0,
          "The array's modulus in the passage is " +
              std::to_string(inMegapascals(opening.passageModulus)) +
              " MPa; it must be above 0 and at most 100 MPa.");
  require(!opening.passageFriction ||
              (*opening.passageFriction >= 0.0 && *opening.passageFriction <= 2.0),
          "The coefficient of friction in the passage is " +
              std::to_string(opening.passageFriction.value_or(0.0)) + "; it must be 0 to 2.");
  require(opening.ribExitLoss >= 0.0 && opening.ribExitLoss <= 1.0,
          "A rib that leaves the passage loses " + std::to_string(opening.ribExitLoss) +
              " of its energy; it must be 0 to 1.");
}

void check(const SolverParameters& solver)
{
  require(std::min({solver.maxEvaluations, solver.maxFactorizations, solver.maxTries}) >= 2 &&
              std::min(solver.maxPasses, solver.maxIterationsToRenew) >= 0,
          "The solver has too little work in a step; it needs 2 evaluations, factorizations and "
          "tries or more.");
  for (const double value :
       {solver.forceTolerance, solver.motionTolerance, solver.motionFraction, solver.atRest,
        solver.stuck, solver.minGain, solver.settledForce, solver.longestStep,
        solver.slopeTolerance, solver.farStep, solver.nearStep, solver.goodRatio,
        solver.goodReduction, solver.keptRatio, solver.maxLag, solver.trendGain})
    require(value > 0.0 && value <= 1e3, "A tolerance of the solver is " + std::to_string(value) +
                                             "; it must be above 0 and at most 1000.");
}

void check(const RelaxationLaw& law)
{
  double sum = 0.0;
  const auto checkTerm = [](const MaxwellElement& term) {
    require(term.fraction >= 0.0 && term.fraction <= 1.0,
            "A fraction of " + std::to_string(term.fraction) + " relaxes; it must be 0 to 1.");
    require(term.time.si() >= 0.01 && term.time.si() <= 10'000.0,
            "A time constant of relaxation is " + std::to_string(term.time.si()) +
                " s; it must be 0.01 to 10000 s.");
  };
  for (const MaxwellElement& term : law.bending) {
    checkTerm(term);
    sum += term.fraction;
  }
  checkTerm(law.film);
  require(sum <= 0.95, "Relaxation takes " + std::to_string(sum) +
                           " of the bending stiffness; it must leave 0.05 of it.");
}

void check(const ModelParts& parts)
{
  require(parts.lumen != nullptr, "An insertion needs a lumen.");
  if (parts.kind == ModelKind::points) {
    require(parts.nodes >= 2 && parts.nodes <= maxPoints,
            "The array has " + std::to_string(parts.nodes) + " sample points; it must have 2 to " +
                std::to_string(maxPoints) + ".");
    require(parts.hapticSurface != nullptr, "A point set needs a haptic surface to touch.");
  }
  require(parts.kind == ModelKind::points || (parts.nodes >= 8 && parts.nodes <= maxNodes),
          "The array has " + std::to_string(parts.nodes) + " nodes; it must have 8 to " +
              std::to_string(maxNodes) + ".");
  const double step_ms = inMilliseconds(parts.timeStep);
  require(step_ms >= 0.0999 && step_ms <= 10.001,
          "The time step is " + std::to_string(step_ms) + " ms; it must be 0.1 to 10 ms.");
  require(parts.startInside < parts.array.length,
          "The array starts " + std::to_string(inMillimeters(parts.startInside)) +
              " mm inside, but only " + std::to_string(inMillimeters(parts.array.length)) +
              " mm of it are free of the tweezers.");
  const bool isRough = parts.friction.staticCoefficient > 0.0;
  const Stiffness stiffest = isRough ? stiffestWall : stiffestSmoothWall;
  for (const Stiffness wall : {parts.wall.perSamplePoint, parts.wall.tangentialPerSamplePoint})
    require(wall.si() > 0.0 && wall <= stiffest,
            "The wall's stiffness is " + std::to_string(wall.si()) +
                " N/m under a sample point; it must be above 0 and at most " +
                std::to_string(static_cast<int>(stiffest.si())) + " N/m" +
                (isRough ? ", ten times that of bone: single steps would not find their balance."
                         : " where nothing rubs."));
  require(parts.wall.lining.si() > 0.0 && inMillimeters(parts.wall.lining) <= 0.5,
          "The wall's lining is " + std::to_string(inMillimeters(parts.wall.lining)) +
              " mm thick; it must be above 0 and at most 0.5 mm.");
  require(parts.wall.rimStiffness().si() > 0.0 && parts.wall.rimStiffness() <= stiffest,
          "The rim's stiffness is " + std::to_string(parts.wall.rimStiffness().si()) +
              " N/m under a sample point; it must be above 0 and at most " +
              std::to_string(static_cast<int>(stiffest.si())) + " N/m.");
  require(parts.wall.sectionDelay.si() >= 0.0 && inMilliseconds(parts.wall.sectionDelay) <= 100.0,
          "The wall's delay for oval sections is " +
              std::to_string(inMilliseconds(parts.wall.sectionDelay)) +
              " ms; it must be 0 to 100 ms.");
  require(parts.wall.edge.si() >= 0.0 && inMillimeters(parts.wall.edge) <= 5.0,
          "The wall's edge behind the opening is " +
              std::to_string(inMillimeters(parts.wall.edge)) + " mm long; it must be 0 to 5 mm.");
  if (parts.membrane)
    require(parts.membrane->perSamplePoint.si() > 0.0 &&
                parts.membrane->perSamplePoint <= parts.wall.perSamplePoint &&
                parts.membrane->hardening.si() > 0.0,
            "The basilar membrane yields by " +
                std::to_string(parts.membrane->perSamplePoint.si()) +
                " N/m; it must be above 0, and no stiffer than the wall.");
  require(parts.partitionStrength.si() >= 0.0 && parts.partitionStrength.si() <= 2.0,
          "The strength of the cochlear partition is " +
              std::to_string(parts.partitionStrength.si()) + " N; it must be 0 to 2 N.");
  check(parts.solver);
  check(parts.relaxation);
  require(parts.relaxation == RelaxationLaw{} || parts.kind == ModelKind::rod,
          "A point set does not relax; set its fractions that relax to 0.");
  require(!parts.array.yields() || parts.kind == ModelKind::rod,
          "A point set does not yield; take the yield stress out of its array.");
  require(parts.partitionStrength.si() == 0.0 || parts.kind == ModelKind::rod,
          "A point set cannot go through the cochlear partition; set its strength to 0.");
  if (parts.opening) check(*parts.opening, parts.array);
  if (parts.freeLength)
    require(parts.freeLength->si() > 0.0, "The forceps hold the array " +
                                              std::to_string(inMillimeters(*parts.freeLength)) +
                                              " mm in front of the opening; it must be above 0.");
  const FrictionLaw& law = parts.friction;
  require(law.stoppingCoefficient >= 0.0 && law.kineticCoefficient >= law.stoppingCoefficient &&
              law.staticCoefficient >= law.kineticCoefficient && law.staticCoefficient <= 2.0,
          "Friction must rise from stopping (" + std::to_string(law.stoppingCoefficient) +
              ") over dynamic (" + std::to_string(law.kineticCoefficient) + ") to starting (" +
              std::to_string(law.staticCoefficient) + "), and be at most 2.");
}

}  // namespace

std::shared_ptr<const InsertionModel> InsertionModel::build(ModelParts parts)
{
  check(parts);
  auto model = std::make_shared<InsertionModel>();
  InsertionModel& m = *model;
  m.parts = std::move(parts);
  const electrode::ArrayDesign& array = m.parts.array;
  m.parts.lumen->prepare();
  m.entry = m.parts.lumen->entry();
  m.nodes = m.parts.nodes;
  m.timeStep = m.parts.timeStep.si();
  const double length = array.length.si();
  m.spacing = length / (m.nodes - 1);
  const auto stepOf = [&m](const MaxwellElement& term) {
    return RelaxingStep{term.fraction, m.timeStep / term.time.si()};
  };
  const RelaxationLaw& relaxation = m.parts.relaxation;
  for (std::size_t k = 0; k < m.relaxing.size(); ++k) m.relaxing[k] = stepOf(relaxation.bending[k]);
  m.film = stepOf(relaxation.film);
  m.twists = relaxation.bends() || array.yields();
  m.baseMass = publishedMass;

  m.startAxis_W = anatomy::directionOf({m.parts.approachTilt, m.parts.approachTurn}, m.entry);
  // a precurved array curls toward the modiolus, away from the outer wall
  const Eigen::Vector3d inner_W = -m.entry.outward_W;
  m.startCurl_W = (inner_W - inner_W.dot(m.startAxis_W) * m.startAxis_W).normalized();
  m.openingCenter_W = m.entry.origin_W;
  if (m.parts.opening)
    m.openingCenter_W += m.parts.opening->outward.si() * m.entry.outward_W +
                         m.parts.opening->vertical.si() * m.entry.vertical_W;
  m.startBase_W = m.openingCenter_W + (m.parts.startInside.si() - length) * m.startAxis_W;

  for (int i = 0; i < m.nodes; ++i) {
    const double fromTip = length - i * m.spacing;
    const Length place = Length::fromSi(std::max(fromTip, 0.0));
    const electrode::Section section = array.sectionAt(place);
    const double within = 0.5 * section.within.si(), across = 0.5 * section.across.si();
    const double bendingWithin = array.bending.at(place).si();
    const double bendingAcross = array.bendingAcrossAt(place).si();
    const bool isTip = i == m.nodes - 1;
    const double ownLength = isTip ? 0.5 * m.spacing : m.spacing;
    m.fromTip.push_back(place.si());
    m.radius.push_back(std::max(within, across));
    m.halfWithin.push_back(within);
    m.halfAcross.push_back(across);
    m.mass.push_back(siliconeDensity * pi * within * across * ownLength);
    m.drag.push_back(dragPerLength * ownLength);
    m.bendingCarrier.push_back(std::min(bendingWithin, bendingAcross));
    m.bendingExcess.push_back(std::fabs(bendingWithin - bendingAcross));
    m.stifferAcross.push_back(bendingAcross > bendingWithin ? 1 : 0);
    if (array.wiresYield()) {
      const electrode::Wires::Branch branches[] = {array.wires->singleAt(place),
                                                   array.wires->bundleAt(place)};
      // a study may make the whole array softer than its wires: their parts shrink with it
      const double all = branches[0].bending.si() + branches[1].bending.si();
      const double part =
          std::min(1.0, std::min(bendingWithin, bendingAcross) / std::max(all, 1e-30));
      for (std::size_t k = 0; k < m.wires.size(); ++k) {
        m.wires[k].stiffness.push_back(part * branches[k].bending.si() / m.spacing);
        m.wires[k].moment.push_back(std::max(branches[k].moment, 1e-12));
      }
    }
    m.twisting.push_back(array.twistingAt(place).si());
    m.isOval = m.isOval || within != across || bendingWithin != bendingAcross;
    m.twists = m.twists || m.isOval || array.restCurvature.at(place).si() != 0.0;
    m.restCurvature.push_back(array.restCurvature.at(place).si());
    // the rounded tip is a sample point of its own, whatever the length of its segment
    const double pressedLength = isTip ? samplePointSpacing : ownLength;
    m.wallStiffness.push_back(m.parts.wall.perSamplePoint.si() * pressedLength /
                              samplePointSpacing);
    m.wallTangential.push_back(m.parts.wall.tangentialPerSamplePoint.si() * pressedLength /
                               samplePointSpacing);
  }
  for (int i = 0; i + 1 < m.nodes; ++i) {
    // EA of a section of the same material as its EI: 4 EI / r^2, with r half the section in the
    // plane of bending
    const auto k = static_cast<std::size_t>(i);
    const double half = 0.5 * (m.halfWithin[k] + m.halfWithin[k + 1]);
    const double bending = 0.5 * (array.bending.at(Length::fromSi(m.fromTip[k])).si() +
                                  array.bending.at(Length::fromSi(m.fromTip[k + 1])).si());
    m.stretching.push_back(4.0 * bending / (half * half));
  }
  if (array.hasStylet) {
    m.styletBending = array.stylet.bending.si();
    m.styletFromTip = array.stylet.fromTip.si();
    m.styletResidual = array.stylet.residualCurvature;
  }
  const anatomy::ScalaTympani* const scala = m.parts.lumen->scala();
  m.mouthRadius = scala ? mouthRadiusOf(*scala) : std::numeric_limits<double>::infinity();
  const auto isThicker = [&m](std::size_t i) {
    return std::min(m.halfWithin[i], m.halfAcross[i]) > m.mouthRadius;
  };
  const auto nodes = std::views::iota(std::size_t{0}, m.halfWithin.size());
  if (std::ranges::none_of(nodes, isThicker))
    m.mouthRadius = std::numeric_limits<double>::infinity();
  if (scala) m.partitionRange = partitionRangeOf(*scala);
  if (m.parts.partitionStrength.si() > 0.0) {
    require(scala != nullptr, "Only the partition of a scala tympani can rupture.");
    m.partition = std::make_shared<const PartitionModel>(*scala, m.parts.partitionStrength);
  }
  if (m.parts.membrane && scala) m.membrane.emplace(*scala);
  if (m.parts.kind == ModelKind::points)
    m.points = std::make_shared<PointSetModel>(*m.parts.hapticSurface, m.nodes, m.timeStep);
  m.passage = passageOf(m);
  if (array.styletYields()) {
    m.styletMoment = array.stylet.yieldMoment();
    double curl = 0.0;
    for (std::size_t i = 0; i < m.fromTip.size(); ++i)
      if (m.fromTip[i] >= m.styletFromTip)
        curl = std::max(curl, array.bending.at(Length::fromSi(m.fromTip[i])).si() *
                                  std::fabs(m.restCurvature[i]) * (1.0 - m.styletResidual));
    const double needed_MPa = inMegapascals(array.stylet.yieldStress.value) * curl / m.styletMoment;
    require(curl <= m.styletMoment,
            "The stylet yields at " + rounded(1e6 * m.styletMoment) +
                " uN.m, and the carrier that it has to keep straight curls with " +
                rounded(1e6 * curl) + " uN.m; it needs a yield stress of " +
                rounded(std::ceil(needed_MPa)) + " MPa, or to be thicker.");
  }
  m.fingerprint = fingerprintOf(m);
  m.formerFingerprint = formerFingerprintOf(m);
  return model;
}

}  // namespace perilymph::mechanics
