// SPDX-License-Identifier: BSD-3-Clause
#include "OutputFolder.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <stdexcept>

#include "FileOptions.h"
#include "Interruption.h"
#include "Terminal.h"
#include "perilymph/figures/Svg.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Unfinished.h"
#if PERILYMPH_HAS_TOOLKIT
#include "perilymph/charts/FigurePicture.h"
#endif

namespace perilymph::cli {

namespace fs = std::filesystem;

namespace {

Result<void> writePicture(const fs::path& file, const figures::Drawing& drawing)
{
#if PERILYMPH_HAS_TOOLKIT
  return charts::writePicture(drawing, file, {Links::refused});
#else
  static_cast<void>(file);
  static_cast<void>(drawing);
  return {};
#endif
}

/// Every file of a folder is checked before the work begins, so it must have been declared.
void expectOutput(const CommandFiles& files, const fs::path& file)
{
  if (!files.isOutput(file))
    throw std::logic_error(file.string() + " is not declared as an output of the command");
}

}  // namespace

Result<void> checkFolder(const std::string& folder)
{
  std::error_code ignored;
  const fs::path place = fs::absolute(folder, ignored).lexically_normal();
  if (fs::exists(place, ignored) && !fs::is_directory(place, ignored))
    return Error{folder + " is a file. Give --out a folder's name."};
  // The nearest existing folder, and the first one to be created in it.
  fs::path there = place, missing;
  while (!fs::is_directory(there, ignored) && there.has_relative_path()) {
    missing = there;
    there = there.parent_path();
  }
  // Only an attempt is conclusive: create a folder and remove it again. Not the one that is wanted,
  // which another process may create now, too.
  bool canMake = true;
  if (!missing.empty()) {
    canMake = ::access(missing.c_str(), F_OK) == 0 || errno == ENOENT;  // else its name is too long
    canMake = canMake && UnfinishedFolder::create(there / "perilymph");
  }
  if (!canMake || ::faccessat(AT_FDCWD, there.c_str(), W_OK, AT_EACCESS) != 0)
    return Error{"Cannot write into " + folder + ": nothing may be written into " + there.string() +
                 ". Choose another folder."};
  return {};
}

Result<void> checkReplaced(const fs::path& folder, const std::vector<std::string>& names,
                           bool isOwn)
{
  std::error_code ignored;
  if (isOwn) return {};
  for (const std::string& name : names)
    if (fs::exists(fs::symlink_status(folder / name, ignored)))
      return Error{folder.string() + " has a file " + name +
                   " that this command did not write; it is not replaced. Give --out another "
                   "folder, or move the file away."};
  return {};
}

Result<void> writeFolder(const CommandFiles& files, const std::string& folder,
                         const FolderContent& content)
{
  const fs::path place(folder);
  for (const auto& [name, text] : content.texts) expectOutput(files, place / name);
  for (const auto& [figure, drawing] : content.figures)
    for (const std::string& name : figureNames(figure)) expectOutput(files, place / name);
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure)
    return Error{"Cannot make the folder " + folder + ": " + failure.message() +
                 ". Choose another one."};
  std::vector<std::string> names;
  for (const auto& [name, text] : content.texts) {
    if (const auto done = writeWhole(place / name, text, {Links::refused}); !done)
      return done.error();
    names.push_back(name);
  }
  for (const auto& [name, drawing] : content.figures) {
    if (const auto done =
            writeWhole(place / (name + ".svg"), figures::svg(drawing), {Links::refused});
        !done)
      return done.error();
    if (const auto done = writePicture(place / (name + ".png"), drawing); !done)
      return done.error();
    names.push_back(name + (PERILYMPH_HAS_TOOLKIT ? ".svg and .png" : ".svg"));
  }
  print("wrote into {}:", folder);
  for (const std::string& name : names) print(" {}", name);
  print("\n");
  if (!PERILYMPH_HAS_TOOLKIT && !content.figures.empty())
    print("This build has no VTK: figures are SVG only.\n");
  return {};
}

void showProgress(const char* what, std::size_t done, std::size_t all)
{
  if (::isatty(STDERR_FILENO) != 0) {
    printError("\r{} {} of {}", what, done, all);
    if (done == all) printError("\r\x1b[K");
    std::fflush(stderr);
  }
  static_cast<void>(isInterrupted());
}

}  // namespace perilymph::cli
