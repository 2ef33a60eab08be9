// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// All views of an insertion: 3D view, charts and flat views, and their arrangement on the page.

#include <QWidget>

#include "gui/pages/insert/AdaptiveQuality.h"
#include "gui/pages/insert/PaneArea.h"
#include "gui/scene/BoneNote.h"
#include "perilymph/foundation/Result.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/session/Scenario.h"

namespace perilymph::gui {

class FlatViews;
class ForceSound;
class ForceCharts;
class FrameMeter;
class OperationView;
class StereoWindow;

/// The parts of the insertion page between the panel and the bottom bar. Their visibility is stored
/// in the settings.
class InsertionViews : public PaneArea {
  Q_OBJECT
public:
  explicit InsertionViews(QWidget* parent);
  ~InsertionViews() override;

  OperationView* operation() const { return operation_; }
  ForceCharts* charts() const { return charts_; }

  /// Sets cochlea and array. The cochlea must outlive the views, the next call, or releaseScene().
  void setScene(const anatomy::ScalaTympani& scala, const session::Scenario& scenario);
  /// The cochlea will be destroyed.
  void releaseScene();
  /// Updates the views that follow the array fifteen times a second.
  void showSlowly(const haptics::Snapshot& now);

  /// Where bone of patients is.
  void setBoneSource(BoneSource source);
  /// Shows the bone as it is now.
  void refreshBone();

  void lookFrom(visualization::CameraPreset preset);
  void setStereo(visualization::Stereo stereo);
  /// Cycles through the stereo modes.
  void nextStereo();

  /// Selects the rendering quality automatically, by the name of the OpenGL renderer and the first
  /// second of frames, or as requested. Without a request the stored setting is used.
  void drawBy(const std::string& renderer, std::optional<QualityChoice> asked);
  visualization::Quality quality() const { return pilot_.quality(); }
  /// Evaluates the frame times so far.
  void weigh(const FrameMeter& meter);
  /// Whether quad-buffered stereo is available.
  /// @param error  Why not; empty if it is.
  void offerQuadBuffered(const QString& error);
  /// The quad-buffered stereo window; null if it is not shown.
  const StereoWindow* stereoWindow() const { return twin_.get(); }

Q_SIGNALS:
  /// The rendering quality changed.
  void qualityChanged();

protected:
  QSize minimumSizeHint() const override;

private:
  void connectParts();
  void chooseQuality(QualityChoice choice);
  void redraw();
  std::unique_ptr<visualization::InsertionScene> madeScene() const;
  std::shared_ptr<const visualization::BoneModel> bone() const;
  void openTwin();
  void closeTwin();

  OperationView* operation_;
  ForceCharts* charts_;
  FlatViews* flat_;
  ViewMenu* menu_;
  ForceSound* sound_;
  AdaptiveQuality pilot_;
  bool hasQuadBuffers_ = false;
  std::unique_ptr<StereoWindow> twin_;
  bool measures_ = false;
  // content of the scene, to rebuild it with another quality
  const anatomy::ScalaTympani* scala_ = nullptr;
  electrode::ArrayDesign array_;
  anatomy::Side side_ = anatomy::Side::right;
  anatomy::Approach approach_;
  std::optional<anatomy::Patient> patient_;  ///< Whose cochlea it is; empty for a model.
  BoneSource boneSource_;
  haptics::Snapshot shown_{};
};

}  // namespace perilymph::gui
