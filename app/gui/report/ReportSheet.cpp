// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportSheet.h"

#include <algorithm>
#include <cmath>

#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr double perInch_mm = 25.4;
constexpr double pointsPerInch = 72.0;
constexpr double ruleWidth_mm = 0.15;
constexpr double lineHeight = 1.35;  // times the size of the type

const QColor ink = themeOf(ColorScheme::light).text;
const QColor quietInk = themeOf(ColorScheme::light).quietText;
const QColor ruleInk(0xA8, 0xB3, 0xBB);

double pointsOf(ReportFace face)
{
  switch (face) {
    case ReportFace::text:
    case ReportFace::bold:
      return 8.5;
    case ReportFace::quiet:
    case ReportFace::label:
      return 8.0;
    case ReportFace::heading:
      return 10.0;
    case ReportFace::title:
      return 17.0;
    case ReportFace::number:
      return 13.0;
  }
  return 8.5;
}

QFont::Weight weightOf(ReportFace face)
{
  const bool isStrong = face == ReportFace::bold || face == ReportFace::heading ||
                        face == ReportFace::number || face == ReportFace::title;
  return isStrong ? QFont::DemiBold : QFont::Normal;
}

QColor colorOf(ReportFace face)
{
  return face == ReportFace::quiet || face == ReportFace::label ? quietInk : ink;
}

}  // namespace

QFont reportFont(double size_dots, QFont::Weight weight)
{
  QFont chosen(QStringLiteral("Inter"));
  chosen.setPixelSize(int(std::lround(size_dots)));
  chosen.setWeight(weight);
  chosen.setStyleStrategy(QFont::PreferNoShaping);
  return chosen;
}

ReportSheet::ReportSheet(QPainter& painter, double dotsPerInch)
    : painter_(painter), dotsPerInch_(dotsPerInch)
{
}

QRectF ReportSheet::dots(const QRectF& place_mm) const
{
  const double scale = dotsPerInch_ / perInch_mm;
  return {scale * place_mm.x(), scale * place_mm.y(), scale * place_mm.width(),
          scale * place_mm.height()};
}

QFont ReportSheet::font(ReportFace face) const
{
  return reportFont(pointsOf(face) * dotsPerInch_ / pointsPerInch, weightOf(face));
}

void ReportSheet::line(const QRectF& place_mm, const QString& text, ReportFace face,
                       Qt::Alignment alignment)
{
  painter_.setFont(font(face));
  painter_.setPen(colorOf(face));
  const QRectF place = dots(place_mm);
  // a text that is a little too long is set narrower, then cut
  constexpr double narrowest = 0.8;
  const QFontMetricsF metrics(painter_.font(), painter_.device());
  const double narrower =
      std::clamp(place.width() / metrics.horizontalAdvance(text), narrowest, 1.0);
  const double width = place.width() / narrower;
  painter_.save();
  painter_.translate(place.topLeft());
  painter_.scale(narrower, 1.0);
  painter_.drawText(QRectF(0.0, 0.0, width, place.height()),
                    int(alignment | Qt::AlignVCenter) | Qt::TextSingleLine,
                    metrics.elidedText(text, Qt::ElideRight, width + 1.0));
  painter_.restore();
}

double ReportSheet::paragraph(double x_mm, double y_mm, double width_mm, const QString& text,
                              ReportFace face)
{
  painter_.setFont(font(face));
  painter_.setPen(colorOf(face));
  constexpr double whole_mm = 280.0;
  const QRectF place = dots({x_mm, y_mm, width_mm, whole_mm});
  QRectF used;
  painter_.drawText(place, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, text, &used);
  return used.height() * perInch_mm / dotsPerInch_;
}

double ReportSheet::heightOf(double width_mm, const QString& text, ReportFace face) const
{
  const QRectF endless(0.0, 0.0, dots({0.0, 0.0, width_mm, 0.0}).width(), 1e6);
  const QRectF used =
      QFontMetricsF(font(face), painter_.device())
          .boundingRect(endless, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, text);
  return used.height() * perInch_mm / dotsPerInch_;
}

double ReportSheet::heading(double x_mm, double y_mm, double width_mm, const QString& text)
{
  const double height_mm = lineHeight * pointsOf(ReportFace::heading) * perInch_mm / pointsPerInch;
  line({x_mm, y_mm, width_mm, height_mm}, text, ReportFace::heading);
  rule(x_mm, y_mm + height_mm + 0.6, width_mm);
  return y_mm + height_mm + 1.8;
}

void ReportSheet::rule(double x_mm, double y_mm, double width_mm)
{
  painter_.setPen(QPen(ruleInk, ruleWidth_mm * dotsPerInch_ / perInch_mm));
  const QRectF place = dots({x_mm, y_mm, width_mm, 0.0});
  painter_.drawLine(place.topLeft(), place.topRight());
}

}  // namespace perilymph::gui
