// SPDX-License-Identifier: BSD-3-Clause

// Arrays that are held bent, beside the closed forms of linear viscoelasticity.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "../mechanics/SideWall.h"
#include "../mechanics/TestRod.h"
#include "lumen/PlainLumens.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

using mechanics::RelaxationLaw;
using test::RodSpec;
using test::TestRod;

RelaxationLaw law(double fraction, double time, double otherFraction = 0.0, double otherTime = 1.0)
{
  RelaxationLaw law;
  law.bending = {{{fraction, seconds(time)}, {otherFraction, seconds(otherTime)}}};
  return law;
}

/// Fraction of a force that remains a time after its bend was made at once.
double remaining(const RelaxationLaw& law, double time)
{
  double left = 1.0;
  for (const auto& term : law.bending)
    left -= term.fraction * (1.0 - std::exp(-time / term.time.si()));
  return left;
}

RodSpec cantilever(const RelaxationLaw& relaxation = {})
{
  RodSpec spec;
  spec.length = 10e-3;
  spec.startInside = 5e-3;
  spec.nodes = 41;
  spec.relaxation = relaxation;
  return spec;
}

constexpr double gap = 0.3e-3;    // [m] of the wall from the center line
constexpr double press = 0.3e-3;  // [m] of the base beyond first contact

/// A cantilever whose tip a wall deflects, in a ramp of the given duration [s].
TestRod pressedRod(const RodSpec& spec, double ramp)
{
  TestRod rod(std::make_shared<test::SideWall>(gap), spec);
  rod.move({0.0, -(gap - spec.radius), 0.0}, 2e-3, 0.2);
  rod.move({0.0, -press, 0.0}, press / ramp);
  return rod;
}

double forceAfter(TestRod& rod, double time)
{
  rod.move({0.0, 0.0, 0.0}, 1.0, time);
  return rod.state().normalForce.back();
}

TEST(Relaxation, AfterARampIsThatOfItsMaxwellElements)
{
  TestRod elastic = pressedRod(cantilever(), 0.5);
  const double full = forceAfter(elastic, 0.5);
  for (const double ramp : {0.2, 2.0})
    for (const RelaxationLaw& relaxation : {law(0.13, 0.3, 0.28, 6.0), law(0.5, 1.0)}) {
      TestRod rod = pressedRod(cantilever(relaxation), ramp);
      double at = 0.0;
      for (const double time : {0.05, 0.3, 1.0, 4.0, 10.0}) {
        // M / kappa = B_inf + sum of g B (tau / T) (1 - e^(-T / tau)) e^(-(t - T) / tau)
        double expected = 1.0;
        for (const auto& [fraction, tau] : relaxation.bending) {
          const double decayed =
              (tau.si() / ramp) * (1.0 - std::exp(-ramp / tau.si())) * std::exp(-time / tau.si());
          expected -= fraction * (1.0 - decayed);
        }
        const double force = forceAfter(rod, time - at);
        at = time;
        EXPECT_NEAR(force, expected * full, test::tolerance(0.005, "steps of 1 ms") * full)
            << ramp << " s, then " << time << " s";
      }
    }
}

TEST(Relaxation, OfABendThatIsReleasedLeavesASetThatCreepsAway)
{
  // held until all has relaxed, then free: x = g v, and v falls with tau / (1 - g)
  constexpr double fraction = 0.4, tau = 0.5;
  TestRod rod = pressedRod(cantilever(law(fraction, tau)), 0.2);
  const auto deflection = [&rod] {
    return rod.state().position_W.back().y() - rod.state().base_W.y();
  };
  forceAfter(rod, 12.0 * tau);
  const double held = deflection();
  ASSERT_GT(held, 0.2e-3);
  rod.move({0.0, 2.0 * press, 0.0}, 50e-3, 0.05);
  double at = 0.05 + 2.0 * press / 50e-3;
  for (const double time : {0.1, 0.5, 1.0, 2.0}) {
    forceAfter(rod, time - at);
    at = time;
    const double expected = fraction * held * std::exp(-(1.0 - fraction) * time / tau);
    EXPECT_NEAR(deflection(), expected, test::tolerance(0.01, "withdrawal takes 12 ms") * held)
        << time << " s";
  }
}

/// An array pushed around a bend.
struct Insertion {
  static RodSpec spec(const RelaxationLaw& relaxation)
  {
    RodSpec spec;
    spec.startInside = 1e-3;
    spec.friction = 0.15;
    spec.relaxation = relaxation;
    return spec;
  }
  explicit Insertion(const RelaxationLaw& relaxation, double timeStep = 1e-3)
      : rod(std::make_shared<anatomy::CircularDuct>(0.45e-3, 6e-3, 2e-3),
            with(relaxation, timeStep))
  {
  }
  static RodSpec with(const RelaxationLaw& relaxation, double timeStep)
  {
    RodSpec spec = Insertion::spec(relaxation);
    spec.timeStep = timeStep;
    return spec;
  }
  void push(double distance, double speed) { rod.move({0.0, 0.0, -distance}, speed); }
  double after(double time)
  {
    rod.move({0.0, 0.0, 0.0}, 1.0, time);
    return rod.readings().axialForce;
  }

  TestRod rod;
};

TEST(RelaxingInsertion, HeldStillLosesForceAsItsBendingDoes)
{
  // the insertion takes 2 s, a small part of the time constants
  const RelaxationLaw relaxation = law(0.2, 40.0, 0.25, 400.0);
  Insertion insertion(relaxation, 5e-3);
  insertion.push(10e-3, 5e-3);
  constexpr double settled = 0.05;
  const double stopped = insertion.after(settled);
  ASSERT_GT(stopped, 25e-3) << "more than half of it is friction";
  double at = settled;
  for (const double time : {10.0, 30.0, 100.0}) {
    const double expected = stopped * remaining(relaxation, time) / remaining(relaxation, settled);
    const double force = insertion.after(time - at);
    EXPECT_NEAR(force, expected, test::tolerance(0.02, "the insertion's own time") * stopped)
        << time << " s";
    at = time;
  }
}

