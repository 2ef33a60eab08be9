// SPDX-License-Identifier: BSD-3-Clause
#include "scenario/ScenarioRelaxation.h"

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace perilymph::session {

namespace {

constexpr const char* fractionKey = "relaxation_fraction";
constexpr const char* timeKey = "relaxation_time_s";
constexpr const char* filmKey = "film_relaxation_fraction";
constexpr const char* filmTimeKey = "film_relaxation_time_s";

// Below ten steps of a millisecond a term is damping; above hours nothing is left of it in a session.
constexpr Range time_s{0.01, 10'000.0};
// What does not relax keeps the array in shape.
constexpr double maxOfBending = 0.95;

}  // namespace

void readRelaxation(TomlReader& reader, ScenarioKeys& keys, const InsertionParameters& parameters,
                    mechanics::RelaxationLaw& law)
{
  const bool bends = reader.has(fractionKey) || reader.has(timeKey);
  const bool hasFilm = reader.has(filmKey) || reader.has(filmTimeKey);
  if ((bends || hasFilm) && parameters.model == mechanics::ModelKind::points)
    reader.refuse(bends ? fractionKey : filmKey,
                  std::string(bends ? fractionKey : filmKey) +
                      " is given, and the published model of points does not relax. Set model to "
                      "'rod', or leave the key out.");
  if (bends) {
    const auto numbers = [&](const char* key, Range allowed) {
      const std::vector<double> values = reader.numbers(key, allowed, 1);
      keys.note(key, tomlNumbers(values));
      return values;
    };
    const std::vector<double> fractions = numbers(fractionKey, {0.0, maxOfBending});
    const std::vector<double> times = numbers(timeKey, time_s);
    const std::size_t terms = law.bending.size();
    const double sum = std::accumulate(fractions.begin(), fractions.end(), 0.0);
    if (fractions.size() != times.size() || fractions.size() > terms)
      reader.refuse(fractionKey,
                    std::string(fractionKey) + " has " + std::to_string(fractions.size()) +
                        " numbers and " + timeKey + " has " + std::to_string(times.size()) +
                        "; give as many of both, at most " + std::to_string(terms) + ".");
    else if (sum > maxOfBending)
      reader.refuse(fractionKey, std::string(fractionKey) + " adds up to " +
                                     tomlNumber(std::round(1e6 * sum) / 1e6) + "; it must be " +
                                     tomlNumber(maxOfBending) +
                                     " at most, so that the array keeps some of its bending "
                                     "stiffness.");
    else
      for (std::size_t k = 0; k < fractions.size(); ++k)
        law.bending[k] = {fractions[k], seconds(times[k])};
  }
  if (hasFilm) {
    law.film.fraction = keys.number(filmKey, {0.0, 1.0}, 0.0);
    law.film.time = seconds(keys.number(filmTimeKey, time_s, 1.0));
  }
}

}  // namespace perilymph::session
