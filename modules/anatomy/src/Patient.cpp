#include "perilymph/anatomy/Patient.h"

#include <cmath>
#include <cstdio>

namespace perilymph::anatomy {
namespace {

std::string plain(double value)
{
  char buffer[32];
  const int length = std::snprintf(buffer, sizeof buffer, "%.10g", value);
  return std::string(buffer, static_cast<std::size_t>(length));
}

/// The sentence about one length that is out of its limits; empty if it is within.
std::string complaint(const char* name, const char* key, Length value, Length low, Length high)
{
  if (value >= low && value <= high) return {};
  return std::string(name) + " (" + key + ") is " + plain(inMillimeters(value)) +
         " mm; it must be between " + plain(inMillimeters(low)) + " and " +
         plain(inMillimeters(high)) + " mm.";
}

Range inMillimeters(Length low, Length high)
{
  return {perilymph::inMillimeters(low), perilymph::inMillimeters(high)};
}

}  // namespace

PatientLimits patientLimits()
{
  PatientLimits limits;

  // Cochlear duct lengths across the literature: 25 to 45 mm (Rivas et al. 2017).
  limits.lengthLow = millimeters(25.0);
  limits.lengthHigh = millimeters(45.0);

  // Sections vary by a relative standard deviation of 9 to 15 % (Avci et al. 2014): three of the
  // larger around 1.94 x 1.85 mm, that is 1.07 to 2.81 and 1.02 to 2.68 mm, rounded outward. The
  // low end is what the 0.8 mm base of an array still enters. Reasoned, not measured.
  limits.widthLow = millimeters(1.0);
  limits.widthHigh = millimeters(3.0);
  limits.heightLow = millimeters(1.0);
  limits.heightHigh = millimeters(2.8);
  return limits;
}

Result<Patient> loadPatient(const std::filesystem::path& file)
{
  Result<TomlReader> reader = TomlReader::open(file);
  if (!reader) return reader.error();

  const PatientLimits limits = patientLimits();
  Patient patient;
  patient.label = reader->text("label", file.stem().string());
  patient.side =
      reader->choice("side", {"right", "left"}, "right") == "left" ? Side::left : Side::right;
  patient.scalaTympaniLength = millimeters(
      reader->number("st_length_mm", inMillimeters(limits.lengthLow, limits.lengthHigh)));
  patient.roundWindowWidth =
      millimeters(reader->number("rw_width_mm", inMillimeters(limits.widthLow, limits.widthHigh)));
  patient.roundWindowHeight = millimeters(
      reader->number("rw_height_mm", inMillimeters(limits.heightLow, limits.heightHigh)));

  if (const Result<Done> done = reader->finish(); !done) return done.error();
  return patient;
}

Result<Done> checkPatient(const Patient& patient)
{
  const PatientLimits limits = patientLimits();
  for (const std::string& sentence :
       {complaint("The length of the scala tympani", "st_length_mm", patient.scalaTympaniLength,
                  limits.lengthLow, limits.lengthHigh),
        complaint("The width of its section at the round window", "rw_width_mm",
                  patient.roundWindowWidth, limits.widthLow, limits.widthHigh),
        complaint("The height of its section at the round window", "rw_height_mm",
                  patient.roundWindowHeight, limits.heightLow, limits.heightHigh)})
    if (!sentence.empty()) return Error{sentence};
  return Done{};
}

}  // namespace perilymph::anatomy
