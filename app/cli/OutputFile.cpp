#include "OutputFile.h"

#include <fcntl.h>
#include <unistd.h>

#include <charconv>
#include <filesystem>

namespace perilymph::cli {

namespace fs = std::filesystem;

Result<Done> checkPlace(const std::string& file)
{
  if (file.empty()) return Done{};
  std::error_code ignored;
  const fs::path place(file);
  const fs::path folder = place.has_parent_path() ? place.parent_path() : fs::path(".");
  if (fs::is_directory(place, ignored))
    return Error{file + " is a folder. Give the name of a file in it."};
  if (!fs::is_directory(folder, ignored))
    return Error{"Cannot write " + file + ": the folder " + folder.string() +
                 " does not exist. Create it first."};
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK, AT_EACCESS) != 0 && !fs::exists(place, ignored))
    return Error{"Cannot write " + file + ": nothing may be written into " + folder.string() +
                 ". Choose another folder."};
  return Done{};
}

std::string fixed(double value, int digits)
{
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits);
  return {text, end.ptr};
}

}  // namespace perilymph::cli
