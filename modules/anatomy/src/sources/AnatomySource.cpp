// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/AnatomySource.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "perilymph/anatomy/MeanScala.h"
#include "sources/ClarkScala.h"

namespace perilymph::anatomy {

namespace {

using Built = Result<std::shared_ptr<const ScalaTympani>>;

Built published(const Patient& patient, Length leadIn) { return buildPublished(patient, leadIn); }

Built mean(const Patient& patient, Length leadIn)
{
  if (patient.basalTurn) return buildMean(patient.label, *patient.basalTurn, leadIn);
  return buildMean(leadIn);
}

Built clark(const Patient&, Length leadIn) { return buildClark(leadIn); }

constexpr std::array sources{
    AnatomySourceTraits{AnatomySource::published, "published", "CDL and round-window section",
                        PatientMeasures::threeLengths, true, published},
    AnatomySourceTraits{AnatomySource::mean, "mean", "Average cochlea", PatientMeasures::basalTurn,
                        false, mean},
    AnatomySourceTraits{AnatomySource::clark, "clark", "Clark’s spiral", PatientMeasures::none,
                        false, clark},
};

}  // namespace

std::span<const AnatomySourceTraits> anatomySources() { return sources; }

const AnatomySourceTraits& traitsOf(AnatomySource source)
{
  const auto* const row = std::find_if(sources.begin(), sources.end(),
                                       [&](const auto& each) { return each.source == source; });
  if (row == sources.end()) throw std::invalid_argument("The table of anatomies lacks a source.");
  return *row;
}

const char* nameOf(AnatomySource source) { return traitsOf(source).name; }

std::optional<AnatomySource> anatomySourceNamed(std::string_view name)
{
  for (const AnatomySourceTraits& row : sources)
    if (name == row.name) return row.source;
  return std::nullopt;
}

std::vector<std::string> anatomySourceNames()
{
  std::vector<std::string> names;
  for (const AnatomySourceTraits& row : sources) names.emplace_back(row.name);
  return names;
}

PatientMeasures measuresOf(const Patient& patient)
{
  return patient.basalTurn ? PatientMeasures::basalTurn : PatientMeasures::threeLengths;
}

const char* keysOf(PatientMeasures measures)
{
  switch (measures) {
    case PatientMeasures::none:
      break;
    case PatientMeasures::threeLengths:
      return "st_length_mm";
    case PatientMeasures::basalTurn:
      return "a_mm and b_mm";
  }
  return "";
}

AnatomySource sourceScaledBy(PatientMeasures measures)
{
  for (const AnatomySourceTraits& row : sources)
    if (row.takes == measures) return row.source;
  return defaultAnatomy;
}

bool isScaledBy(AnatomySource source, const Patient& patient)
{
  const AnatomySourceTraits& row = traitsOf(source);
  if (row.takes == PatientMeasures::none) return false;
  return row.alwaysTakes || row.takes == measuresOf(patient);
}

Built buildAnatomy(const Cochlea& cochlea, const std::string& name)
{
  try {
    return traitsOf(cochlea.source).build(cochlea.patient, cochlea.leadIn);
  } catch (const std::invalid_argument& error) {
    return Error{"The cochlea of %1 cannot be built: %2", name, error.what()};
  }
}

}  // namespace perilymph::anatomy
