// SPDX-License-Identifier: BSD-3-Clause
#include "Trial.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "Energy.h"
#include "StepWorkspace.h"
#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/mechanics/advance.h"

namespace perilymph::test {
namespace {

constexpr long ticksOfOneInsertion = 20'000;
constexpr long ticksBetweenRests = 500;
// The engine ends an insertion there, as jammed and as buckled (EndDetector).
constexpr double jammedForce = 2.0;    // of the hand [N]
constexpr double buckledSlack = 4e-3;  // of the array in front of the opening [m]

std::shared_ptr<const anatomy::Lumen> lumenOf(const std::string& anatomy)
{
  if (anatomy == "mean") {
    static const auto mean = anatomy::buildMean(millimeters(1));
    if (!mean) throw std::runtime_error(mean.error().message);
    return *mean;
  }
  static const auto published = anatomy::buildPublished({}, millimeters(1));
  return published;
}

/// The rotation from one orthonormal pair to another, as a vector [rad]; small.
Eigen::Vector3d rotation(const mechanics::Drive& from, const mechanics::Drive& to)
{
  const auto half = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) -> Eigen::Vector3d {
    return 0.5 * a.cross(b);
  };
  const Eigen::Vector3d third = from.handAxis_W.cross(from.handCurl_W);
  return half(from.handAxis_W, to.handAxis_W) + half(from.handCurl_W, to.handCurl_W) +
         half(third, to.handAxis_W.cross(to.handCurl_W));
}

/// One insertion from its start.
class Book {
public:
  Book(const Setting& setting, const mechanics::InsertionModel& model, std::uint64_t seed,
       Findings& findings)
      : setting_(setting),
        model_(model),
        state_(model),
        hand_(model, setting.hand, setting.stylet, seed),
        walls_(state_.position_W.size()),
        wasTouching_(state_.position_W.size()),
        wasSliding_(state_.position_W.size()),
        findings_(findings)
  {
    last_.handPosition_W = model.startBase_W;
    last_.handAxis_W = model.startAxis_W;
    last_.handCurl_W = model.startCurl_W;
    before_ = poseNow();
  }

  /// False once a number overflowed.
  bool tick()
  {
    mechanics::Drive drive = hand_.next(state_);
    drive.coupling = setting_.coupling;
    drive.couplingStiffness = 441.0;
    drive.couplingDamping = 1.0;
    before_ = poseNow();
    for (std::size_t i = 0; i < wasTouching_.size(); ++i) {
      wasTouching_[i] = state_.normalForce[i] > 0.0;
      wasSliding_[i] = state_.isSliding[i] != 0;
    }
    mechanics::advance(model_, state_, drive);
    ++findings_.ticks;
    noteWork();
    if (!isFinite()) {
      ++findings_.notFinite;
      return false;
    }
    noteReleased();
    noteEnergy(drive);
    notePenetration();
    noteResidual();
    last_ = drive;
    isJammed_ = state_.readings.handForce_W.norm() > jammedForce;
    if (++sinceRest_ == ticksBetweenRests) noteRest();
    return true;
  }

  /// The engine ends an insertion here.
  bool isJammed() const { return isJammed_; }

private:
  /// The engine ends an insertion here, too. The trial goes on, because nothing may break in a
  /// folded array either; only how soon it settles is not promised.
  bool isBuckled() const
  {
    const double outside = model_.parts.array.length.si() - state_.readings.depth;
    return outside - (state_.base_W - model_.openingCenter_W).norm() > buckledSlack;
  }

  bool isFinite() const
  {
    if (!state_.readings.isFinite || !state_.readings.handTorque_W.allFinite()) return false;
    for (const Eigen::Vector3d& node : state_.position_W)
      if (!node.allFinite()) return false;
    return true;
  }

  ArrayPose poseNow() const
  {
    const double time = static_cast<double>(state_.tick) * model_.timeStep;
    return {state_.position_W, state_.curl_W, state_.styletWithdrawal,
            std::min(time / mechanics::releaseTime, 1.0)};
  }

  /// What the hand on the stylet does, and what was stored in an array that starts straight against
  /// its curl: both change the array's energy where the array is.
  void noteReleased()
  {
    const ArrayPose now = poseNow();
    if (now.styletWithdrawal == before_.styletWithdrawal && now.released == before_.released)
      return;
    ArrayPose changed = before_;
    changed.styletWithdrawal = now.styletWithdrawal;
    changed.released = now.released;
    released_ += elasticEnergy(model_, changed) - elasticEnergy(model_, before_);
  }

