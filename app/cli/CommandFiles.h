// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Input and output files of one call, checked so that no output replaces an input, a recording or
// another output.

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/FileIdentity.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::cli {

/// Inputs and outputs of one call, each with its option. Files are compared by identity: canonical
/// path, device and inode.
class CommandFiles {
public:
  /// Adds a file to be read; ignored if it does not exist.
  void addInput(const std::string& option, const std::filesystem::path& file);
  /// Adds a file that is read, or a folder all of whose files are; of a DICOMDIR, its folder.
  void addInputFolder(const std::string& option, const std::filesystem::path& place);
  void addOutput(const std::string& option, const std::filesystem::path& file);
  /// Adds a recording to be written, with the files that SQLite creates beside it.
  void addRecording(const std::string& option, const std::filesystem::path& file);
  /// Adds a folder to be filled with files of these names.
  void addOutputFolder(const std::string& option, const std::filesystem::path& folder,
                       const std::vector<std::string>& names);

  /// Checks, before any work, that every output is writable and that none is an input, a recording,
  /// a read-only file or another output.
  Result<void> check() const;

  /// Checks that no output is one of the files that a scenario was read from.
  Result<void> checkScenarioFiles(const std::vector<std::filesystem::path>& files) const;

  /// True for a file added as an output.
  bool isOutput(const std::filesystem::path& file) const;

private:
  enum class Kind {
    plain,
    inFolder,   ///< Its folder is created when it is written.
    recording,  ///< Its writer refuses every existing file.
  };
  struct NamedFile {
    std::string option;
    std::filesystem::path file;
    FileIdentity identity;
    Kind kind = Kind::plain;
  };
  struct Folder {
    std::string option;
    std::filesystem::path place;
  };

  Result<void> checkOutput(const NamedFile& output) const;

  std::vector<NamedFile> inputs_, outputs_;
  std::vector<Folder> folders_, inputFolders_;
};

}  // namespace perilymph::cli
