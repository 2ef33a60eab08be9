// SPDX-License-Identifier: BSD-3-Clause
#include "codec/ProfileTables.h"

#include <cmath>

#include "hid/Transport.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::device {

namespace {

constexpr long maxBytes = static_cast<long>(longestReport) - 1;
constexpr double maxBits = 8.0 * (longestReport - 1);

// Ranges of any device: wider than every known device, narrow enough to detect an error of the
// unit.
constexpr Range quantum_mm{1e-6, 10.0};
constexpr Range quantum_N{1e-6, 1.0};
constexpr Range quantum_mA{1e-3, 1000.0};
constexpr Range length_mm{1.0, 2000.0};
constexpr Range diameter_mm{1.0, 1000.0};

double radians(double angle_deg) { return angle_deg * (2.0 * pi) / 360.0; }

/// Exactly three numbers.
std::array<double, 3> three(TomlReader& table, const char* key, Range allowed)
{
  const std::vector<double> values = table.numbers(key, allowed, 3);
  if (values.size() != 3)
    table.refuse(key, std::string(key) + " has " + std::to_string(values.size()) +
                          " numbers; it must have 3, one for each axis.");
  return {values[0], values[1], values[2]};
}

/// 1 or -1 for each axis.
std::array<double, 3> signs(TomlReader& table, const char* key)
{
  std::array<double, 3> result{1.0, 1.0, 1.0};
  if (!table.has(key)) return result;
  result = three(table, key, {-1.0, 1.0});
  for (const double sign : result)
    if (sign != 1.0 && sign != -1.0)
      table.refuse(key, std::string(key) + " must hold 1 or -1 for each axis.");
  return result;
}

/// Refuses a slot outside its report.
void checkFits(TomlReader& table, const char* key, std::int64_t firstBit, std::int64_t bits,
               std::size_t bytes)
{
  const auto capacity = static_cast<std::int64_t>(8 * bytes);
  if (firstBit + bits > capacity)
    table.refuse(key, std::string(key) + " has " + std::to_string(firstBit) + "; with " +
                          std::to_string(bits) + " bits that ends behind the report's " +
                          std::to_string(capacity) + " bits.");
}

ReportSlot slot(TomlReader& table, const char* bitKey, const char* bitsKey, const VectorLayout& in,
                long fallbackBits, bool isSigned)
{
  ReportSlot result;
  result.report = in.report;
  const long first = table.integer(bitKey, 0, 8 * maxBytes, 0);
  const long bits = table.integer(bitsKey, 1, 32, fallbackBits);
  checkFits(table, bitKey, first, bits, in.bytes);
  result.bitOffset = static_cast<std::uint32_t>(first);
  result.bits = static_cast<std::uint32_t>(bits);
  result.isSigned = isSigned;
  return result;
}

VectorLayout readVector(TomlReader& table)
{
  VectorLayout layout;
  layout.report = static_cast<std::uint8_t>(table.integer("report", 0, 255, 0));
  layout.bytes = static_cast<std::size_t>(table.integer("bytes", 1, maxBytes, 1));
  layout.bits = static_cast<std::uint32_t>(table.integer("bits", 2, 32, 16));
  const auto first = wholeNumbers(table, "first_bits", 0.0, maxBits, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    checkFits(table, "first_bits", first[i], layout.bits, layout.bytes);
    layout.firstBits[i] = static_cast<std::uint32_t>(first[i]);
  }
  return layout;
}

Linkage readLinkage(TomlReader& table)
{
  Linkage linkage;
  linkage.height = 1e-3 * table.number("height_mm", {0.0, 1000.0});
  linkage.lengthB = 1e-3 * table.number("length_b_mm", length_mm);
  linkage.lengthC = 1e-3 * table.number("length_c_mm", length_mm);
  linkage.origin_B = three(table, "origin_mm", {-2000.0, 2000.0});
  for (double& coordinate : linkage.origin_B) coordinate *= 1e-3;
  linkage.countsPerTurn = three(table, "counts_per_turn", {16.0, 1e7});
  linkage.restCounts = three(table, "rest_counts", {-32768.0, 32767.0});
  const auto capstan = three(table, "capstan_mm", diameter_mm);
  const auto body = three(table, "body_mm", diameter_mm);
  const auto sign = signs(table, "signs");
  for (std::size_t i = 0; i < 3; ++i) linkage.bodyTurnsPerTurn[i] = sign[i] * capstan[i] / body[i];
  linkage.torqueConstant = three(table, "torque_constant_N_m_A", {1e-4, 10.0});
  linkage.maxCurrent = table.number("max_current_A", {0.01, 20.0});
  return linkage;
}

void readCalibration(TomlReader& table, PlainLayout& plain)
{
  plain.calibration = slot(table, "asked_bit", "asked_bits", plain.input, 16, false);
  plain.command = slot(table, "command_bit", "command_bits", plain.output, 16, true);
  plain.calibrateCommand = table.integer("command", -32768, 32767, 1);
  const auto first = wholeNumbers(table, "count_bits", 0.0, maxBits, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    checkFits(table, "count_bits", first[i], plain.input.bits, plain.output.bytes);
    plain.countsToSet[i].report = plain.output.report;
    plain.countsToSet[i].bitOffset = static_cast<std::uint32_t>(first[i]);
    plain.countsToSet[i].bits = plain.input.bits;
    plain.countsToSet[i].isSigned = true;
  }
}

/// "x", "-rz", "slider", "none": a usage of the Generic Desktop page (HID Usage Tables, page 0x01),
/// with "-" if reversed.
AxisSource readAxis(TomlReader& table, const char* key)
{
  constexpr std::array<const char*, 9> names{"x",  "y",      "z",    "rx",   "ry",
                                             "rz", "slider", "dial", "wheel"};
  constexpr std::uint16_t genericDesktop = 0x01;
  constexpr std::uint16_t firstUsage = 0x30;  // X
  std::vector<std::string> choices{"none"};
  for (const char* name : names) {
    choices.emplace_back(name);
    choices.push_back(std::string("-") + name);
  }
  AxisSource source;
  std::string word = table.choice(key, choices, "none");
  if (word == "none") return source;
  if (word.front() == '-') {
    source.sign = -1.0;
    word.erase(0, 1);
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    if (word == names[i])
      source.usage = {genericDesktop, static_cast<std::uint16_t>(firstUsage + i)};
  return source;
}

}  // namespace

std::vector<std::int64_t> wholeNumbers(TomlReader& table, const char* key, double low, double high,
                                       std::size_t count)
{
  const std::vector<double> values = table.numbers(key, {low, high}, count);
  std::vector<std::int64_t> whole;
  bool isWhole = values.size() == count;
  for (const double value : values) {
    isWhole = isWhole && value == std::floor(value);
    whole.push_back(static_cast<std::int64_t>(value));
  }
  if (!isWhole)
    table.refuse(key, std::string(key) + " must hold " + std::to_string(count) + " whole numbers.");
  whole.resize(count);
  return whole;
}

PlainLayout readPlainLayout(TomlReader& file, CodecKind kind, bool rendersForce)
{
  PlainLayout plain;
  TomlReader input = file.table("input");
  plain.input = readVector(input);
  if (kind == CodecKind::vector) {
    plain.inputQuantum = three(input, "quantum_mm", quantum_mm);
    for (double& quantum : plain.inputQuantum) quantum *= 1e-3;
  }
  if (input.has("counter_bit"))
    plain.counter = slot(input, "counter_bit", "counter_bits", plain.input, 16, false);
  if (input.has("buttons_bit"))
    plain.buttons = slot(input, "buttons_bit", "buttons", plain.input, 1, false);

  if (rendersForce) {
    TomlReader output = file.table("output");
    plain.output = readVector(output);
    const bool isVector = kind == CodecKind::vector;
    plain.outputQuantum =
        isVector ? three(output, "quantum_N", quantum_N) : three(output, "quantum_mA", quantum_mA);
    if (!isVector)
      for (double& quantum : plain.outputQuantum) quantum *= 1e-3;
  }
  if (kind == CodecKind::encoders) {
    TomlReader linkage = file.table("linkage");
    plain.linkage = readLinkage(linkage);
    if (rendersForce && file.has("calibration")) {
      TomlReader calibration = file.table("calibration");
      readCalibration(calibration, plain);
    }
  }
  return plain;
}

AxesLayout readAxesLayout(TomlReader& file, CodecKind kind)
{
  constexpr std::array<const char*, 6> keys{"x", "y", "z", "turn_x", "turn_y", "turn_z"};
  AxesLayout layout;
  TomlReader table = file.table("axes");
  const std::string motion = table.choice("motion", {"place", "rate"});
  const bool isPlace = motion == "place";
  layout.motion = isPlace ? AxesLayout::Motion::place : AxesLayout::Motion::rate;
  bool shifts = false;
  bool turns = false;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    layout.axes[i] = readAxis(table, keys[i]);
    if (layout.axes[i].usage.page != 0) (i < 3 ? shifts : turns) = true;
  }
  if (!shifts)
    table.refuse("motion", "[axes] moves nothing; give x, y or z the name of a device's axis.");
  if (isPlace) {
    layout.travel = 1e-3 * table.number("travel_mm", {0.1, 500.0});
    if (turns) layout.turn = radians(table.number("turn_deg", {0.1, 180.0}));
  } else {
    layout.speed = 1e-3 * table.number("speed_mm_s", {0.1, 1000.0});
    if (turns) layout.turnSpeed = radians(table.number("turn_deg_s", {0.1, 720.0}));
  }
  if (!isPlace && kind == CodecKind::pid)
    table.refuse("motion",
                 "motion is \"rate\"; it must be \"place\" where a force is rendered, because the "
                 "force belongs to a place.");
  layout.deadZone = table.number("dead_zone", {0.0, 0.5}, 0.0);
  layout.fullCounts = table.integer("full_counts", 0, 1L << 30, 0);
  return layout;
}