  void noteEnergy(const mechanics::Drive& drive)
  {
    const mechanics::Readings& now = state_.readings;
    byHand_ -= now.handForce_W.dot(drive.handPosition_W - last_.handPosition_W) +
               now.handTorque_W.dot(rotation(last_, drive));
    findings_.minHandEnergy = std::min(findings_.minHandEnergy, byHand_);
    findings_.minEnergy = std::min(findings_.minEnergy, byHand_ + released_);
    findings_.greatestForce = std::max(findings_.greatestForce, now.handForce_W.norm());
  }

  void notePenetration()
  {
    auto tracks = state_.track;
    const std::vector<double> reach(walls_.size(), 1e-3);
    model_.parts.lumen->nearestWall(state_.position_W, reach, tracks, walls_);
    const double onset = model_.parts.wall.lining.si();
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      const double inside = (model_.entry.origin_W - state_.position_W[i]).dot(model_.entry.out_W);
      // In the first stretch the wall is still setting in, or the rim has taken its place.
      if (!(walls_[i].isNear || state_.isBeside[i] != 0) || inside < 2.0 * model_.spacing) continue;
      // An oval section counts as it was turned when it came near, somewhere in the step.
      const double half = std::min(model_.halfWithin[i], model_.halfAcross[i]);
      // Into bone beside the opening it is pressed from outside.
      const double penetration = state_.isBeside[i] != 0 ? inside : half - walls_[i].distance;
      findings_.deepest = std::max(findings_.deepest, penetration);
      if (setting_.hasSoftMembrane) continue;
      // at the edge behind the opening the wall is softer
      const double edge = state_.isBeside[i] != 0 ? 0.0 : model_.parts.wall.edge.si();
      const double part = inside < edge ? inside / edge : 1.0;
      const double stiffness = part * part * model_.wallStiffness[i];
      const double explained = state_.normalForce[i] / stiffness + onset;
      findings_.unexplained = std::max(findings_.unexplained, penetration - explained);
    }
  }

  void noteWork()
  {
    const mechanics::Readings& now = state_.readings;
    findings_.maxEvaluations = std::max(findings_.maxEvaluations, now.evaluations);
    findings_.maxFactorizations = std::max(findings_.maxFactorizations, now.factorizations);
    settlingInARow_ = state_.isSettling && !isBuckled() ? settlingInARow_ + 1 : 0;
    if (state_.isSettling) ++findings_.settling;
    findings_.longestSettling = std::max(findings_.longestSettling, settlingInARow_);
  }

  /// Holds the hand still in two copies, one of which may work as long as it needs in every tick.
  void noteRest()
  {
    sinceRest_ = 0;
    if (isBuckled()) return;
    mechanics::InsertionState bounded = state_, full = state_;
    mechanics::InsertionModel patient = model_;
    patient.parts.solver.maxEvaluations = patient.parts.solver.maxFactorizations = 1'000'000;
    mechanics::Drive still = last_;
    still.handVelocity_W.setZero();
    const int ticks = static_cast<int>(std::lround(50e-3 / model_.timeStep));
    for (int i = 0; i < ticks; ++i) {
      mechanics::advance(model_, bounded, still);
      mechanics::advance(patient, full, still);
    }
    ++findings_.rests;
    if (bounded.isSettling) ++findings_.restsUnsettled;
    double apart = 0.0;
    for (std::size_t i = 0; i < bounded.position_W.size(); ++i)
      apart = std::max(apart, (bounded.position_W[i] - full.position_W[i]).norm());
    const double forceApart = (bounded.readings.handForce_W - full.readings.handForce_W).norm();
    if (apart > 1e-6 || forceApart > 0.1e-3) ++findings_.restsElsewhere;
    findings_.apartAtRest = std::max(findings_.apartAtRest, apart);
    findings_.forceApartAtRest = std::max(findings_.forceApartAtRest, forceApart);
  }

  void noteResidual()
  {
    bool hasToggled = false;
    for (std::size_t i = 0; i < wasTouching_.size(); ++i)
      hasToggled = hasToggled || wasTouching_[i] != (state_.normalForce[i] > 0.0) ||
                   wasSliding_[i] != (state_.isSliding[i] != 0);
    const double left = state_.readings.residual;
    findings_.iterations += state_.readings.iterations;
    if (left > 1e-3) ++findings_.unbalanced;
    if (hasToggled) {
      ++findings_.toggles;
      findings_.worstToggle = std::max(findings_.worstToggle, left);
      if (left > 1e-3) ++findings_.togglesNotConverged;
      return;
    }
    findings_.maxResidualAtRest = std::max(findings_.maxResidualAtRest, left);
    if (left > 2e-6) ++findings_.notConverged;
  }

