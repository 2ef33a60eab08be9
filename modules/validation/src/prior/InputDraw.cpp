// SPDX-License-Identifier: BSD-3-Clause
#include "prior/InputDraw.h"

#include <algorithm>
#include <cmath>

#include "perilymph/analysis/RandomStream.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/validation/Validation.h"

namespace perilymph::validation {

namespace {

/// Purposes of random numbers, apart from those of a SpreadSource.
constexpr std::uint64_t firstInput = 300;

// The height of the ribs is declared for this passage and this modulus.
constexpr double declaredHole_mm = 1.0, declaredModulus_MPa = 2.0;
/// Half of a rib's flank: the second rib touches the opening that much before its middle [mm].
constexpr double flank_mm = 0.2;

const char* keyOf(std::size_t input)
{
  const bool isStart = input == static_cast<std::size_t>(Input::startLow) ||
                       input == static_cast<std::size_t>(Input::startHigh);
  return isStart ? "start_mm" : inputNames[input];
}

/// Height that takes as much energy as the drawn one would with the declared passage and modulus.
double ribHeight_mm(const InputValues& inputs, double carrierRadius_mm)
{
  const double declared =
      valueOf(inputs, Input::ribHeight) + carrierRadius_mm - 0.5 * declaredHole_mm;
  const double interference =
      declared * std::sqrt(declaredModulus_MPa / valueOf(inputs, Input::modulus));
  return interference + 0.5 * valueOf(inputs, Input::passageDiameter) - carrierRadius_mm;
}

}  // namespace

const std::array<const char*, inputCount> inputNames = {"start_low_mm",
                                                        "start_high_mm",
                                                        "wall_N_m",
                                                        "edges_N_m",
                                                        "modulus_MPa",
                                                        "width_factor",
                                                        "passage_diameter_mm",
                                                        "straight_mm",
                                                        "edge_radius_mm",
                                                        "first_rib_mm",
                                                        "second_rib_mm",
                                                        "rib_height_mm",
                                                        "rib_length_mm",
                                                        "stylet_N_mm2",
                                                        "stylet_end_mm",
                                                        "rib_exit_loss",
                                                        "stop_s",
                                                        "relaxation",
                                                        "knots_mm"};

Result<DeclaredRanges> loadRanges(const std::filesystem::path& file)
{
  auto reader = TomlReader::open(file);
  if (!reader) return reader.error();
  DeclaredRanges ranges;
  ranges.label = reader->text("label");
  ranges.variability = reader->text("variability");
  std::array<bool, inputCount> isRead{};
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < inputCount; ++i) keys.emplace_back(keyOf(i));
  for (TomlReader& table : reader->tables("range")) {
    const std::string input = table.choice("input", keys);
    InputRange range;
    range.low = table.number("low", {0.0, 1e6});
    range.high = table.number("high", {range.low, 1e6});
    range.isLogarithmic = table.choice("law", {"uniform", "log"}) == "log";
    if (range.isLogarithmic && !(range.low > 0.0))
      table.refuse("low", "low is 0; a logarithm needs more. Raise low, or choose uniform.");
    range.declared = table.text("declared");
    range.source = table.text("source");
    for (std::size_t i = 0; i < inputCount; ++i) {
      if (keys[i] != input) continue;
      ranges.inputs[i] = range;
      isRead[i] = true;
    }
  }
  for (std::size_t i = 0; i < inputCount; ++i)
    if (!isRead[i])
      reader->refuse("range", "The range of " + keys[i] + " is missing. Add a [[range]] for it.");
  if (const auto done = reader->finish(); !done) return done.error();
  return ranges;
}

Result<DeclaredRanges> shippedRanges()
{
  return loadRanges(resource("resources/prior-predictive/declared-ranges.toml"));
}

