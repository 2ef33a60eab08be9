#pragma once

// The scala rolled out and its section at the tip, with the array in them.

#include <QObject>
#include <memory>

#include "perilymph/charts/ArrayInScala.h"
#include "perilymph/charts/TipSection.h"
#include "perilymph/charts/UnrolledScala.h"

class QWidget;

namespace perilymph::gui {

class Pane;
class PlotView;

/// Two panes that show where the array lies. UI thread only.
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

private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
  PlotView* unrolledView_;
  PlotView* sectionView_;
  Pane* unrolledPane_;
  Pane* sectionPane_;
};

}  // namespace perilymph::gui
