// SPDX-License-Identifier: BSD-3-Clause
#include "ScaleBars.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ContactMarks.h"
#include "ForceColors.h"
#include "perilymph/figures/Strings.h"
#include "perilymph/figures/Typeface.h"

namespace perilymph::visualization {
namespace {

constexpr double longestBar_px = 110.0;
constexpr double margin_px = 24.0;
constexpr double swatch_px = 23.0;     // of an arrow's line and the gap behind it
constexpr double row_px = 17.0;        // line spacing of text
constexpr double plateRim_px = 8.0;    // around the content of a plate
constexpr double plateOpacity = 0.92;  // as behind the window's text on the picture
// A lower or narrower picture has space for the scale of wall force only.
constexpr int lowPicture_px = 380, narrowPicture_px = 330;
constexpr int labelSize = 12;
constexpr double namedForce_mN = 20.0;  // the force shown in the legend of arrows

void fillWith(vtkContext2D& painter, const Rgba& color)
{
  painter.GetPen()->SetLineType(vtkPen::NO_PEN);
  painter.GetBrush()->SetColor(color[0], color[1], color[2], color[3]);
}

}  // namespace

vtkStandardNewMacro(ScaleBars)

    double ScaleBars::barLength_mm() const
{
  const double longest_mm = longestBar_px * pixelRatio * pixel_mm;
  const double power = std::pow(10.0, std::floor(std::log10(longest_mm) + 1e-9));
  for (const double step : {5.0, 2.0})
    if (step * power <= longest_mm * (1.0 + 1e-9)) return step * power;
  return power;
}

void ScaleBars::setStyle(const SceneStyle& style)
{
  palette_ = &sceneColorsOf(style.scheme);
  strings_ = style.strings;
  textScale_ = style.textScale;
  Modified();
}

std::string ScaleBars::rounded(double value) const
{
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return figures::withDecimalSign(text, strings_.decimalSign);
}

bool ScaleBars::Paint(vtkContext2D* painter)
{
  const bool isSmall = GetScene()->GetSceneHeight() < lowPicture_px * scale() ||
                       GetScene()->GetSceneWidth() < narrowPicture_px * scale();
  const Corner legend = paintLegend(*painter, isSmall ? std::vector<ArrowKind>{} : arrowKinds());
  paintLength(*painter, legend);
  return true;
}

float ScaleBars::bottom() const { return static_cast<float>(std::round(bottom_px * scale())); }

void ScaleBars::setText(vtkContext2D& painter, int justification)
{
  vtkTextProperty& text = *painter.GetTextProp();
  if (const std::string& file = figures::typefaceFile(); file.empty()) {
    text.SetFontFamilyToArial();
  } else {
    text.SetFontFamily(VTK_FONT_FILE);
    text.SetFontFile(file.c_str());
  }
  text.SetFontSize(static_cast<int>(std::lround(labelSize * scale())));
  text.SetColor(palette_->quietText[0] / 255.0, palette_->quietText[1] / 255.0,
                palette_->quietText[2] / 255.0);
  text.SetBold(false);
  text.SetJustification(justification);
  text.SetVerticalJustificationToCentered();
}

void ScaleBars::paintPlate(vtkContext2D& painter, float left, float bottom, float right, float top)
{
  fillWith(painter, withOpacity(palette_->ground, plateOpacity));
  painter.DrawRect(std::round(left), std::round(bottom), std::round(right - left),
                   std::round(top - bottom));
}

float ScaleBars::widthOf(vtkContext2D& painter, const std::string& label)
{
  if (scale() != widthScale_) widths_.clear();
  widthScale_ = scale();
  if (const auto known = widths_.find(label); known != widths_.end()) return known->second;
  float bounds[4];  // left, bottom, width, height
  setText(painter, VTK_TEXT_LEFT);
  painter.ComputeStringBounds(label, bounds);
  return widths_[label] = bounds[2];
}

void ScaleBars::paintLength(vtkContext2D& painter, const Corner& legend)
{
  const float length = static_cast<float>(std::round(barLength_mm() / pixel_mm));
  const float scale = static_cast<float>(this->scale());
  const float right = std::round(static_cast<float>(GetScene()->GetSceneWidth()) -
                                 static_cast<float>(margin_px) * scale);
  const float line = std::max(1.0f, std::round(1.4f * scale));
  const float cap = std::round(8.0f * scale);
  const float rim = static_cast<float>(plateRim_px) * scale;
  float y = bottom();
  // beside the legend, or above it where it is as wide
  if (right - length - rim < legend.right) y = std::round(legend.top) + cap;
  paintPlate(painter, right - length - rim, y - cap, right + rim, y + 26.0f * scale);
  fillWith(painter, palette_->text);
  painter.DrawRect(right - length, y, length, line);
  painter.DrawRect(right - length, y - 0.5f * cap, line, cap + line);
  painter.DrawRect(right - line, y - 0.5f * cap, line, cap + line);
  setText(painter, VTK_TEXT_CENTERED);
  painter.DrawString(right - 0.5f * length, y + 16.0f * scale, rounded(barLength_mm()) + " mm");
}

ScaleBars::Corner ScaleBars::paintLegend(vtkContext2D& painter,
                                         const std::vector<ArrowKind>& arrows)
{
  if (!showsForce && arrows.empty()) return {};
  const float scale = static_cast<float>(this->scale());
  const float left = static_cast<float>(margin_px) * scale;
  const float y = bottom();
  const float height = std::round(6.0f * scale);
  const int cells = 64;
  const float cell = std::max(1.0f, std::round(2.0f * scale));
  const float width = cell * cells;
  const float above = y + height + 11.0f * scale;
  const float below = y - 10.0f * scale;
  const std::string& label = strings_.wallForce;

  // model and text share this corner in some views
  const float rim = static_cast<float>(plateRim_px) * scale;
  const float row = static_cast<float>(row_px) * scale;
  float widest = showsForce ? std::max(width, widthOf(painter, label)) : 0.0f;
  for (const ArrowKind& kind : arrows)
    widest = std::max(widest, static_cast<float>(swatch_px) * scale + widthOf(painter, kind.label));
  const float foot = showsForce ? above + 2.0f * scale : below - row;
  const float top = arrows.empty() ? above : foot + row * float(arrows.size());
  const Corner corner{left + widest + rim, top + rim};
  paintPlate(painter, left - rim, below - rim, corner.right, corner.top);
  paintArrows(painter, arrows, left, top);
  if (!showsForce) return corner;

  for (int i = 0; i < cells; ++i) {
    fillWith(painter, forceColor((i + 0.5) / cells * maxWallForce_mN_mm, palette_->scheme));
    painter.DrawRect(left + static_cast<float>(i) * cell, y, cell, height);
  }
  setText(painter, VTK_TEXT_LEFT);
  painter.DrawString(left, above, label);
  painter.DrawString(left, below, "0");
  setText(painter, VTK_TEXT_CENTERED);
  painter.DrawString(left + 0.5f * width, below, rounded(0.5 * maxWallForce_mN_mm));
  setText(painter, VTK_TEXT_RIGHT);
  painter.DrawString(left + width, below, rounded(maxWallForce_mN_mm) + "+");
  return corner;
}

std::vector<ScaleBars::ArrowKind> ScaleBars::arrowKinds() const
{
  if (!showsArrows) return {};
  const double shown_mm = ContactMarks::arrow_mm_mN * namedForce_mN;
  const double times = ContactMarks::frictionArrow_mm_mN / ContactMarks::arrow_mm_mN;
  return {{palette_->arrow,
           figures::filled(strings_.normalForce, {rounded(shown_mm), rounded(namedForce_mN)})},
          {palette_->frictionArrow, figures::filled(strings_.friction, {rounded(times)})}};
}

void ScaleBars::paintArrows(vtkContext2D& painter, const std::vector<ArrowKind>& kinds, float left,
                            float y)
{
  const float scale = static_cast<float>(this->scale());
  for (const ArrowKind& kind : kinds) {
    fillWith(painter, kind.color);
    painter.DrawRect(left, y - scale, 16.0f * scale, 2.0f * scale);
    setText(painter, VTK_TEXT_LEFT);
    painter.DrawString(left + static_cast<float>(swatch_px) * scale, y, kind.label);
    y -= static_cast<float>(row_px) * scale;
  }
}

}  // namespace perilymph::visualization
