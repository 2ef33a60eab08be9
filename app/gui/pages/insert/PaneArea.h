#pragma once

// How the parts of the insertion page share it: one, two or four of them at a time.

#include <QWidget>
#include <optional>
#include <vector>

namespace perilymph::gui {

/// How many parts are seen: the picture alone; picture and charts; picture, charts, the unrolled
/// scala and the section.
enum class PaneLayout { one, two, four };

/// Where a part stands.
enum class PaneRole { picture, travel, components, unrolled, section, distances };

/// Shares its rectangle between parts. Parts are moved and hidden, never taken out of the window:
/// views of OpenGL keep their contexts.
class PaneArea : public QWidget {
  Q_OBJECT
public:
  explicit PaneArea(QWidget* parent);

  /// Takes a part in, which becomes a child.
  void add(PaneRole role, QWidget* part);

  void setArrangement(PaneLayout layout);
  PaneLayout arrangement() const { return layout_; }
  /// One after the other, round and round.
  void nextArrangement();
  /// Gives the whole area to one part, or back to all.
  void toggleMaximized(PaneRole role);
  std::optional<PaneRole> maximized() const { return maximized_; }

Q_SIGNALS:
  /// What the user chose, to be kept.
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
