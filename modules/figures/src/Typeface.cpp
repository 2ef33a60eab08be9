// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/figures/Typeface.h"

#include <filesystem>
#include <system_error>

#include "perilymph/foundation/Resources.h"

namespace perilymph::figures {
namespace {

std::string findTypeface()
{
  const std::filesystem::path candidates[] = {
      resource("resources/fonts/Inter-Regular.otf"),
      "/usr/share/fonts/opentype/inter/Inter-Regular.otf",
      "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
  };
  for (const std::filesystem::path& file : candidates) {
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) return file.string();
  }
  return {};
}

}  // namespace

const std::string& typefaceFile()
{
  static const std::string file = findTypeface();
  return file;
}

}  // namespace perilymph::figures
