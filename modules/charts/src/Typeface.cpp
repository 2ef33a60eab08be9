#include "perilymph/charts/Typeface.h"

#include <vtkTextProperty.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "perilymph/foundation/Resources.h"

namespace perilymph::charts {
namespace {

std::string fontFile()
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

void setTypeface(vtkTextProperty& text)
{
  static const std::string file = fontFile();
  if (file.empty()) {
    text.SetFontFamilyToArial();
    return;
  }
  text.SetFontFamily(VTK_FONT_FILE);
  text.SetFontFile(file.c_str());
}

}  // namespace perilymph::charts