PidLayout readPidLayout(TomlReader& file, const AxesLayout& axes)
{
  PidLayout pid;
  TomlReader table = file.table("pid");
  using Effects = PidLayout::Effects;
  static constexpr std::array names{Choice<Effects>{Effects::axes, "axes"},
                                    Choice<Effects>{Effects::polar, "polar"},
                                    Choice<Effects>{Effects::direction, "direction"}};
  pid.effects = table.choice("effects", names);
  if (pid.effects == Effects::polar) {
    pid.directions = three(table, "directions_deg", {0.0, 360.0});
    for (double& direction : pid.directions) direction = radians(direction);
  }
  pid.signs = signs(table, "signs");
  pid.gain = table.number("gain_fraction", {0.01, 1.0}, 1.0);
  pid.resetFirst = table.flag("reset_first", true);

  if (pid.effects == Effects::polar)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = i + 1; j < 3; ++j) {
        const bool areMoved = axes.axes[i].usage.page != 0 && axes.axes[j].usage.page != 0;
        const double apart =
            std::fabs(std::remainder(pid.directions[i] - pid.directions[j], 2.0 * pi));
        const double opposite = pi - apart;
        if (areMoved && std::min(apart, opposite) < radians(1.0))
          table.refuse("directions_deg",
                       "directions_deg gives two axes the same line, so that their forces would "
                       "push the same way. Give each moved axis a line of its own, or use effects "
                       "= \"axes\".");
      }

  int moved = 0;
  for (std::size_t i = 0; i < 3; ++i) moved += axes.axes[i].usage.page != 0 ? 1 : 0;
  if (pid.effects == Effects::direction && moved != 2)
    table.refuse("effects", "effects is \"direction\"; with " + std::to_string(moved) +
                                " axes it must be \"axes\" or \"polar\": one effect that turns "
                                "needs exactly 2.");
  return pid;
}

}  // namespace perilymph::device
