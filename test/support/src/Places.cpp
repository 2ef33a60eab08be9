// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/Places.h"

namespace perilymph::test {

std::filesystem::path projectFolder() { return PERILYMPH_PROJECT; }

std::filesystem::path buildFolder() { return PERILYMPH_BUILD; }

std::filesystem::path programFolder() { return PERILYMPH_PROGRAMS; }

std::filesystem::path testProgram(const std::string& name)
{
  return buildFolder() / "test" / "bin" / name;
}

std::filesystem::path testPlugin(const std::string& name)
{
  return buildFolder() / "test" / "plugins" / (name + ".so");
}

std::filesystem::path examplePlugin()
{
  return buildFolder() / "plugins" / "devices" / "example" / "example.so";
}

std::filesystem::path testData() { return projectFolder() / "test" / "data"; }

std::filesystem::path withDisplay()
{
  return projectFolder() / "test" / "support" / "with-display";
}

}  // namespace perilymph::test
