// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The options that name files, and the files of a call.

#include <string>
#include <vector>

#include "CommandFiles.h"

namespace CLI {
class Option;
}

namespace perilymph::cli {

/// Marks options as inputs and outputs while they are declared, and collects the files of a parsed
/// call. Every option that names a file is marked here once.
class FileOptions {
public:
  /// Marks an option whose value is an input file, or a shipped name in `shippedFolder`.
  void reads(CLI::Option* option, const std::string& shippedFolder = {});
  /// Marks an option whose value is a file, or a folder all of whose files are read.
  void readsBelow(CLI::Option* option);
  /// Marks an option whose values are `key=FILE` or `key=value`.
  void readsSettings(CLI::Option* option);
  /// Marks an option whose value is an output file.
  void writes(CLI::Option* option);
  /// Marks an option whose value is a recording to be written.
  void records(CLI::Option* option);
  /// Marks an option whose value is a folder to be filled with files of these names.
  void writesInto(CLI::Option* option, const std::vector<std::string>& names);

  /// Files of the options given in the call.
  CommandFiles filesOfCall() const;

private:
  enum class Use { reads, readsBelow, readsSettings, writes, records, writesInto };
  struct Marked {
    CLI::Option* option;
    Use use;
    std::string shippedFolder;
    std::vector<std::string> names;
  };
  static void add(CommandFiles& files, const Marked& marked, const std::string& value);

  std::vector<Marked> marked_;
};

/// Names of a figure's files: SVG, and PNG if this build supports it.
std::vector<std::string> figureNames(const std::string& figure);

}  // namespace perilymph::cli
