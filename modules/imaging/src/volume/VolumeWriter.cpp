// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/VolumeWriter.h"

#include <vtkImageFlip.h>
#include <vtkMatrix4x4.h>
#include <vtkNIFTIImageWriter.h>
#include <vtkNew.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <fstream>
#include <string>
#include <vector>

#include "../VtkErrorCollector.h"
#include "imageOf.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::imaging {

namespace {

namespace fs = std::filesystem;

/// The shortest text that reads back as the same number.
std::string exact(double value)
{
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string vectorText(const Eigen::Vector3d& v)
{
  return "(" + exact(v.x()) + "," + exact(v.y()) + "," + exact(v.z()) + ")";
}

std::string nrrdHeader(const ct::CtVolume& volume)
{
  const auto& size = volume.size();
  const Eigen::Matrix4d& lps = volume.lpsFromIndex();
  std::string text = "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes:";
  for (const int n : size) text += " " + std::to_string(n);
  text += "\nspace directions:";
  for (int axis = 0; axis < 3; ++axis) text += " " + vectorText(lps.block<3, 1>(0, axis));
  text += "\nkinds: domain domain domain\nendian: ";
  text += std::endian::native == std::endian::little ? "little" : "big";
  text += "\nencoding: raw\nspace origin: " + vectorText(lps.block<3, 1>(0, 3)) + "\n\n";
  return text;
}

bool writeNrrd(const ct::CtVolume& volume, const fs::path& file)
{
  std::ofstream out(file, std::ios::binary);
  const auto voxels = volume.voxels();
  out << nrrdHeader(volume);
  std::vector<std::int16_t> row(static_cast<std::size_t>(volume.size()[0]));
  for (auto from = voxels.begin(); from != voxels.end();
       from += static_cast<std::ptrdiff_t>(row.size())) {
    std::transform(from, from + static_cast<std::ptrdiff_t>(row.size()), row.begin(), ct::asAir);
    out.write(reinterpret_cast<const char*>(row.data()),
              static_cast<std::streamsize>(row.size() * sizeof(std::int16_t)));
  }
  return bool(out.flush());
}

bool writeNifti(const ct::CtVolume& volume, const fs::path& file)
{
  const Eigen::Vector3d spacing = volume.spacing_mm();
  vtkSmartPointer<vtkImageData> image = imageOf(volume);
  // NIfTI is RAS, and VTK's matrix takes millimeters, not indices
  Eigen::Matrix4d ras = volume.lpsFromIndex();
  ras.topRows<2>() = -ras.topRows<2>();
  vtkNew<vtkImageFlip> reversed;
  if (ras.topLeftCorner<3, 3>().determinant() < 0.0) {
    // from the last slice on: VTK 9.1 writes another QForm than SForm of left-handed axes
    ras.block<3, 1>(0, 3) += (volume.size()[2] - 1) * ras.block<3, 1>(0, 2);
    ras.block<3, 1>(0, 2) *= -1.0;
    reversed->SetInputData(image);
    reversed->SetFilteredAxis(2);
    reversed->Update();
    image = reversed->GetOutput();
  }
  image->SetSpacing(spacing.x(), spacing.y(), spacing.z());
  for (int axis = 0; axis < 3; ++axis) ras.block<3, 1>(0, axis) /= spacing[axis];
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix->SetElement(row, column, ras(row, column));
  vtkNew<vtkNIFTIImageWriter> writer;
  vtkNew<ErrorCollector> complaints;
  complaints->listenTo({writer});
  writer->SetInputData(image);
  writer->SetSFormMatrix(matrix);
  writer->SetQFormMatrix(matrix);
  writer->SetFileName(file.c_str());
  writer->Write();
  return !complaints->isAny;
}

}  // namespace

Result<void> writeVolume(const ct::CtVolume& volume, const fs::path& file)
{
  const std::string name = file.filename().string();
  if (name.ends_with(".nrrd"))
    return writeWhole(file, [&](const fs::path& place) { return writeNrrd(volume, place); });
  if (name.ends_with(".nii") || name.ends_with(".nii.gz"))
    return writeWhole(file, [&](const fs::path& place) { return writeNifti(volume, place); });
  return Error{"%1 has an unknown extension; a CT is written as .nrrd, .nii or .nii.gz.", file};
}

}  // namespace perilymph::imaging