  const Setting& setting_;
  const mechanics::InsertionModel& model_;
  mechanics::InsertionState state_;
  RandomHand hand_;
  mechanics::Drive last_;
  std::vector<anatomy::WallPoint> walls_;
  std::vector<bool> wasTouching_, wasSliding_;
  ArrayPose before_;
  long sinceRest_ = 0, settlingInARow_ = 0;
  bool isJammed_ = false;
  double byHand_ = 0.0, released_ = 0.0;  // [J]
  Findings& findings_;
};

/// Wires with half of the array's stiffness at both ends.
electrode::Wires wiresThatYieldAt(double moment, const electrode::ArrayDesign& array)
{
  electrode::Wires wires;
  wires.diameter = millimeters(0.1);
  const double d = wires.diameter.si();
  const double tip = array.bending.value.front().si(), base = array.bending.value.back().si();
  wires.number = {{millimeters(0), array.length}, {1.0, base / tip}};
  wires.modulus = Modulus::fromSi(0.5 * tip * 64.0 / (pi * d * d * d * d));
  wires.yieldStress.value = Modulus::fromSi(moment * 6.0 / (d * d * d));
  return wires;
}

}  // namespace

std::shared_ptr<const mechanics::InsertionModel> build(const Setting& setting)
{
  const auto file = findByName("array", "plugins/electrodes", setting.array);
  if (!file) throw std::runtime_error(file.error().message);
  const auto array = electrode::loadArray(*file);
  if (!array) throw std::runtime_error(array.error().message);
  mechanics::ModelParts parts;
  parts.lumen = lumenOf(setting.anatomy);
  parts.array = *array;
  parts.friction = setting.friction;
  parts.relaxation = setting.relaxation;
  if (setting.yieldMoment > 0.0) parts.array.wires = wiresThatYieldAt(setting.yieldMoment, *array);
  parts.wall.perSamplePoint = newtonsPerMeter(setting.wall);
  parts.wall.tangentialPerSamplePoint = newtonsPerMeter(setting.wall * 200.0 / 441.0);
  if (setting.isLined) parts.wall = mechanics::boneWall();
  if (setting.hasRim) parts.opening = mechanics::roundWindow();
  if (setting.hasSoftMembrane) parts.membrane = mechanics::MembraneLaw{};
  parts.nodes = setting.nodes;
  parts.timeStep = seconds(setting.timeStep);
  return mechanics::InsertionModel::build(std::move(parts));
}

Findings run(const Setting& setting, long ticks, std::uint64_t seed)
{
  const auto model = build(setting);
  RandomNumbers seeds(seed);
  Findings findings;
  findings.startsRelaxed = std::all_of(model->restCurvature.begin(), model->restCurvature.end(),
                                       [](double curvature) { return curvature == 0.0; });
  while (findings.ticks < ticks) {
    Book book(setting, *model, static_cast<std::uint64_t>(seeds.within(0.0, 1e15)), findings);
    for (long i = 0; i < ticksOfOneInsertion && findings.ticks < ticks && !book.isJammed(); ++i)
      if (!book.tick()) return findings;
  }
  findings.iterations /= static_cast<double>(std::max(1L, findings.ticks));
  return findings;
}

std::string summaryOf(const Findings& f)
{
  char line[1024];
  std::snprintf(
      line, sizeof line,
      "%ld ticks, %.2f iterations each; force up to %.3f N, penetration %.1f um, "
      "unexplained %.3f um; least energy %.3f uJ, at the hand alone %.3f uJ; "
      "unsettled %ld of %ld quiet ticks, worst %.3g mN; over 1 mN in %ld of %ld toggles, "
      "worst %.3g mN; not finite %ld; at most %d evaluations, %d factorizations; %ld "
      "settling, %ld in a row; of %ld rests %ld unsettled, %ld elsewhere, up to %.3g um and "
      "%.3g mN",
      f.ticks, f.iterations, f.greatestForce, f.deepest * 1e6, f.unexplained * 1e6,
      f.minEnergy * 1e6, f.minHandEnergy * 1e6, f.notConverged, f.ticks - f.toggles,
      f.maxResidualAtRest * 1e3, f.togglesNotConverged, f.toggles, f.worstToggle * 1e3, f.notFinite,
      f.maxEvaluations, f.maxFactorizations, f.settling, f.longestSettling, f.rests,
      f.restsUnsettled, f.restsElsewhere, f.apartAtRest * 1e6, f.forceApartAtRest * 1e3);
  return line;
}

}  // namespace perilymph::test
