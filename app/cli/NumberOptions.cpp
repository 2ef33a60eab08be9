// SPDX-License-Identifier: BSD-3-Clause
#include "NumberOptions.h"

#include <charconv>
#include <system_error>

namespace perilymph::cli {

namespace {

const CLI::Validator& anySeed()
{
  static const CLI::Validator check = wholeNumber(0, (std::uint64_t{1} << 53) - 1);
  return check;
}

}  // namespace

CLI::Validator wholeNumber(std::uint64_t low, std::uint64_t high)
{
  const std::string range = std::to_string(low) + " to " + std::to_string(high);
  const auto problem = [low, high, range](std::string& text) -> std::string {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool isWhole = error == std::errc{} && end == text.data() + text.size();
    if (isWhole && number >= low && number <= high) return {};
    return "'" + text + "' is not a whole number from " + range;
  };
  return {problem, range};
}

void addSeed(CLI::App& command, std::uint64_t& seed, const std::string& help)
{
  command.add_option("--seed", seed, help)->capture_default_str()->check(anySeed());
}

void addSeeds(CLI::App& command, std::vector<std::uint64_t>& seeds, const std::string& help)
{
  command.add_option("--seed", seeds, help)->capture_default_str()->check(anySeed());
}

void addJobs(CLI::App& command, unsigned& jobs)
{
  command.add_option("--jobs", jobs, "Parallel runs")
      ->default_str("number of cores")
      ->check(wholeNumber(1, 256));
}

}  // namespace perilymph::cli
