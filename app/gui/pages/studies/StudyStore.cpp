// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/studies/StudyStore.h"

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

#include "gui/setup/Setup.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/session/Csv.h"
#include "perilymph/study/StudyRun.h"

namespace perilymph::gui {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t keyLength = 8;  // hexadecimal digits

std::string quoted(const std::string& text) { return tomlQuoted(QString::fromStdString(text)); }

/// "[a, b]"
template <class List, class Text>
std::string listOf(const List& values, const Text& text)
{
  std::string list;
  for (const auto& each : values) list += (list.empty() ? "" : ", ") + text(each);
  return "[" + list + "]";
}

std::string number(double value) { return session::shortestDecimal(value); }

std::string textWith(const StudyDraft& draft, const std::vector<std::string>& patients)
{
  std::string text = "title = " + quoted(draft.title) + "\nscenario = " + quoted(draft.scenario) +
                     "\nseed = " + std::to_string(draft.seed) + "\ndepth = \"full\"\n";
  if (draft.samples > 1) text += "samples = " + std::to_string(draft.samples) + "\n";
  text += std::string("\n[cochleae]\nmean = ") + (draft.hasMean ? "true" : "false") +
          "\nvirtual = " + std::to_string(draft.simulated) + "\n";
  if (!patients.empty()) text += "patients = " + listOf(patients, quoted) + "\n";
  text += "\n[vary]\n";
  if (!draft.arrays.empty()) text += "array = " + listOf(draft.arrays, quoted) + "\n";
  if (!draft.frictions.empty()) text += "friction = " + listOf(draft.frictions, quoted) + "\n";
  text += "nodes = [" + std::to_string(draft.nodes) + "]\ndt_ms = [" + number(draft.timeStep_ms) +
          "]\n";
  std::string ranges;
  for (const DraftValue& each : draft.values)
    if (each.low == each.high)
      text += each.key + " = [" + number(each.low) + "]\n";
    else
      ranges += each.key + " = [" + number(each.low) + ", " + number(each.high) + "]\n";
  if (!ranges.empty()) text += "\n[ranges]\n" + ranges;
  return text;
}

/// Names of the patients' copies: those of the files, told apart where two are equal.
std::vector<std::string> namesOf(const std::vector<fs::path>& patients)
{
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const fs::path& patient : patients) {
    std::string name = patient.filename().string();
    for (int i = 2; !taken.insert(name).second; ++i)
      name = std::to_string(i) + "-" + patient.filename().string();
    names.push_back(name);
  }
  return names;
}

/// The title in a study's settings; else the name of its folder.
QString titleOf(const fs::path& folder)
{
  const std::string name = folder.filename().string();
  auto reader = TomlReader::open(folder / studySettingsFile);
  return QString::fromStdString(reader ? reader->text("title", name) : name);
}

}  // namespace

std::string studyText(const StudyDraft& draft)
{
  std::vector<std::string> paths;
  for (const fs::path& patient : draft.patients) paths.push_back(patient.string());
  return textWith(draft, paths);
}

fs::path studiesFolder() { return sessionFolder().parent_path() / "studies"; }

Result<fs::path> saveStudy(const StudyDraft& draft)
{
  const std::vector<std::string> names = namesOf(draft.patients);
  const std::string text = textWith(draft, names);
  Sha256 hash;
  hash.add(text);
  std::vector<std::string> contents;
  for (const fs::path& patient : draft.patients) {
    auto content = readWhole(patient);
    if (!content) return content.error();
    hash.add(std::to_string(content->size()) + ":" + *content);
    contents.push_back(*std::move(content));
  }
  const fs::path folder =
      studiesFolder() / (fileNameOf(draft.title) + "-" + hash.hex().substr(0, keyLength));
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure)
    return Error{
        "%1 cannot be created: %2. Check the permissions of its folder and the space on the disk.",
        folder, failure.message()};
  for (std::size_t i = 0; i < names.size(); ++i)
    if (const auto done =
            writeWhole(folder / names[i], contents[i], {Links::refused, Audience::owner});
        !done)
      return done.error();
  if (const auto done = writeWhole(folder / studySettingsFile, text, {Links::refused}); !done)
    return done.error();
  return folder;
}

StoredStudy readStoredStudy(const fs::path& folder)
{
  StoredStudy stored;
  stored.folder = folder;
  stored.title = titleOf(folder);
  std::error_code ignored;
  stored.isComplete = fs::exists(folder / study::mergedFile, ignored);
  if (const auto states = study::shardsIn(folder))
    for (const study::ShardState& state : *states) {
      stored.done += state.done;
      stored.cases = std::max(stored.cases, state.cases);
    }
  return stored;
}

QStringList storedTitles()
{
  QStringList titles;
  std::error_code failure;
  for (fs::directory_iterator entries(studiesFolder(), failure), end; !failure && entries != end;
       entries.increment(failure))
    if (fs::exists(entries->path() / studySettingsFile, failure))
      titles << titleOf(entries->path());
  return titles;
}

std::vector<StoredStudy> storedStudies()
{
  std::error_code failure;
  std::vector<std::pair<fs::file_time_type, fs::path>> folders;
  fs::directory_iterator entries(studiesFolder(), failure);
  if (failure) return {};  // none was made yet
  for (const fs::directory_entry& entry : entries)
    if (fs::exists(entry.path() / studySettingsFile, failure))
      folders.emplace_back(fs::last_write_time(entry.path(), failure), entry.path());
  std::sort(folders.rbegin(), folders.rend());
  std::vector<StoredStudy> studies;
  for (const auto& [time, folder] : folders) studies.push_back(readStoredStudy(folder));
  return studies;
}

}  // namespace perilymph::gui
