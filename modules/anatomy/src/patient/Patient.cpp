// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/Patient.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "perilymph/anatomy/Population.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/foundation/Utf8.h"

namespace perilymph::anatomy {
namespace {

std::string plain(double value)
{
  char buffer[32];
  const int length = std::snprintf(buffer, sizeof buffer, "%.10g", value);
  return std::string(buffer, static_cast<std::size_t>(length));
}

// Cochlear duct lengths across the literature (Rivas et al. 2017).
constexpr Range length_mm{25.0, 45.0};

// Sections vary by a relative standard deviation of 9 to 15 % (Avci et al. 2014): three of the
// larger around 1.94 x 1.85 mm are 1.07 to 2.81 and 1.02 to 2.68 mm, rounded outward. The lower
// limit still admits the 0.8 mm base of an array. Reasoned, not measured.
constexpr Range width_mm{1.0, 3.0};
constexpr Range height_mm{1.0, 2.8};

// Standard deviations from the mean from which a measure is unusual: 5 % of a normal population.
constexpr double unusualFrom = 2.0;

constexpr std::size_t maxCodeLength = 24;  // as much as a table and a file name show whole

bool isCodeCharacter(char c)
{
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
}

/// The text on one line, quoted for TOML.
std::string quoted(const std::string& text)
{
  std::string inside;
  for (const char c : onOneLine(text)) {
    if (c == '"' || c == '\\') inside += '\\';
    inside += c;
  }
  return '"' + inside + '"';
}

/// To nine decimals, as a TOML float.
std::string decimals(double value)
{
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.9f", value);
  std::string text(digits);
  while (text.back() == '0' && text[text.size() - 2] != '.') text.pop_back();
  return text;
}

/// `key = value` in millimeters, to a picometer.
std::string line(const char* key, Length value)
{
  return std::string(key) + " = " + decimals(inMillimeters(value)) + '\n';
}

/// The error for a length out of its limits; empty if it is within.
Sentence complaint(const Sentence& name, const char* key, Length value, Range limits_mm)
{
  if (value >= millimeters(limits_mm.low) && value <= millimeters(limits_mm.high)) return {};
  return Sentence{"%1 (%2) is %3 mm; it must be between %4 and %5 mm.",
                  name,
                  key,
                  plain(inMillimeters(value)),
                  plain(limits_mm.low),
                  plain(limits_mm.high)};
}

Range rangeOf(const Spread& spread)
{
  return {inMillimeters(spread.low), inMillimeters(spread.high)};
}

std::string rounded(Length value)
{
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2f", inMillimeters(value));
  return buffer;
}

/// "10.7 mm, 3.4 standard deviations above the mean of 9.23 mm (SD 0.43, n = 138)"
Sentence place(Length value, const Spread& spread)
{
  const double off = (value - spread.mean) / spread.standardDeviation;
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.1f", std::fabs(off));
  return Sentence{
      "%1 mm, %2 standard deviations %3 the mean of %4 mm (SD %5, n = 138, Pietsch et al. 2017)",
      plain(inMillimeters(value)),
      buffer,
      off < 0.0 ? Sentence{"below"} : Sentence{"above"},
      rounded(spread.mean),
      rounded(spread.standardDeviation)};
}

/// The error for a diameter outside the population; empty if it is within.
Sentence complaint(const Sentence& name, Length value, const Spread& spread)
{
  if (value >= spread.low && value <= spread.high) return {};
  return Sentence{"%1 is %2; it must be between %3 and %4 mm. Measure again.", name,
                  place(value, spread), rounded(spread.low), rounded(spread.high)};
}

Result<void> checkBasalTurn(const BasalTurn& turn)
{
  for (const Sentence& sentence : {complaint(Sentence{"A (a_mm)"}, turn.a, spreadOfA()),
                                   complaint(Sentence{"B (b_mm)"}, turn.b, spreadOfB())})
    if (!sentence.empty()) return Error{sentence};
  if (turn.b > turn.a)
    return Error{
        "B (b_mm) is %1 mm and A (a_mm) %2 mm; A is the longer of the two. Exchange them "
        "or measure again.",
        plain(inMillimeters(turn.b)), plain(inMillimeters(turn.a))};
  if (turn.h) {
    const Sentence sentence =
        complaint(Sentence{"The height H"}, "h_mm", *turn.h, rangeOf(limitsOfH()));
    if (!sentence.empty()) return Error{sentence};
  }
  return {};
}

/// Keys of the correlations of errors in a patient file.
struct CorrelationKey {
  const char* key;
  double BasalTurnErrors::*correlation;
};
constexpr CorrelationKey correlationKeys[] = {{"ab_correlation", &BasalTurnErrors::ab},
                                              {"ah_correlation", &BasalTurnErrors::ah},
                                              {"bh_correlation", &BasalTurnErrors::bh}};

// Larger errors would leave no measurement: A and B are 5 to 11 mm.
constexpr Range error_mm{0.0, 2.0};

Result<void> checkErrors(const BasalTurnErrors& errors)
{
  for (const Sentence& sentence :
       {complaint(Sentence{"The standard deviation of A"}, "a_sd_mm", errors.a, error_mm),
        complaint(Sentence{"The standard deviation of B"}, "b_sd_mm", errors.b, error_mm),
        complaint(Sentence{"The standard deviation of H"}, "h_sd_mm", errors.h.value_or(Length()),
                  error_mm)})
    if (!sentence.empty()) return Error{sentence};
  for (const auto& [key, correlation] : correlationKeys)
    if (!(std::fabs(errors.*correlation) < 1.0))
      return Error{"The correlation of two errors (%1) is %2; it must be between -1 and 1.", key,
                   plain(errors.*correlation)};
  // the determinant of the correlation matrix
  if (!(1.0 + 2.0 * errors.ab * errors.ah * errors.bh - errors.ab * errors.ab -
            errors.ah * errors.ah - errors.bh * errors.bh >
        0.0))
    return Error{
        "The correlations of the errors of A, B and H (ab_correlation, ah_correlation, "
        "bh_correlation) contradict each other: no three errors have them. Check them."};
  return {};
}

/// Keys of the origin of measures in a patient file.
struct OriginKey {
  const char* key;
  std::string MeasurementOrigin::*text;
};
constexpr OriginKey originKeys[] = {{"measured_with", &MeasurementOrigin::software},
                                    {"series_sha256", &MeasurementOrigin::seriesKey},
                                    {"landmarks_by_hand", &MeasurementOrigin::landmarksByHand},
                                    {"landmarks_proposed", &MeasurementOrigin::landmarksProposed}};

/// In the place of the seal of measures that were changed: no hash, so that it never holds.
constexpr const char* noSeal = "changed by hand";

/// What the seal of a patient is over: every value, to a picometer.
std::string contentText(const Patient& patient)
{
  std::string text =
      "label = " + quoted(patient.label) + "\nside = " + quoted(nameOf(patient.side)) + '\n';
  if (!patient.basalTurn)
    return text + line("st_length_mm", patient.scalaTympaniLength) +
           line("rw_width_mm", patient.roundWindowWidth) +
           line("rw_height_mm", patient.roundWindowHeight);
  text += line("a_mm", patient.basalTurn->a) + line("b_mm", patient.basalTurn->b);
  if (patient.basalTurn->h) text += line("h_mm", *patient.basalTurn->h);
  if (const auto& errors = patient.errors) {
    text += line("a_sd_mm", errors->a) + line("b_sd_mm", errors->b);
    if (errors->h) text += line("h_sd_mm", *errors->h);
    for (const auto& [key, correlation] : correlationKeys)
      if (const double value = (*errors).*correlation; value != 0.0)
        text += std::string(key) + " = " + decimals(value) + '\n';
  }
  for (const auto& [key, origin] : originKeys)
    if (!(patient.origin.*origin).empty())
      text += std::string(key) + " = " + quoted(patient.origin.*origin) + '\n';
  return text;
}

std::string sealOver(const Patient& patient)
{
  Sha256 hash;
  hash.add(std::string_view(contentText(patient)));
  return hash.hex();
}

/// What a patient's seal, empty if there is none, says of the values beside it. A series that no
/// program measured in is of no file that a program wrote.
Seal sealIn(const Patient& patient, const std::string& seal)
{
  if (!seal.empty()) return seal == sealOver(patient) ? Seal::intact : Seal::changed;
  const MeasurementOrigin& origin = patient.origin;
  const bool hasToBe =
      hasToBeSealed(origin.software) || (origin.software.empty() && !origin.seriesKey.empty());
  return hasToBe ? Seal::changed : Seal::absent;
}

/// Reads the errors of A, B and optionally H; empty if there are none.
std::optional<BasalTurnErrors> readErrors(TomlReader& reader)
{
  if (!reader.has("a_sd_mm") && !reader.has("b_sd_mm") && !reader.has("h_sd_mm"))
    return std::nullopt;
  BasalTurnErrors errors;
  errors.a = millimeters(reader.number("a_sd_mm", error_mm));
  errors.b = millimeters(reader.number("b_sd_mm", error_mm));
  if (reader.has("h_sd_mm")) errors.h = millimeters(reader.number("h_sd_mm", error_mm));
  for (const auto& [key, correlation] : correlationKeys)
    if (reader.has(key)) errors.*correlation = reader.number(key, {-1.0, 1.0});
  return errors;
}

/// Reads A, B and optionally H. Accepts any measurable value; the population limits are checked
/// later.
BasalTurn readBasalTurn(TomlReader& reader)
{
  for (const char* key : {"st_length_mm", "rw_width_mm", "rw_height_mm"})
    if (reader.has(key))
      reader.refuse(key, std::string(key) +
                             " stands beside a_mm, b_mm or h_mm; give either those or the three "
                             "lengths st_length_mm, rw_width_mm and rw_height_mm.");
  constexpr Range diameter_mm{1.0, 20.0};
  BasalTurn turn;
  turn.a = millimeters(reader.number("a_mm", diameter_mm));
  turn.b = millimeters(reader.number("b_mm", diameter_mm));
  if (reader.has("h_mm")) turn.h = millimeters(reader.number("h_mm", rangeOf(limitsOfH())));
  return turn;
}

}  // namespace

PatientLimits patientLimits()
{
  return {millimeters(length_mm.low), millimeters(length_mm.high), millimeters(width_mm.low),
          millimeters(width_mm.high), millimeters(height_mm.low),  millimeters(height_mm.high)};
}

namespace {

Result<Patient> readPatient(Result<TomlReader> reader, const std::string& label)
{
  if (!reader) return reader.error();

  Patient patient;
  patient.label = onOneLine(reader->text("label", label));
  patient.side = reader->choice("side", sides, Side::right);
  if (reader->has("a_mm") || reader->has("b_mm") || reader->has("h_mm")) {
    patient.basalTurn = readBasalTurn(*reader);
    patient.errors = readErrors(*reader);
    for (const auto& [key, text] : originKeys)
      patient.origin.*text = onOneLine(reader->text(key, ""));
  } else {
    patient.scalaTympaniLength = millimeters(reader->number("st_length_mm", length_mm));
    patient.roundWindowWidth = millimeters(reader->number("rw_width_mm", width_mm));
    patient.roundWindowHeight = millimeters(reader->number("rw_height_mm", height_mm));
  }

  const std::string seal = reader->text(sealKey, "");
  if (const Result<void> done = reader->finish(); !done) return done.error();
  patient.seal = sealIn(patient, seal);
  if (const Result<void> done = checkPatient(patient); !done)
    return Error{"%1: %2", reader->name(), done.error().message};
  return patient;
}

}  // namespace

Result<Patient> loadPatient(const std::filesystem::path& file)
{
  return readPatient(TomlReader::open(file), file.stem().string());
}

Result<Patient> patientIn(const std::string& text, const std::string& name)
{
  return readPatient(TomlReader::parse(text, name), name);
}

std::string patientText(const Patient& patient)
{
  const std::string text = contentText(patient);
  if (patient.seal == Seal::absent) return text;
  const std::string seal = patient.seal == Seal::intact ? sealOver(patient) : std::string(noSeal);
  return text + sealKey + " = " + quoted(seal) + '\n';
}

std::string statedSeries(const Patient& patient)
{
  return patient.seal == Seal::changed ? std::string() : patient.origin.seriesKey;
}

bool isFromCt(const Patient& patient)
{
  return patient.seal != Seal::changed &&
         !(patient.origin.seriesKey.empty() && patient.origin.software.empty());
}

Result<void> savePatient(const Patient& patient, const std::filesystem::path& file)
{
  return writeWhole(file, patientText(patient), {Links::followed, Audience::owner});
}

Result<void> checkPatient(const Patient& patient)
{
  if (patient.basalTurn && patient.errors)
    if (const auto done = checkErrors(*patient.errors); !done) return done;
  if (patient.basalTurn) return checkBasalTurn(*patient.basalTurn);
  for (const Sentence& sentence :
       {complaint(Sentence{"The length of the scala tympani"}, "st_length_mm",
                  patient.scalaTympaniLength, length_mm),
        complaint(Sentence{"The width of its section at the round window"}, "rw_width_mm",
                  patient.roundWindowWidth, width_mm),
        complaint(Sentence{"The height of its section at the round window"}, "rw_height_mm",
                  patient.roundWindowHeight, height_mm)})
    if (!sentence.empty()) return Error{sentence};
  return {};
}

Result<void> checkPatientCode(const std::string& code)
{
  const bool isPlain = std::all_of(code.begin(), code.end(), isCodeCharacter);
  if (isPlain && !code.empty() && code.size() <= maxCodeLength) return {};
  return Error{
      "'%1' cannot be a patient code; use 1 to %2 letters A to Z, digits and hyphens, such as "
      "P-017, and no name.",
      code, maxCodeLength};
}

Result<Patient> samplePatient(std::uint64_t seed)
{
  const HalfDiameters half = sampleHalfDiameters(seed);
  Patient patient;
  patient.label = "sample " + std::to_string(seed);
  patient.basalTurn = BasalTurn{half.a(), half.b(), std::nullopt};
  // one in ten thousand samples is outside the allowed range
  if (const auto done = checkPatient(patient); !done)
    return Error{"The cochlea drawn with seed %1 is out of limits: %2 Use another seed.", seed,
                 done.error().message};
  return patient;
}

Result<Patient> samplePatient(std::uint64_t studySeed, std::uint64_t number)
{
  // above the largest number of virtual patients (choice, high)
  constexpr std::uint64_t seedStride = 1'000'003;
  return samplePatient(studySeed * seedStride + number);
}

std::vector<Sentence> unusualMeasures(const Patient& patient)
{
  std::vector<Sentence> sentences;
  if (!patient.basalTurn) return sentences;
  const auto look = [&sentences](const char* name, Length value, const Spread& spread) {
    if (std::fabs((value - spread.mean) / spread.standardDeviation) >= unusualFrom)
      sentences.push_back(Sentence{"%1 is %2. Check the measurement.", name, place(value, spread)});
  };
  look("A", patient.basalTurn->a, spreadOfA());
  look("B", patient.basalTurn->b, spreadOfB());
  if (const Spread given = expectedB(patient.basalTurn->a);
      sentences.empty() &&
      std::fabs((patient.basalTurn->b - given.mean) / given.standardDeviation) >= unusualFrom)
    sentences.push_back(Sentence{
        "A and B do not match: with A %1 mm, B is usually %2 mm (SD %3, Pietsch et al. 2017), not "
        "%4 mm. Check both measurements.",
        plain(inMillimeters(patient.basalTurn->a)), rounded(given.mean),
        rounded(given.standardDeviation), plain(inMillimeters(patient.basalTurn->b))});
  const Spread limits = limitsOfH();
  if (const auto& h = patient.basalTurn->h; h && (*h < limits.low || *h > limits.high))
    sentences.push_back(Sentence{
        "H is %1 mm; cochleae have %2 to %3 mm (Medan; Erixon 2009). Check the measurement.",
        plain(inMillimeters(*h)), plain(inMillimeters(limits.low)),
        plain(inMillimeters(limits.high))});
  return sentences;
}

}  // namespace perilymph::anatomy
