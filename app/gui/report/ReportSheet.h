// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Drawing on a page of the report: places in millimeters, type in points.

#include <QFont>
#include <QPainter>
#include <QStringList>

namespace perilymph::gui {

/// Typefaces of the report.
enum class ReportFace { text, quiet, label, bold, heading, title, number };

/// Inter at a size in dots. Without shaping, because Inter replaces signs between capitals and
/// digits by glyphs without a code, which are lost when text is copied from the PDF.
QFont reportFont(double size_dots, QFont::Weight weight = QFont::Normal);

/// Paints in millimeters from the upper left corner of the page's text.
class ReportSheet {
public:
  ReportSheet(QPainter& painter, double dotsPerInch);

  QPainter& painter() { return painter_; }
  QRectF dots(const QRectF& place_mm) const;
  QFont font(ReportFace face) const;

  /// Text in one line, shortened with an ellipsis if it is too long.
  void line(const QRectF& place_mm, const QString& text, ReportFace face,
            Qt::Alignment alignment = Qt::AlignLeft);
  /// Text in as many lines as needed.
  ///
  /// @return  Its height [mm].
  double paragraph(double x_mm, double y_mm, double width_mm, const QString& text, ReportFace face);
  /// The height of a paragraph [mm].
  double heightOf(double width_mm, const QString& text, ReportFace face) const;
  /// A heading with a rule below it.
  ///
  /// @return  Where the content begins [mm].
  double heading(double x_mm, double y_mm, double width_mm, const QString& text);
  void rule(double x_mm, double y_mm, double width_mm);

private:
  QPainter& painter_;
  double dotsPerInch_;
};

}  // namespace perilymph::gui
