// SPDX-License-Identifier: BSD-3-Clause
#include "CommandFiles.h"

#include <algorithm>
#include <set>
#include <system_error>

#include "OutputFolder.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Unfinished.h"
#include "perilymph/session/RecordingSignature.h"

namespace perilymph::cli {

namespace fs = std::filesystem;

namespace {

/// True for a pipe, a terminal or /dev/null, which may be named twice.
bool isStream(const fs::path& file)
{
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

Error isInput(const std::string& option, const fs::path& output, const std::string& reader)
{
  return Error{option + " would replace " + output.string() + ", which " + reader +
               " reads. Give " + option + " another name."};
}

}  // namespace

void CommandFiles::addInput(const std::string& option, const fs::path& file)
{
  std::error_code ignored;
  if (fs::is_regular_file(file, ignored)) inputs_.push_back({option, file, identityOf(file)});
}

void CommandFiles::addInputFolder(const std::string& option, const fs::path& place)
{
  std::error_code ignored;
  if (fs::is_directory(place, ignored)) {
    inputFolders_.push_back({option, place});
    return;
  }
  addInput(option, place);
  const fs::path absolute = fs::absolute(place, ignored);
  if (place.filename() == "DICOMDIR") inputFolders_.push_back({option, absolute.parent_path()});
}

void CommandFiles::addOutput(const std::string& option, const fs::path& file)
{
  outputs_.push_back({option, file, identityOf(file)});
}

void CommandFiles::addRecording(const std::string& option, const fs::path& file)
{
  outputs_.push_back({option, file, identityOf(file), Kind::recording});
  for (const std::string_view ending : session::recordingCompanions) {
    const fs::path companion = file.string() + std::string(ending);
    outputs_.push_back({option, companion, identityOf(companion), Kind::recording});
  }
}

void CommandFiles::addOutputFolder(const std::string& option, const fs::path& folder,
                                   const std::vector<std::string>& names)
{
  folders_.push_back({option, folder});
  for (const std::string& name : names)
    outputs_.push_back({option, folder / name, identityOf(folder / name), Kind::inFolder});
}

Result<void> CommandFiles::checkOutput(const NamedFile& output) const
{
  for (const NamedFile& input : inputs_)
    if (isSameFile(output.identity, input.identity))
      return isInput(output.option, output.file, input.option);
  for (const Folder& folder : inputFolders_)
    if (isExistingBelow(output.file, folder.place))
      return isInput(output.option, output.file, folder.option);
  if (output.kind == Kind::recording) return {};
  if (session::isRecording(output.file))
    return Error{output.option + " would replace " + output.file.string() +
                 ", which is or belongs to a recording. Give " + output.option + " another name."};
  std::error_code ignored;
  if (output.kind != Kind::inFolder) return checkWritable(output.file);
  const bool isThere = fs::exists(fs::symlink_status(output.file, ignored));
  return isThere ? checkWritable(output.file, Links::refused) : Result<void>();
}

Result<void> CommandFiles::check() const
{
  // What killed calls left where this one writes.
  std::set<fs::path> written;
  for (const Folder& folder : folders_) written.insert(folder.place);
  for (const NamedFile& output : outputs_) written.insert(output.file.parent_path());
  for (const fs::path& folder : written) removeLeftovers(folder);
  for (const Folder& folder : folders_)
    if (const auto done = checkFolder(folder.place.string()); !done) return done.error();
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    const NamedFile& output = outputs_[i];
    if (isStream(output.file)) continue;
    for (std::size_t j = 0; j < i; ++j)
      if (isSameFile(output.identity, outputs_[j].identity))
        return Error{outputs_[j].option + " and " + output.option + " would both write " +
                     output.file.string() + ". Give each a file of its own."};
    if (const auto done = checkOutput(output); !done) return done.error();
  }
  return {};
}

Result<void> CommandFiles::checkScenarioFiles(const std::vector<fs::path>& files) const
{
  for (const fs::path& file : files) {
    const FileIdentity identity = identityOf(file);
    for (const NamedFile& output : outputs_)
      if (isSameFile(output.identity, identity))
        return isInput(output.option, output.file, "the scenario");
  }
  return {};
}

bool CommandFiles::isOutput(const fs::path& file) const
{
  const FileIdentity identity = identityOf(file);
  return std::any_of(outputs_.begin(), outputs_.end(),
                     [&](const auto& output) { return isSameFile(output.identity, identity); });
}

}  // namespace perilymph::cli
