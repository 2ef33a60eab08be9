// SPDX-License-Identifier: BSD-3-Clause
#include "FileOptions.h"

#include <CLI/CLI.hpp>

#include "perilymph/foundation/Resources.h"

namespace perilymph::cli {

namespace {

/// The content of a TOML string; any other value unchanged.
std::string unquoted(const std::string& value)
{
  const bool isQuoted = value.size() >= 2 && (value.front() == '"' || value.front() == '\'') &&
                        value.back() == value.front();
  return isQuoted ? value.substr(1, value.size() - 2) : value;
}

}  // namespace

void FileOptions::reads(CLI::Option* option, const std::string& shippedFolder)
{
  marked_.push_back({option, Use::reads, shippedFolder, {}});
}

void FileOptions::readsBelow(CLI::Option* option)
{
  marked_.push_back({option, Use::readsBelow, {}, {}});
}

void FileOptions::readsSettings(CLI::Option* option)
{
  marked_.push_back({option, Use::readsSettings, {}, {}});
}

void FileOptions::writes(CLI::Option* option) { marked_.push_back({option, Use::writes, {}, {}}); }

void FileOptions::records(CLI::Option* option)
{
  marked_.push_back({option, Use::records, {}, {}});
}

void FileOptions::writesInto(CLI::Option* option, const std::vector<std::string>& names)
{
  marked_.push_back({option, Use::writesInto, {}, names});
}

void FileOptions::add(CommandFiles& files, const Marked& marked, const std::string& value)
{
  const std::string name = marked.option->get_name();
  switch (marked.use) {
    case Use::reads: {
      files.addInput(name, value);
      if (marked.shippedFolder.empty()) return;
      const auto shipped = findByName("file", marked.shippedFolder, value);
      if (shipped) files.addInput(name, *shipped);
      return;
    }
    case Use::readsBelow:
      return files.addInputFolder(name, value);
    case Use::readsSettings: {
      const std::size_t equals = value.find('=');
      if (equals == std::string::npos) return;
      files.addInput(name + " " + value.substr(0, equals), unquoted(value.substr(equals + 1)));
      return;
    }
    case Use::writes:
      return files.addOutput(name, value);
    case Use::records:
      return files.addRecording(name, value);
    case Use::writesInto:
      return files.addOutputFolder(name, value, marked.names);
  }
}

CommandFiles FileOptions::filesOfCall() const
{
  CommandFiles files;
  for (const Marked& marked : marked_)
    for (const std::string& value : marked.option->results()) add(files, marked, value);
  return files;
}

std::vector<std::string> figureNames(const std::string& figure)
{
  std::vector<std::string> names = {figure + ".svg"};
  if (PERILYMPH_HAS_TOOLKIT) names.push_back(figure + ".png");
  return names;
}

}  // namespace perilymph::cli
