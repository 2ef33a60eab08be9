// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Refusal of empty values, such as those of unset shell variables, by all programs.

#include <string>

namespace CLI {
class App;
}

namespace perilymph::options {

/// Makes every option and positional of an application and its commands refuse an empty value. Call
/// it after all of them are declared.
void refuseEmptyValues(CLI::App& app);

/// Refuses `--option=` without a value, for which CLI11 would take the next argument, and `--option ''` before
/// CLI11 looks for options that are missing: this sentence says more than that one.
///
/// @throws CLI::ConversionError
void refuseEmptyArguments(int argc, const char* const* argv);

/// The value in `key=value`.
///
/// @throws CLI::ValidationError for an empty one.
std::string settingValue(const std::string& option, const std::string& setting, std::size_t equals);

}  // namespace perilymph::options