InputValues drawInputs(const DeclaredRanges& ranges, std::uint64_t seed, std::uint64_t number)
{
  InputValues values{};
  for (std::size_t i = 0; i < inputCount; ++i) {
    const InputRange& range = ranges.inputs[i];
    double low = range.low;
    // the second rib does not reach the opening before the end of the travel
    if (static_cast<Input>(i) == Input::secondRib)
      low = std::min(range.high, std::max(low, valueOf(values, Input::startHigh) +
                                                   inMillimeters(profileEnd()) + flank_mm));
    const double part = analysis::RandomStream(seed, number, firstInput + i).uniform();
    values[i] = range.isLogarithmic
                    ? exponential(logarithm(low) + part * logarithm(range.high / low))
                    : low + part * (range.high - low);
    if (static_cast<Input>(i) == Input::startHigh && values[i] < values[i - 1])
      std::swap(values[i], values[i - 1]);
  }
  return values;
}

session::InsertionParameters withInputs(const session::InsertionParameters& nominal,
                                        const InputValues& inputs)
{
  const auto value = [&](Input input) { return valueOf(inputs, input); };
  session::InsertionParameters parameters = nominal;
  parameters.wall.perSamplePoint = newtonsPerMeter(value(Input::wall));
  parameters.wall.rim = newtonsPerMeter(value(Input::edges));
  parameters.cochlea.leadIn = millimeters(value(Input::straight));
  parameters.cochlea.patient.roundWindowWidth =
      value(Input::width) * nominal.cochlea.patient.roundWindowWidth;
  electrode::ArrayDesign& array = parameters.array;
  array.ribsFromTip = {millimeters(value(Input::firstRib)), millimeters(value(Input::secondRib))};
  const electrode::Section carrier = array.sectionAt(array.ribsFromTip.front());
  array.ribHeight = millimeters(
      ribHeight_mm(inputs, 0.5 * inMillimeters(std::max(carrier.within, carrier.across))));
  array.ribLength = millimeters(value(Input::ribLength));
  array.stylet.bending = BendingStiffness::fromSi(1e-6 * value(Input::stylet));
  array.stylet.fromTip = millimeters(value(Input::styletEnd));
  if (!parameters.opening) return parameters;
  mechanics::Opening& opening = *parameters.opening;
  opening.width = opening.height = millimeters(value(Input::passageDiameter));
  opening.passage = parameters.cochlea.leadIn;
  opening.passageModulus = megapascals(value(Input::modulus));
  opening.edgeRadius = millimeters(value(Input::edgeRadius));
  opening.ribExitLoss = value(Input::exitLoss);
  return parameters;
}

Variability withInputs(const Variability& variability, const InputValues& inputs)
{
  Variability drawn = variability;
  drawn.startLow = millimeters(valueOf(inputs, Input::startLow));
  drawn.startHigh = millimeters(valueOf(inputs, Input::startHigh));
  drawn.knotSpacing = millimeters(valueOf(inputs, Input::knots));
  return drawn;
}

StoppedRecord stoppedRecord(const std::vector<double>& travel, const std::vector<double>& force,
                            Length end, Duration rest, double relaxation, Duration samplePeriod)
{
  StoppedRecord record;
  double atEnd = force.empty() ? 0.0 : force.back();
  for (std::size_t i = 0; i < travel.size(); ++i) {
    if (travel[i] > end.si()) {
      const double before = i > 0 ? travel[i - 1] : travel[i];
      const double part = travel[i] > before ? (end.si() - before) / (travel[i] - before) : 1.0;
      atEnd = i > 0 ? force[i - 1] + part * (force[i] - force[i - 1]) : force[i];
      break;
    }
    record.travel.push_back(travel[i]);
    record.force.push_back(force[i]);
  }
  const auto samples = static_cast<int>(std::floor(rest / samplePeriod + 1e-9));
  for (int i = 1; i <= samples; ++i) {
    const double lost = relaxation * (1.0 - exponential(-i * (samplePeriod / relaxationTime)));
    record.travel.push_back(end.si());
    record.force.push_back(atEnd * (1.0 - lost));
  }
  return record;
}

}  // namespace perilymph::validation
