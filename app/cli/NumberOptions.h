// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Options that are whole numbers.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace perilymph::cli {

/// A check that an option is a whole number, `low` to `high`. CLI11 alone takes -5 as 2^64 - 5 and a number
/// beyond 2^64 as 2^64 - 1.
CLI::Validator wholeNumber(std::uint64_t low, std::uint64_t high);

/// Adds --seed, 0 to 2^53 - 1, which JSON holds exactly.
void addSeed(CLI::App& command, std::uint64_t& seed, const std::string& help);
void addSeeds(CLI::App& command, std::vector<std::uint64_t>& seeds, const std::string& help);
/// Adds --jobs, 1 to 256.
void addJobs(CLI::App& command, unsigned& jobs);

}  // namespace perilymph::cli
