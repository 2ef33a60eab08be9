// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A scale bar in millimeters and the scale of the wall's force.

#include <vtkContextItem.h>

#include <string>
#include <unordered_map>
#include <vector>

#include "SceneColors.h"
#include "perilymph/visualization/SceneStyle.h"

namespace perilymph::visualization {

/// Drawn over the scene in pixels, at the lower edge, on plates because the model may be behind.
class ScaleBars : public vtkContextItem {
public:
  static ScaleBars* New();
  vtkTypeMacro(ScaleBars, vtkContextItem)

      bool showsForce = true;
  bool showsArrows = true;
  double pixelRatio = 1.0;
  int bottom_px = 34;       ///< Distance from the lower edge, at pixel ratio and text scale 1.
  double pixel_mm = 0.025;  ///< Size of a pixel of the picture.

  /// Colors and texts; those of a default SceneStyle until it is called.
  void setStyle(const SceneStyle& style);

  /// The longest of 1, 2 and 5 times a power of ten that is at most 110 pixels long.
  double barLength_mm() const;

  bool Paint(vtkContext2D* painter) override;

protected:
  ScaleBars() = default;
  ~ScaleBars() override = default;

private:
  struct ArrowKind {
    Rgba color;
    std::string label;
  };
  /// The upper right corner of a plate [pixels].
  struct Corner {
    float right = 0.0f;
    float top = 0.0f;
  };
  Corner paintLegend(vtkContext2D& painter, const std::vector<ArrowKind>& arrows);
  void paintLength(vtkContext2D& painter, const Corner& legend);
  std::vector<ArrowKind> arrowKinds() const;
  /// Pixels of a length that is given at pixel ratio 1 and text scale 1.
  double scale() const { return pixelRatio * textScale_; }
  /// Height of the line of a scale above the lower edge of the picture [pixels].
  float bottom() const;
  std::string rounded(double value) const;
  void paintArrows(vtkContext2D& painter, const std::vector<ArrowKind>& kinds, float left, float y);
  void paintPlate(vtkContext2D& painter, float left, float bottom, float right, float top);
  float widthOf(vtkContext2D& painter, const std::string& label);
  void setText(vtkContext2D& painter, int justification);

  const SceneColors* palette_ = &sceneColorsOf(figures::ColorScheme::dark);
  SceneStrings strings_;
  double textScale_ = 1.0;
  /// Widths of labels at a scale [px]: shaping text costs more than drawing it.
  std::unordered_map<std::string, float> widths_;
  double widthScale_ = 0.0;
};

}  // namespace perilymph::visualization
