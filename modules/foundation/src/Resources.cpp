// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Resources.h"

#include <dlfcn.h>
#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "OwnResources.h"
#include "perilymph/foundation/StateFolder.h"

namespace perilymph {
namespace {

namespace fs = std::filesystem;

/// An environment variable; empty if it is not set.
std::string environment(const char* name)
{
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

/// A folder of the XDG Base Directory Specification, which ignores relative paths.
fs::path ownFolder(const char* variable, const char* belowHome)
{
  const fs::path given = environment(variable);
  if (given.is_absolute()) return given;
  fs::path home = environment("HOME");
  if (!home.is_absolute()) {
    const passwd* account = ::getpwuid(::getuid());
    home = account != nullptr ? account->pw_dir : "/";
  }
  return home / belowHome;
}

std::string joined(const std::vector<std::string>& text)
{
  std::string all;
  for (const std::string& word : text) all += (all.empty() ? "" : ", ") + word;
  return all;
}

}  // namespace

fs::path resourceRoot()
{
  const std::string chosen = environment("PERILYMPH_RESOURCES");
  return chosen.empty() ? ownResourceRoot() : fs::path(chosen);
}

namespace {

/// The data beside the shared library that this code is in, as the Python package has it: in its own folder,
/// or where `cmake --install` puts both; empty for a program.
fs::path dataOfLibrary()
{
  Dl_info own{};
  if (dladdr(reinterpret_cast<const void*>(&ownResourceRoot), &own) == 0 ||
      own.dli_fname == nullptr)
    return {};
  const fs::path library = own.dli_fname;
  if (!library.is_absolute() || library.extension() != ".so") return {};
  std::error_code failure;
  for (const char* place : {"data", "../../../../share/perilymph"}) {
    const fs::path found = (library.parent_path() / place).lexically_normal();
    if (fs::is_directory(found / "resources", failure)) return found;
  }
  return {};
}

}  // namespace

fs::path ownResourceRoot()
{
  if (fs::path found = dataOfLibrary(); !found.empty()) return found;
  // Beside the program, wherever it was installed or unpacked.
  std::error_code failure;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  const fs::path installed =
      (program.parent_path() / PERILYMPH_DATA_FROM_PROGRAMS).lexically_normal();
  if (!failure && fs::is_directory(installed / "resources", failure)) return installed;
  return PERILYMPH_RESOURCE_ROOT;
}

fs::path resource(std::string_view relative) { return resourceRoot() / fs::path(relative); }

std::vector<fs::path> tomlFilesIn(const fs::path& folder)
{
  std::vector<fs::path> files;
  std::vector<fs::path> folders;
  std::error_code failure;
  const auto collect = [&](const fs::path& place, bool withFolders) {
    for (fs::directory_iterator entry(place, failure), end; !failure && entry != end;
         entry.increment(failure)) {
      std::error_code ignored;
      if (withFolders && entry->is_directory(ignored)) folders.push_back(entry->path());
      if (entry->path().extension() == ".toml" && entry->is_regular_file(ignored))
        files.push_back(entry->path());
    }
  };
  collect(folder, true);
  for (const fs::path& below : folders) collect(below, false);
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> shippedNames(std::string_view folder)
{
  std::vector<std::string> names;
  for (const fs::path& file : tomlFilesIn(resource(folder))) names.push_back(file.stem().string());
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

Result<fs::path> findByName(std::string_view kind, std::string_view folder,
                            const std::string& nameOrFile)
{
  // Prefer a shipped file of that name; everything else is a path.
  std::vector<fs::path> shipped;
  for (const fs::path& file : tomlFilesIn(resource(folder)))
    if (file.stem() == nameOrFile) shipped.push_back(file);
  if (shipped.size() == 1) return shipped.front();
  if (shipped.size() > 1)
    return Error{"There are several files for the %1 '%2': %3 and %4. Give the path of one.",
                 std::string(kind), nameOrFile, shipped[0].string(), shipped[1].string()};

  std::error_code ignored;
  const fs::path file(nameOrFile);
  if (fs::is_directory(file, ignored))
    return Error{"'%1' is a folder. For the %2, give the name of a file in it.", nameOrFile,
                 std::string(kind)};
  if (fs::exists(file, ignored)) return file;

  const std::vector<std::string> names = shippedNames(folder);
  const std::string known = names.empty() ? "None is shipped in " + resource(folder).string() + "."
                                          : "The names there are: " + joined(names) + ".";
  return Error{"There is no %1 or file '%2'. %3 Give one of these or the path of a TOML file.",
               std::string(kind), nameOrFile, known};
}

fs::path sessionFolder()
{
  return ownFolder("XDG_DATA_HOME", ".local/share") / "perilymph" / "sessions";
}

fs::path deviceProfileFolder() { return sessionFolder().parent_path() / "devices"; }

fs::path patientFolder() { return sessionFolder().parent_path() / "patients"; }

fs::path stateFolder() { return ownFolder("XDG_STATE_HOME", ".local/state") / "perilymph"; }

fs::path plansFolder() { return stateFolder() / "plans"; }

}  // namespace perilymph
