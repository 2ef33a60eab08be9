// SPDX-License-Identifier: BSD-3-Clause
#include "EmptyValues.h"

#include <CLI/CLI.hpp>
#include <string_view>

namespace perilymph::options {

namespace {

/// Not a ValidationError, which CLI11 would prefix with the option's name again.
CLI::ConversionError emptyValue(const std::string& name)
{
  return CLI::ConversionError(name + " is empty; give it a value (is a shell variable unset?)");
}

}  // namespace

void refuseEmptyValues(CLI::App& app)
{
  for (CLI::Option* option : app.get_options()) {
    if (option->get_items_expected_max() == 0) continue;  // a flag
    const std::string name = option->get_name();
    // A transform precedes every other check of the option.
    option->transform([name](const std::string& value) -> std::string {
      if (value.empty()) throw emptyValue(name);
      return value;
    });
  }
  for (CLI::App* command : app.get_subcommands(nullptr)) refuseEmptyValues(*command);
}

void refuseEmptyArguments(int argc, const char* const* argv)
{
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i], before = argv[i - 1];
    if (word == "--") return;
    if (word.empty() && i > 1 && before.size() > 2 && before.substr(0, 2) == "--")
      throw emptyValue(std::string(before));
    if (word.size() > 3 && word.substr(0, 2) == "--" && word.find('=') == word.size() - 1)
      throw emptyValue(std::string(word.substr(0, word.size() - 1)));
  }
}

std::string settingValue(const std::string& option, const std::string& setting, std::size_t equals)
{
  if (equals + 1 == setting.size())
    throw CLI::ValidationError(option + " " + setting +
                               " is empty; give the key a value (is a shell variable unset?), or "
                               "write " +
                               option + " '" + setting + "\"\"' for an empty text");
  return setting.substr(equals + 1);
}

}  // namespace perilymph::options
