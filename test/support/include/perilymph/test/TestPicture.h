// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Pictures in tests: rendering, pixel queries, comparison with accepted pictures.

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "perilymph/test/Places.h"

namespace perilymph::test {

using Pixel = std::array<int, 3>;

/// A picture in memory; (0, 0) is at the lower left.
struct DrawnPicture {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;

  Pixel at(int x, int y) const
  {
    const std::size_t i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(x));
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

inline int difference(const Pixel& a, const Pixel& b)
{
  int maximum = 0;
  for (std::size_t i = 0; i < 3; ++i) maximum = std::max(maximum, std::abs(a[i] - b[i]));
  return maximum;
}

/// Pixels for which `is` holds.
template <class Question>
int countPixels(const DrawnPicture& picture, Question is)
{
  int count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) count += is(picture.at(x, y), x, y) ? 1 : 0;
  return count;
}

inline DrawnPicture draw(vtkRenderWindow& window)
{
  window.Render();
  DrawnPicture picture{window.GetSize()[0], window.GetSize()[1], {}};
  vtkNew<vtkUnsignedCharArray> pixels;
  window.GetPixelData(0, 0, picture.width - 1, picture.height - 1, 0, pixels);
  picture.rgb.assign(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  return picture;
}

inline void save(const DrawnPicture& picture, const std::filesystem::path& file)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.width, picture.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(picture.rgb.begin(), picture.rgb.end(),
            static_cast<unsigned char*>(image->GetScalarPointer()));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->Write();
}

inline DrawnPicture load(const std::filesystem::path& file)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData& image = *reader->GetOutput();
  if (image.GetNumberOfPoints() == 0 || image.GetNumberOfScalarComponents() < 3) return {};
  DrawnPicture picture{image.GetDimensions()[0], image.GetDimensions()[1], {}};
  const auto* pixels = static_cast<const unsigned char*>(image.GetScalarPointer());
  const int components = image.GetNumberOfScalarComponents();
  for (vtkIdType i = 0; i < image.GetNumberOfPoints(); ++i)
    picture.rgb.insert(picture.rgb.end(), pixels + i * components, pixels + i * components + 3);
  return picture;
}

/// Empty if the picture equals the accepted one; otherwise a message with the paths of both and how
/// to accept the new one. PERILYMPH_ACCEPT_PICTURES=1 accepts.
///
/// On one machine the software renderer always draws the same bits. On other processors its vector
/// arithmetic rounds differently, so one pixel in 500 may differ, as at edges.
inline std::string comparedWithAccepted(const DrawnPicture& actual, const std::string& name)
{
  const std::filesystem::path accepted = testData() / "pictures" / (name + ".png");
  if (std::getenv("PERILYMPH_ACCEPT_PICTURES") != nullptr) {
    save(actual, accepted);
    return {};
  }
  const DrawnPicture expected = std::filesystem::exists(accepted) ? load(accepted) : DrawnPicture{};
  DrawnPicture shown = actual;
  int changed = 0;
  const bool sameSize = expected.width == actual.width && expected.height == actual.height;
  for (std::size_t i = 0; sameSize && i + 2 < actual.rgb.size(); i += 3) {
    int maximum = 0;
    for (std::size_t k = i; k < i + 3; ++k) {
      const int off = std::abs(actual.rgb[k] - expected.rgb[k]);
      maximum = std::max(maximum, off);
      shown.rgb[k] = static_cast<unsigned char>(std::min(255, 8 * off));
    }
    changed += maximum > 8 ? 1 : 0;
  }
  if (sameSize && 500 * changed <= actual.width * actual.height) return {};

  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "perilymph-pictures";
  std::filesystem::create_directories(folder);
  save(actual, folder / (name + "-actual.png"));
  save(shown, folder / (name + "-difference.png"));
  if (std::filesystem::exists(accepted))
    std::filesystem::copy_file(accepted, folder / (name + "-expected.png"),
                               std::filesystem::copy_options::overwrite_existing);
  return std::to_string(changed) + " pixels of " + name + " changed. See " + folder.string() + "/" +
         name + "-{actual,expected,difference}.png. If the new picture is right: " +
         "PERILYMPH_ACCEPT_PICTURES=1 ctest -L render";
}

}  // namespace perilymph::test