TEST(RelaxingInsertion, GoesOnAfterARestAsIfThereHadBeenNoneSoonAfter)
{
  const RelaxationLaw relaxation = law(0.3, 0.5);
  Insertion rested(relaxation), straight(relaxation), elastic({});
  for (Insertion* each : {&rested, &straight, &elastic}) each->push(8e-3, 2e-3);
  const double before = rested.rod.readings().axialForce;
  EXPECT_LT(rested.after(3.0), 0.95 * before);
  for (Insertion* each : {&rested, &straight, &elastic}) each->push(3e-3, 2e-3);
  const double force = straight.rod.readings().axialForce;
  EXPECT_NEAR(rested.rod.readings().axialForce, force, 0.03 * force);
  EXPECT_LT(force, 0.97 * elastic.rod.readings().axialForce) << "slow motion relaxes, too";
}

TEST(RelaxingInsertion, OfOtherStepsHasTheSameForce)
{
  const RelaxationLaw relaxation = law(0.13, 0.3, 0.28, 6.0);
  const auto forces = [&](double timeStep) {
    Insertion insertion(relaxation, timeStep);
    insertion.push(9e-3, 5e-3);
    const double moving = insertion.rod.readings().axialForce;
    const double soon = insertion.after(0.2);
    return std::vector<double>{moving, soon, insertion.after(1.8)};
  };
  const std::vector<double> fine = forces(0.25e-3);
  for (const double timeStep : {1e-3, 5e-3}) {
    const std::vector<double> coarse = forces(timeStep);
    for (std::size_t k = 0; k < fine.size(); ++k)
      EXPECT_NEAR(coarse[k], fine[k], test::tolerance(0.02, "steps of 5 ms") * fine[0])
          << timeStep << " s, " << k;
  }
}

TEST(RelaxingInsertion, MovedInAndOutGivesTheHandNoEnergy)
{
  RelaxationLaw relaxation = law(0.3, 0.2, 0.3, 2.0);
  relaxation.film = {0.5, seconds(0.3)};
  Insertion insertion(relaxation);
  double work = 0.0, minimum = 0.0;
  const auto move = [&](double distance, double speed) {
    constexpr int pieces = 400;
    for (int i = 0; i < pieces; ++i) {
      const double before = insertion.rod.readings().axialForce;
      insertion.push(distance / pieces, speed);
      work += 0.5 * (before + insertion.rod.readings().axialForce) * distance / pieces;
    }
    minimum = std::min(minimum, work);
  };
  double sum = 0.0;
  for (int loop = 0; loop < 3; ++loop) {
    move(8e-3, 10e-3);
    insertion.after(0.5);
    move(-8e-3, 10e-3);
    insertion.after(0.5);
    EXPECT_GT(work, sum) << "each loop takes energy";
    sum = work;
  }
  EXPECT_GE(minimum, -1e-6);
}

TEST(RelaxingInsertion, WithAFilmKeepsItsLevelWhileItMovesAndLosesFrictionAtRest)
{
  RelaxationLaw film;
  film.film = {0.5, seconds(0.3)};
  Insertion with(film), without({});
  for (Insertion* each : {&with, &without}) each->push(9e-3, 2e-3);
  const double moving = without.rod.readings().axialForce;
  EXPECT_NEAR(with.rod.readings().axialForce, moving, 0.02 * moving);
  const double held = without.after(3.0);
  EXPECT_NEAR(held, moving, 0.03 * moving);
  EXPECT_LT(with.after(3.0), 0.97 * held);
}

TEST(RelaxedBend, TurnsWithTheMaterial)
{
  // a set that lasts, and a hand that turns the array about its axis and tilts it
  RodSpec spec = cantilever(law(0.5, 10'000.0));
  TestRod rod(std::make_shared<anatomy::StraightTube>(50e-3), spec);
  for (double& bend : rod.state().relaxedBend[0].along) bend = 0.03;
  for (double& bend : rod.state().relaxedBend[0].across) bend = 0.01;
  rod.move({0.0, 0.0, 0.0}, 1.0, 0.3);
  const auto tip = [&rod] {
    const mechanics::Drive& drive = rod.drive();
    Eigen::Matrix3d frame;
    frame << drive.handAxis_W, drive.handCurl_W, drive.handAxis_W.cross(drive.handCurl_W);
    return Eigen::Vector3d(frame.transpose() *
                           (rod.state().position_W.back() - rod.state().base_W));
  };
  const Eigen::Vector3d before = tip();
  EXPECT_GT(before.tail<2>().norm(), 0.5e-3) << "it is bent";
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2e-3, Eigen::Vector3d(0.3, 0.4, -0.9).normalized()).toRotationMatrix();
  for (int i = 0; i < 1200; ++i) {
    rod.drive().handAxis_W = (turn * rod.drive().handAxis_W).normalized();
    Eigen::Vector3d curl = turn * rod.drive().handCurl_W;
    curl -= curl.dot(rod.drive().handAxis_W) * rod.drive().handAxis_W;
    rod.drive().handCurl_W = curl.normalized();
    rod.tick();
  }
  rod.move({0.0, 0.0, 0.0}, 1.0, 0.5);
  EXPECT_LT((tip() - before).norm(), 2e-6);
}

}  // namespace
}  // namespace perilymph
