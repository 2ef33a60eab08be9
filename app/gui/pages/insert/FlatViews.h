// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The unrolled scala, its section at the tip, and the distances of the contacts from the modiolus.

#include <QObject>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "gui/pages/insert/PaneArea.h"
#include "perilymph/charts/ArrayInScala.h"
#include "perilymph/charts/TipSection.h"
#include "perilymph/charts/UnrolledScala.h"

class QWidget;

namespace perilymph::gui {

class Pane;
class PlotView;

/// Three panes with the position of the array. UI thread only.
class FlatViews : public QObject {
  Q_OBJECT
public:
  /// The panes become children of `parent`.
  explicit FlatViews(QWidget* parent);
  ~FlatViews() override;

  /// Sets another cochlea or array. The cochlea must outlive the views or the next call.
  void setScene(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& array);
  void releaseScene();
  /// Updates the position of the array.
  void show(const haptics::Snapshot& now);

  /// The panes, each with its place on the page.
  std::vector<std::pair<PaneRole, Pane*>> panes() const;

private:
  struct Scene;
  struct View {
    PaneRole role;
    PlotView* plot;
    Pane* pane;
  };
  /// A drawing of the scene in a rectangle of this width and height.
  using Draw = std::function<figures::Drawing(const Scene& scene, double width, double height)>;
  Pane* addView(PaneRole role, const QString& name, const QString& title, const QString& note,
                const QString& tip, Draw draw);

  std::unique_ptr<Scene> scene_;
  std::vector<View> views_;
  haptics::Snapshot shown_{};
  bool isShown_ = false;  ///< The views show that snapshot.
  Pane* sectionPane_;
};

}  // namespace perilymph::gui
