#include "perilymph/anatomy/Patient.h"

#include <cstdio>

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
// larger around 1.94 x 1.85 mm are 1.07 to 2.81 and 1.02 to 2.68 mm, rounded outward. The low end
// is what the 0.8 mm base of an array still enters. Reasoned, not measured.
constexpr Range width_mm{1.0, 3.0};
constexpr Range height_mm{1.0, 2.8};

/// The sentence about a length that is out of its limits; empty if it is within.
std::string complaint(const char* name, const char* key, Length value, Range limits_mm)
{
  if (value >= millimeters(limits_mm.low) && value <= millimeters(limits_mm.high)) return {};
  return std::string(name) + " (" + key + ") is " + plain(inMillimeters(value)) +
         " mm; it must be between " + plain(limits_mm.low) + " and " + plain(limits_mm.high) +
         " mm.";
}

}  // namespace

PatientLimits patientLimits()
{
  return {millimeters(length_mm.low), millimeters(length_mm.high), millimeters(width_mm.low),
          millimeters(width_mm.high), millimeters(height_mm.low),  millimeters(height_mm.high)};
}

Result<Patient> loadPatient(const std::filesystem::path& file)
{
  Result<TomlReader> reader = TomlReader::open(file);
  if (!reader) return reader.error();

  Patient patient;
  patient.label = reader->text("label", file.stem().string());
  patient.side =
      reader->choice("side", {"right", "left"}, "right") == "left" ? Side::left : Side::right;
  patient.scalaTympaniLength = millimeters(reader->number("st_length_mm", length_mm));
  patient.roundWindowWidth = millimeters(reader->number("rw_width_mm", width_mm));
  patient.roundWindowHeight = millimeters(reader->number("rw_height_mm", height_mm));

  if (const Result<Done> done = reader->finish(); !done) return done.error();
  return patient;
}

Result<Done> checkPatient(const Patient& patient)
{
  for (const std::string& sentence :
       {complaint("The length of the scala tympani", "st_length_mm", patient.scalaTympaniLength,
                  length_mm),
        complaint("The width of its section at the round window", "rw_width_mm",
                  patient.roundWindowWidth, width_mm),
        complaint("The height of its section at the round window", "rw_height_mm",
                  patient.roundWindowHeight, height_mm)})
    if (!sentence.empty()) return Error{sentence};
  return Done{};
}

}  // namespace perilymph::anatomy
