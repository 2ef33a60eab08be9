// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Arrangement of the insertion page: one, two or four parts.

#include <QWidget>
#include <optional>
#include <vector>

namespace perilymph::gui {

/// Number of visible parts: the 3D view alone; 3D view and charts; 3D view, charts, the unrolled
/// scala and the section.
enum class PaneLayout { one, two, four };

/// Role of a part.
enum class PaneRole { picture, travel, components, unrolled, section, distances };

/// Arranges parts in its rectangle. Parts are moved and hidden, never removed from the window, so
/// that OpenGL views keep their contexts.
class PaneArea : public QWidget {
  Q_OBJECT
public:
  explicit PaneArea(QWidget* parent);

  /// Adds a part as a child.
  void add(PaneRole role, QWidget* part);

  void setArrangement(PaneLayout layout);
  PaneLayout arrangement() const { return layout_; }
  /// Cycles through the arrangements.
  void nextArrangement();
  /// Maximizes one part, or restores the arrangement.
  void toggleMaximized(PaneRole role);
  std::optional<PaneRole> maximized() const { return maximized_; }

Q_SIGNALS:
  /// The user selected an arrangement.
  void arrangementChanged(perilymph::gui::PaneLayout layout);

protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  struct Part {
    PaneRole role;
    QWidget* widget;
  };
  std::vector<std::pair<PaneRole, QRect>> places() const;
  void arrange();
  int columnWidth() const;

  std::vector<Part> parts_;
  PaneLayout layout_ = PaneLayout::two;
  std::optional<PaneRole> maximized_;
};

}  // namespace perilymph::gui
