// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/charts/FigurePicture.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>

#include "Canvas.h"
#include "TextStyle.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/foundation/Utf8.h"

namespace perilymph::charts {

namespace {

using figures::PagePoint;

constexpr double pixelsPerPoint = 3.0;
constexpr int dotsPerInch = 216;

/// A circle as a polygon with invisible corners.
std::vector<PagePoint> circle(PagePoint center, double radius)
{
  constexpr int corners = 32;
  std::vector<PagePoint> points;
  for (int i = 0; i < corners; ++i) {
    const double turn = 2.0 * pi * i / corners;
    points.push_back({center.x + radius * std::cos(turn), center.y + radius * std::sin(turn)});
  }
  return points;
}

/// Paints marks in order.
class Painter {
public:
  explicit Painter(Canvas& canvas) : canvas_(canvas) {}

  void operator()(const figures::Area& area)
  {
    canvas_.outline(scaled(area.points));
    canvas_.paint(area.ink);
  }

  void operator()(const figures::Stroke& stroke)
  {
    const double half = 0.5 * stroke.width * pixelsPerPoint;
    for (const auto& [from, to] : pieces(stroke)) {
      const double length = std::hypot(to.x - from.x, to.y - from.y);
      if (!(length > 0.0)) continue;
      const PagePoint across{-half * (to.y - from.y) / length, half * (to.x - from.x) / length};
      canvas_.outline({{from.x + across.x, from.y + across.y},
                       {to.x + across.x, to.y + across.y},
                       {to.x - across.x, to.y - across.y},
                       {from.x - across.x, from.y - across.y}});
      if (stroke.dash == 0.0 && half > 1.0) canvas_.outline(circle(to, half));
    }
    canvas_.paint(stroke.ink);
  }

  void operator()(const figures::Disk& disk)
  {
    const PagePoint center = scaled(disk.center);
    const double radius = disk.radius * pixelsPerPoint;
    const double rim = 0.5 * pixelsPerPoint;
    canvas_.outline(circle(center, radius + rim));
    canvas_.paint(disk.outline);
    canvas_.outline(circle(center, radius - rim));
    canvas_.paint(disk.fill);
  }

  void operator()(const figures::Label& label)
  {
    vtkNew<vtkTextProperty> property;
    setTypeface(*property);
    property->SetBold(label.isBold);
    property->SetItalic(false);
    property->SetShadow(false);
    property->SetColor(1.0, 1.0, 1.0);
    // VTK's font sizes are in points, scaled by the resolution in dots per inch.
    property->SetFontSize(static_cast<int>(std::lround(label.size)));
    const bool isUpward = label.direction == figures::Direction::upward;
    property->SetOrientation(isUpward ? 90.0 : 0.0);
    // Align by base line: lines with different letters then have equal height.
    property->SetVerticalJustificationToBottom();
    property->SetUseTightBoundingBox(false);

    vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
    vtkNew<vtkImageData> image;
    int size[2] = {0, 0};
    if (renderer == nullptr ||
        !renderer->RenderString(property, vtkStdString(onOneLine(label.text)), image, size,
                                dotsPerInch, vtkTextRenderer::FreeType))
      return;
    place(label, *image, size, isUpward);
  }

private:
  static PagePoint scaled(PagePoint point)
  {
    return {point.x * pixelsPerPoint, point.y * pixelsPerPoint};
  }

  static std::vector<PagePoint> scaled(std::vector<PagePoint> points)
  {
    for (PagePoint& point : points) point = scaled(point);
    return points;
  }

  /// The straight segments of a polyline, split into dashes if dashed.
  static std::vector<std::pair<PagePoint, PagePoint>> pieces(const figures::Stroke& stroke)
  {
    std::vector<std::pair<PagePoint, PagePoint>> result;
    const double dash = stroke.dash * pixelsPerPoint;
    double done = 0.0;  // of the polyline's length
    for (std::size_t i = 1; i < stroke.points.size(); ++i) {
      const PagePoint a = scaled(stroke.points[i - 1]);
      const PagePoint b = scaled(stroke.points[i]);
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      if (dash <= 0.0 || !(length > 0.0)) {
        result.emplace_back(a, b);
        continue;
      }
      const auto at = [&](double way) {
        return PagePoint{a.x + way / length * (b.x - a.x), a.y + way / length * (b.y - a.y)};
      };
      for (double begin = std::floor(done / (2.0 * dash)) * 2.0 * dash; begin < done + length;
           begin += 2.0 * dash) {
        const double from = std::max(0.0, begin - done);
        const double to = std::min(length, begin + dash - done);
        if (to > from) result.emplace_back(at(from), at(to));
      }
      done += length;
    }
    return result;
  }

  void place(const figures::Label& label, vtkImageData& image, const int (&size)[2], bool isUpward)
  {
    const PagePoint at = scaled(label.at);
    // Part of the text height is below the base line.
    const double below = 0.25 * label.size * pixelsPerPoint;
    const double length = isUpward ? size[1] : size[0];
    const double before = label.anchor == figures::Anchor::start    ? 0.0
                          : label.anchor == figures::Anchor::middle ? 0.5 * length
                                                                    : length;
    // left and bottom edge of the image on the page
    const double left = isUpward ? at.x + below - size[0] : at.x - before;
    const double bottom = isUpward ? at.y + before : at.y + below;
    int extent[6];
    image.GetExtent(extent);
    for (int y = 0; y < size[1]; ++y)
      for (int x = 0; x < size[0]; ++x) {
        const auto* pixel = static_cast<const unsigned char*>(
            image.GetScalarPointer(extent[0] + x, extent[2] + y, 0));
        if (pixel == nullptr || pixel[3] == 0) continue;
        canvas_.blend(static_cast<int>(std::lround(left)) + x,
                      static_cast<int>(std::lround(bottom)) - 1 - y, label.ink, pixel[3] / 255.0);
      }
  }

  Canvas& canvas_;
};

}  // namespace

Result<void> writePicture(const figures::Drawing& drawing, const std::filesystem::path& file,
                          const Writing& how)
{
  const int width = static_cast<int>(std::lround(drawing.width * pixelsPerPoint));
  const int height = static_cast<int>(std::lround(drawing.height * pixelsPerPoint));
  Canvas canvas(width, height);
  Painter painter(canvas);
  for (const figures::Mark& mark : drawing.marks) std::visit(painter, mark);

  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < height; ++y)  // VTK's images start at the bottom
    std::copy_n(canvas.row(height - 1 - y), static_cast<std::size_t>(width) * 3,
                static_cast<unsigned char*>(image->GetScalarPointer(0, y, 0)));
  const auto write = [&](const std::filesystem::path& neighbor) {
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(neighbor.c_str());
    writer->Write();
    return writer->GetErrorCode() == 0;
  };
  return writeWhole(file, write, how);
}

}  // namespace perilymph::charts
