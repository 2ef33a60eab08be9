#include "Backdrop.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "Palette.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::visualization {
namespace {

constexpr int size = 512;

/// A fixed pattern of -0.5 to 0.5, so that the slow gradient shows no bands.
double dither(int x, int y)
{
  std::uint32_t state =
      static_cast<std::uint32_t>(x) * 374761393u + static_cast<std::uint32_t>(y) * 668265263u;
  state = (state ^ (state >> 13)) * 1274126177u;
  return static_cast<double>((state ^ (state >> 16)) & 0xFFFFu) / 65535.0 - 0.5;
}

}  // namespace

void setBackdrop(vtkRenderer& renderer)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double dx = 2.0 * x / (size - 1) - 1.0;
      const double dy = 2.0 * y / (size - 1) - 1.0;
      const double away = std::min(1.0, std::sqrt(dx * dx + dy * dy) / 1.15);
      const double light = 0.5 * (1.0 + std::cos(pi * away));
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      for (std::size_t i = 0; i < 3; ++i) {
        const double value =
            palette::ground[i] + light * (palette::groundLight[i] - palette::ground[i]);
        pixel[i] = static_cast<unsigned char>(std::lround(value + dither(x, y)));
      }
    }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  renderer.SetBackground(palette::ground[0] / 255.0, palette::ground[1] / 255.0,
                         palette::ground[2] / 255.0);
  renderer.SetBackgroundTexture(texture);
  renderer.TexturedBackgroundOn();
}

}  // namespace perilymph::visualization
