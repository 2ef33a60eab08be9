#pragma once

// The files of one call: what it reads and what it writes, so that no output replaces an input, a
// recording or another output.

#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/foundation/FileIdentity.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::cli {

/// Inputs and outputs of one call, each with the option that names it. Files are compared by
/// identity: canonical path, device and inode.
class CallFiles {
public:
  /// Adds a file that is read; a name that is no existing file has nothing to lose.
  void addInput(const std::string& option, const std::filesystem::path& file);
  void addOutput(const std::string& option, const std::filesystem::path& file);
  /// Adds a recording that is written, with the files that SQLite puts beside it.
  void addRecording(const std::string& option, const std::filesystem::path& file);
  /// Adds a folder that is filled with files of these names.
  void addOutputFolder(const std::string& option, const std::filesystem::path& folder,
                       const std::vector<std::string>& names);

  /// Checks, before any work, that every output may be written and that none is an input, a
  /// recording, a read-only file or another output.
  Result<Done> check() const;

  /// Checks that no output is one of the files that a scenario was read from.
  Result<Done> checkScenarioFiles(const std::vector<std::filesystem::path>& files) const;

  /// True for a file that was added as an output.
  bool isOutput(const std::filesystem::path& file) const;

private:
  enum class Kind {
    plain,
    inFolder,   ///< Its folder is made when it is written.
    recording,  ///< Its writer refuses every existing file itself.
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

  Result<Done> checkOutput(const NamedFile& output) const;

  std::vector<NamedFile> inputs_, outputs_;
  std::vector<Folder> folders_;
};

}  // namespace perilymph::cli
