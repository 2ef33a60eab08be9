#pragma once

// The scala rolled out, its section at the tip, and how near the contacts are to the modiolus.

#include <QObject>
#include <memory>

#include "perilymph/charts/ArrayInScala.h"
#include "perilymph/charts/TipSection.h"
#include "perilymph/charts/UnrolledScala.h"

class QWidget;

namespace perilymph::gui {

class Pane;
class PlotView;

/// Three panes that show where the array lies. UI thread only.
class FlatViews : public QObject {
  Q_OBJECT
public:
  /// The panes become children of `parent`.
  explicit FlatViews(QWidget* parent);
  ~FlatViews() override;

  /// Another cochlea or another array from now on. The cochlea must outlive the views or the next
  /// call.
  void setScene(const anatomy::ScalaTympani& scala, const electrode::ArrayDesign& array);
  void forgetScene();
  /// Where the array is now.
  void show(const haptics::Snapshot& now);

  Pane* unrolled() const { return unrolledPane_; }
  Pane* section() const { return sectionPane_; }
  Pane* distances() const { return distancesPane_; }

private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
  PlotView* unrolledView_;
  PlotView* sectionView_;
  PlotView* distancesView_;
  Pane* unrolledPane_;
  Pane* sectionPane_;
  Pane* distancesPane_;
};

}  // namespace perilymph::gui
