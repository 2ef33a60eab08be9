#pragma once

// Values that are empty, as an unset variable of the shell leaves them.

#include <string>

namespace CLI {
class App;
}

namespace perilymph::cli {

/// Makes every option and positional of an application and its commands refuse an empty value. Call
/// it once all of them are declared.
void refuseEmptyValues(CLI::App& app);

/// Refuses `--option=` without a value, for which CLI11 would take the next word of the call.
///
/// @throws CLI::ConversionError
void refuseEmptyAssignments(int argc, const char* const* argv);

/// The value of `key=value` after a setting's key.
///
/// @throws CLI::ValidationError for an empty one.
std::string settingValue(const std::string& option, const std::string& setting, std::size_t equals);

}  // namespace perilymph::cli
