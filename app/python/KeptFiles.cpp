// SPDX-License-Identifier: BSD-3-Clause
#include <cctype>
#include <system_error>

#include "Bindings.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Hash.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::python {

namespace {

/// The letters and digits of a name, for a file.
std::string fileNameOf(const std::string& name)
{
  std::string found;
  for (const char each : name)
    if (std::isalnum(static_cast<unsigned char>(each)) != 0 && found.size() < 40)
      found += static_cast<char>(std::tolower(static_cast<unsigned char>(each)));
  return found.empty() ? "unnamed" : found;
}

}  // namespace

std::string keptFile(const char* kind, const std::string& name, const std::string& text)
{
  Hash hash;
  hash.addBytes(text.data(), text.size());
  const std::filesystem::path folder = sessionFolder().parent_path() / kind;
  const std::filesystem::path file =
      folder / (fileNameOf(name) + '-' + fingerprintText(hash.value()) + ".toml");
  return valueOf(withoutLock([&]() -> Result<std::string> {
    const auto there = readWhole(file);
    if (there && *there == text) return file.string();
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
      return Error{"The folder %1 cannot be made: %2. Make it writable, or set XDG_DATA_HOME.",
                   folder.string(), error.message()};
    if (const auto done = writeWhole(file, text); !done) return done.error();
    return file.string();
  }));
}

std::string frictionNameOf(const py::object& given)
{
  if (!py::hasattr(given, "scenario_values")) return nameOrFileOf(given, "friction");
  return keptFile("frictions", "friction", given.attr("text").cast<std::string>());
}

std::string scenarioNameOf(const py::object& given)
{
  if (!py::isinstance<session::Scenario>(given)) return nameOrFileOf(given, "scenario");
  const auto& scenario = given.cast<const session::Scenario&>();
  return keptFile("scenarios", scenario.name(), scenario.text());
}

}  // namespace perilymph::python
