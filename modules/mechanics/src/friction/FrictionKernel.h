// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Stick and slip by return mapping of a friction spring, of one node or of four.

#include "lanes/Flags.h"
#include "lanes/Lanes.h"
#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::mechanics {

/// FrictionStep of each lane; its flag is a number.
template <class T>
struct FrictionStepOf {
  Triple<T> force_W, spring_W;
  T isSliding{};
  Triple<T> direction_W;
  T across{}, along{};
};

/// Friction of each lane.
template <class T>
struct FrictionOf {
  FrictionStepOf<T> plain, film;
};

/// SlipBefore of each lane; its flag is a number.
template <class T>
struct SlipBeforeOf {
  T isSliding, speed;
};

/// Largest friction of a node, and its derivative by the stretch of the spring.
template <class T>
struct FrictionLimit {
  T force;   ///< [N]
  T rise{};  ///< [N/m]
};

/// FrictionLaw::sliding() without measured points, of each lane.
template <class T>
PERILYMPH_IN_LANES T slidingByCurve(const FrictionLaw& law, const T& speed) noexcept
{
  const T fast = speed / law.stribeck.si();
  return law.kineticCoefficient +
         (law.staticCoefficient - law.kineticCoefficient) / (1.0 + fast * fast);
}

/// With the coefficient mu(v) + mu'(v) (u - v) at the speed u of the spring's end, u = (s - L / k) /
/// dt for the stretch s and the friction L.
template <class T>
PERILYMPH_IN_LANES FrictionLimit<T> limitAt(const T& stretch, const T& normal, const T& stiffness,
                                            const SlipBeforeOf<T>& before, const FrictionLaw& law,
                                            double timeStep) noexcept
{
  const auto slid = before.isSliding == yes;
  const T atRest = law.staticCoefficient * normal;
  if (!inAny(slid)) return {atRest};
  if (law.bySpeed.isEmpty())
    return {oneOf(slid, T(slidingByCurve(law, before.speed) * normal), atRest)};
  const T coefficient = laneByLane(before.isSliding, before.speed, [&](double is, double speed) {
    return is == yes ? law.sliding(speed) : law.staticCoefficient;
  });
  const T rate = laneByLane(before.isSliding, before.speed, [&](double is, double speed) {
    return is == yes ? law.rise(speed) : 0.0;
  });
  const T force = coefficient * normal;
  const T slope = rate * normal / timeStep;
  const auto isRising = slope > 0.0;
  if (!inAny(isRising)) return {force};
  const T weight = 1.0 / (1.0 + slope / stiffness);
  const T rising = weight * (force + slope * (stretch - timeStep * before.speed));
  const T low = law.bySpeed.minimum() * normal, high = law.bySpeed.maximum() * normal;
  const auto isWithin = ((rising < low) == 0) & ((rising > high) == 0);
  const T bounded = oneOf(rising < low, low, oneOf(rising > high, high, rising));
  return {oneOf(isRising, bounded, force), oneOf(isRising & isWithin, T(weight * slope), T{})};
}

/// frictionStep() of each lane.
template <class T>
PERILYMPH_IN_LANES FrictionStepOf<T> frictionStepAt(const Triple<T>& stretch_W, const T& normal,
                                                    const T& stiffness,
                                                    const SlipBeforeOf<T>& before,
                                                    const FrictionLaw& law,
                                                    double timeStep) noexcept
{
  const T length = root(dot(stretch_W, stretch_W));
  const T trial = stiffness * length;
  const FrictionLimit<T> limit = limitAt(length, normal, stiffness, before, law, timeStep);
  const auto sticks = trial <= limit.force;
  const auto wasFast = trial > law.stoppingCoefficient * normal;

  FrictionStepOf<T> step;
  step.force_W = T(-stiffness) * stretch_W;
  step.spring_W = stretch_W;
  step.isSliding = oneOf(wasFast, before.isSliding, T{});
  step.across = stiffness;
  if (inAll(sticks)) return step;
  // slides: the spring keeps what the friction cone allows, the rest is dissipated
  const Triple<T> direction_W{stretch_W.x / length, stretch_W.y / length, stretch_W.z / length};
  step.force_W = oneOf(sticks, step.force_W, T(-limit.force) * direction_W);
  step.spring_W = oneOf(sticks, stretch_W, T(limit.force / stiffness) * direction_W);
  step.isSliding = oneOf(sticks, step.isSliding, T(T{} + yes));
  step.direction_W = oneOf(sticks, Triple<T>{}, direction_W);
  step.across = oneOf(sticks, stiffness, T(limit.force / length));
  step.along = oneOf(sticks, T{}, limit.rise);
  return step;
}

/// frictionWithFilm() of each lane.
template <class T>
PERILYMPH_IN_LANES FrictionOf<T> frictionWithFilmAt(
    const Triple<T>& stretch_W, const Triple<T>& film_W, const T& normal, const T& stiffness,
    const SlipBeforeOf<T>& before, const FrictionLaw& law, const InsertionModel& model) noexcept
{
  const auto& [fraction, ratio] = model.film;
  if (!(fraction > 0.0))
    return {frictionStepAt(stretch_W, normal, stiffness, before, law, model.timeStep), {}};
  const double plain = 1.0 - fraction, kept = 1.0 / (1.0 + ratio);
  FrictionOf<T> friction;
  friction.film = frictionStepAt(film_W, T(fraction * normal), T(kept * fraction * stiffness),
                                 before, law, model.timeStep);
  friction.film.spring_W = (T{} + kept) * friction.film.spring_W;
  if (plain > 0.0)
    friction.plain = frictionStepAt(stretch_W, T(plain * normal), T(plain * stiffness), before, law,
                                    model.timeStep);
  else
    friction.plain.isSliding = friction.film.isSliding;
  return friction;
}

}  // namespace perilymph::mechanics
