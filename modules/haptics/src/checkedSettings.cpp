// SPDX-License-Identifier: BSD-3-Clause
#include "checkedSettings.h"

#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace perilymph::haptics {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void require(double value, double minimum, double maximum, const char* name, const char* unit)
{
  if (value >= minimum && value <= maximum) return;  // false for NaN
  std::ostringstream sentence;
  sentence << name << " is " << value << " " << unit << "; it must be between " << minimum
           << " and " << maximum << " " << unit << ".";
  throw std::invalid_argument(sentence.str());
}

}  // namespace

std::shared_ptr<const mechanics::InsertionModel> checkedModel(
    std::shared_ptr<const mechanics::InsertionModel> model)
{
  if (!model) throw std::invalid_argument("An insertion engine needs a model; it was given none.");
  return model;
}

EngineSettings checkedSettings(const EngineSettings& settings)
{
  if (settings.coupling == mechanics::Coupling::spring) {
    require(settings.couplingStiffness, 1.0, 1e5, "The coupling's stiffness", "N/m");
    require(settings.couplingDamping, 0.0, 1e3, "The coupling's damping", "N.s/m");
  }
  require(settings.maxStiffness, 1.0, infinity, "The stiffest coupling of the device", "N/m");
  require(settings.maxDamping, 0.0, infinity, "The strongest damping of the device", "N.s/m");
  require(settings.stopTravel * 1e3, 0.1, 100.0, "The travel at which an insertion stops", "mm");
  require(settings.stopForce, 0.0, maxHandForce, "The force at which an insertion stops", "N");
  require(settings.forceScale, 0.0, maxForceScale, "The scale of the force shown", "");
  require(settings.motionScale, 0.01, 10.0, "The scale of the motion", "");
  require(settings.styletSpeed * 1e3, 0.01, 1000.0, "The speed of the stylet", "mm/s");
  if (settings.styletHoldDepth)
    require(*settings.styletHoldDepth * 1e3, 0.0, 100.0, "The depth at which a stylet is held",
            "mm");
  require(settings.restAfter, 0.1, infinity, "The time after which an insertion rests", "s");
  require(settings.restMotion, 0.0, 1e-3, "The motion that ends a rest", "m");
  require(settings.restHandMotion, 0.0, 1e-3, "The motion of a hand that ends a rest", "m");
  require(settings.samplePeriod * 1e3, 0.01, 100.0, "The device's sample period", "ms");
  return settings;
}

}  // namespace perilymph::haptics
