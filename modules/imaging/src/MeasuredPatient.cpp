// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/MeasuredPatient.h"

#include <array>
#include <charconv>
#include <string>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Utf8.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::imaging {

namespace {

std::string fixed(double value)
{
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 3);
  return {text.data(), end.ptr};
}

/// `a_mm = 9.123  # sd 0.105, 95 % within 8.917 to 9.329`
std::string line(const char* key, const ct::Measure& measure)
{
  const auto interval = measure.interval95();
  return std::string(key) + " = " + fixed(measure.value) + "  # sd " + fixed(measure.sd()) +
         ", 95 % within " + fixed(interval[0]) + " to " + fixed(interval[1]) + "\n";
}

/// A label that TOML takes between quotation marks as it is.
std::string quotable(const std::string& text)
{
  std::string label = onOneLine(validUtf8(text));
  for (char& letter : label)
    if (letter == '"' || letter == '\\') letter = '_';
  return label;
}

std::string orUnknown(const std::string& text)
{
  return text.empty() ? "unknown" : onOneLine(text);
}

/// Names of landmarks: those that a person placed, or the others.
std::string landmarkNames(const ct::Marks& byHand, bool isByHand)
{
  std::string names;
  for (std::size_t k = 0; k < ct::markCount; ++k)
    if (byHand.points_P[k].has_value() == isByHand)
      names += (names.empty() ? "" : ", ") + std::string(nameOf(static_cast<ct::Mark>(k)));
  return names.empty() ? "none" : names;
}

}  // namespace

Result<Done> writeMeasuredPatient(const ct::CochleaMeasures& measures, const std::string& label,
                                  const std::filesystem::path& file)
{
  anatomy::Patient patient;
  patient.basalTurn = anatomy::BasalTurn{
      millimeters(measures.a.value), millimeters(measures.b.value), millimeters(measures.h.value)};
  const bool isHeightAllowed = static_cast<bool>(anatomy::checkPatient(patient));
  patient.basalTurn->h.reset();
  if (const auto done = anatomy::checkPatient(patient); !done) return done.error();

  std::string flags;
  for (const ct::Flag flag : measures.flags)
    flags += (flags.empty() ? "" : ", ") + std::string(ct::nameOf(flag));
  std::string text =
      "# Measured in a CT by perilymph " + buildId() + ", of the bony lumen's outer wall.\n";
  text += "# Series key (SHA-256): " + orUnknown(measures.provenance.seriesKey) + "\n";
  text += "# Scanner: " + orUnknown(measures.provenance.scanner) + "\n";
  text += "# Flags: " + (flags.empty() ? "none" : flags) + "\n";
  text += "# Landmarks by hand: " + landmarkNames(measures.marksByHand, true) + "\n";
  text += "# Landmarks proposed: " + landmarkNames(measures.marksByHand, false) + "\n";
  text += "label = \"" + quotable(label) + "\"\n";
  text += std::string("side = ") +
          (measures.side == anatomy::Side::left ? "\"left\"" : "\"right\"") + "\n";
  text += line("a_mm", measures.a) + line("b_mm", measures.b);
  text += (isHeightAllowed ? "" : "# beyond what a patient may have: ") + line("h_mm", measures.h);
  return writeWhole(file, text);
}

}  // namespace perilymph::imaging
