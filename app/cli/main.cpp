// SPDX-License-Identifier: BSD-3-Clause

// perilymph-cli: all functions without a window. This file parses the call and checks its files;
// the options are in CommandOptions.cpp, the commands in separate files.

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <sstream>
#include <string>

#include "CommandOptions.h"
#include "EmptyValues.h"
#include "Interruption.h"
#include "Terminal.h"
#include "perilymph/foundation/RenamedKeys.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::cli {

namespace {

// Exit statuses that scripts rely on.
constexpr int done = 0;
constexpr int couldNot = 1;
constexpr int usageError = 2;

/// Message for a command-line error.
std::string label(const CLI::ParseError& error, const CLI::App& app, int argc, char** argv)
{
  if (argc < 2 || argv[1][0] == '-') return error.what();
  const auto isNamed = [&](const CLI::App* command) { return command->get_name() == argv[1]; };
  if (!app.get_subcommands(isNamed).empty()) return error.what();
  std::string names;
  for (const CLI::App* command : app.get_subcommands({}))
    names += (names.empty() ? "" : ", ") + command->get_name();
  return "There is no command '" + std::string(argv[1]) + "'; the commands are " + names;
}

int report(const Result<void>& result)
{
  if (result) return done;
  printError("{}\n", result.error().message);
  return couldNot;
}

int run(int argc, char** argv)
{
  CLI::App app(
      "Perilymph, the cochlear-implant insertion workstation, without its window.\n"
      "For research and training; not a medical device.",
      "perilymph-cli");
  app.set_version_flag("--version", buildId());
  app.require_subcommand(1);
  CommandOptions options;
  FileOptions fileOptions;
  addCommands(app, fileOptions, options);

  try {
    options::refuseEmptyArguments(argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help, --version
      std::ostringstream text;
      app.exit(error, text, text);
      printText(text.str());
      return done;
    }
    printError("{}. See perilymph-cli --help.\n", label(error, app, argc, argv));
    return usageError;
  }
  for (const std::string& variable : replacedByEnvironment())
    if (variable == "PERILYMPH_RESOURCES")
      printError("{} is set: shipped scenarios, cochleae, patients and arrays are those of {}.\n",
                 variable, resourceRoot().string());
  const CommandFiles files = fileOptions.filesOfCall();
  if (const auto checked = files.check(); !checked) return report(checked);
  return report(runCommand(app, files, options));
}

}  // namespace

}  // namespace perilymph::cli

int main(int argc, char** argv)
{
  using namespace perilymph;
  cli::openStandardStreams();
  cli::endOnInterruption();
  setWarningHandler([](const std::string& warning) { cli::printError("{}\n", warning); });
  // Exceeding the file size limit is handled like a full disk, instead of ending the program.
  std::signal(SIGXFSZ, SIG_IGN);
  int status = cli::couldNot;
  try {
    status = cli::run(argc, argv);
  } catch (const std::exception& error) {
    cli::printError("An internal error stopped the program: {}.\n", error.what());
  }
  const auto printed = cli::finishOutput();
  return status == cli::done && !printed ? cli::report(printed) : status;
}
