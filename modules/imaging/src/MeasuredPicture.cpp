// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/MeasuredPicture.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "VtkErrorCollector.h"
#include "perilymph/ct/Marks.h"
#include "perilymph/ct/ViewPlane.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/imaging/PlaneSampler.h"

namespace perilymph::imaging {

namespace {

constexpr int edge_px = 512, views = 3;
constexpr double pixel_mm = 1.0 / 32.0, bar_mm = 5.0;
constexpr int barMargin_px = 16;

using Color = std::array<double, 3>;
constexpr Color wallColor{69, 196, 176}, markColor{255, 255, 255}, contactColor{230, 60, 40};

/// RGB pixels of the views side by side, row by row from the top.
class Canvas {
public:
  Canvas() : rgb_(std::size_t{3} * views * edge_px * edge_px) {}

  void setGray(int view, std::span<const std::uint8_t> gray)
  {
    for (int row = 0; row < edge_px; ++row)
      for (int column = 0; column < edge_px; ++column)
        std::fill_n(pixel(view, column, row), 3,
                    gray[static_cast<std::size_t>(row * edge_px + column)]);
  }

  /// Draws a line about a pixel and a half wide between places in millimeters from the center.
  void draw(int view, const ct::PictureLine& line, const Color& color)
  {
    const Eigen::Vector2d center = Eigen::Vector2d::Constant(0.5 * (edge_px - 1));
    const Eigen::Vector2d from = line[0] / pixel_mm + center, to = line[1] / pixel_mm + center;
    const int steps = 1 + static_cast<int>(4.0 * (to - from).norm());
    for (int k = 0; k <= steps; ++k) dot(view, from + (to - from) * (double(k) / steps), color);
  }

  bool write(const std::filesystem::path& file) const
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(views * edge_px, edge_px, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    constexpr std::size_t row_bytes = std::size_t{3} * views * edge_px;
    for (int row = 0; row < edge_px; ++row)  // VTK's rows run upward
      std::copy_n(
          rgb_.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row) * row_bytes),
          row_bytes, static_cast<unsigned char*>(image->GetScalarPointer(0, edge_px - 1 - row, 0)));
    vtkNew<vtkPNGWriter> writer;
    vtkNew<ErrorCollector> complaints;
    complaints->listenTo({writer});
    writer->SetInputData(image);
    writer->SetFileName(file.c_str());
    writer->Write();
    return !complaints->isAny;
  }

  RgbPicture picture() && { return {views * edge_px, edge_px, std::move(rgb_), pixel_mm}; }

private:
  std::uint8_t* pixel(int view, int column, int row)
  {
    return rgb_.data() +
           std::size_t{3} * static_cast<std::size_t>((row * views + view) * edge_px + column);
  }

  /// Blends a color into the four pixels around a place, by their distance.
  void dot(int view, const Eigen::Vector2d& place, const Color& color)
  {
    const int left = static_cast<int>(std::floor(place.x())),
              top = static_cast<int>(std::floor(place.y()));
    for (int row = top; row <= top + 1; ++row)
      for (int column = left; column <= left + 1; ++column) {
        if (row < 0 || row >= edge_px || column < 0 || column >= edge_px) continue;
        const double weight =
            (1.0 - std::fabs(place.x() - column)) * (1.0 - std::fabs(place.y() - row));
        std::uint8_t* const p = pixel(view, column, row);
        for (std::size_t c = 0; c < 3; ++c)
          p[c] = static_cast<std::uint8_t>(std::lround(p[c] + weight * (color[c] - p[c])));
      }
  }

  std::vector<std::uint8_t> rgb_;
};

void drawMeasures(Canvas& canvas, int view, const ct::ViewPlane& plane, const ct::Marks& marks)
{
  for (const ct::MeasureLine& line : ct::measureLines) {
    const Eigen::Vector3d &from = *marks[line.from], &to = *marks[line.to];
    if (plane.runsAlong(from, to))
      canvas.draw(view, {plane.inPicture(from), plane.inPicture(to)}, markColor);
  }
}

/// Rings of 0.3 mm around contacts, the most apical with a cross.
void drawContacts(Canvas& canvas, int view, const ct::ViewPlane& plane,
                  const std::vector<Eigen::Vector3d>& contacts_P)
{
  constexpr double radius_mm = 0.3, near_mm = 0.6;
  constexpr int parts = 24;
  for (std::size_t i = 0; i < contacts_P.size(); ++i) {
    if (view > 0 && std::fabs(plane.behind(contacts_P[i])) > near_mm) continue;
    const Eigen::Vector2d center = plane.inPicture(contacts_P[i]);
    const auto at = [&](int k) -> Eigen::Vector2d {
      const double angle = 2.0 * 3.14159265358979 * k / parts;
      return center + radius_mm * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    };
    for (int k = 0; k < parts; ++k) canvas.draw(view, {at(k), at(k + 1)}, contactColor);
    if (i > 0) continue;
    canvas.draw(view, {at(0), at(parts / 2)}, contactColor);
    canvas.draw(view, {at(parts / 4), at(3 * parts / 4)}, contactColor);
  }
}

Canvas drawn(std::shared_ptr<const ct::CtVolume> volume, const ct::CochleaMeasures& measures,
             const std::vector<Eigen::Vector3d>& contacts_P)
{
  PlaneSampler sampler(std::move(volume));
  const auto planes = ct::cochlearPlanes(measures, ct::basalTurnCenter_P(measures));
  const ct::Marks marks = ct::marksOf(measures);
  PlanePicture picture;
  picture.width = picture.height = edge_px;
  picture.pixel_mm = pixel_mm;
  // from the lumen to well above bone, whatever the scanner's gray values
  picture.window = {0.5 * (measures.boneLevel + measures.lumenLevel),
                    2.0 * std::fabs(measures.boneLevel - measures.lumenLevel)};
  Canvas canvas;
  for (int view = 0; view < views; ++view) {
    picture.plane = planes[static_cast<std::size_t>(view)];
    canvas.setGray(view, sampler.sample(picture));
    for (const ct::PictureLine& line : ct::wallOutline(measures, picture.plane))
      canvas.draw(view, line, wallColor);
    if (contacts_P.empty())
      drawMeasures(canvas, view, picture.plane, marks);
    else
      drawContacts(canvas, view, picture.plane, contacts_P);
    const double right = 0.5 * edge_px * pixel_mm - barMargin_px * pixel_mm;
    canvas.draw(view, {Eigen::Vector2d(right - bar_mm, right), Eigen::Vector2d(right, right)},
                markColor);
  }
  return canvas;
}

}  // namespace

RgbPicture measuredPicture(std::shared_ptr<const ct::CtVolume> volume,
                           const ct::CochleaMeasures& measures,
                           const std::vector<Eigen::Vector3d>& contacts_P)
{
  return drawn(std::move(volume), measures, contacts_P).picture();
}

Result<void> writeMeasuredPicture(std::shared_ptr<const ct::CtVolume> volume,
                                  const ct::CochleaMeasures& measures,
                                  const std::filesystem::path& file,
                                  const std::vector<Eigen::Vector3d>& contacts_P)
{
  if (file.extension() != ".png")
    return Error{"%1 does not end in .png, the only format of this picture.", file};
  const Canvas canvas = drawn(std::move(volume), measures, contacts_P);
  return writeWhole(file, [&](const std::filesystem::path& place) { return canvas.write(place); });
}

}  // namespace perilymph::imaging
