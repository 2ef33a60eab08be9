#pragma once

// All that shows an insertion: the picture, the charts and the flat views, and how they share the
// page.

#include <QWidget>

#include "gui/pages/insert/PaneArea.h"
#include "gui/pages/insert/QualityPilot.h"
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

/// The parts of the insertion page between the panel and the bar at the bottom. Which of them are
/// seen is kept in the settings.
class InsertionViews : public PaneArea {
  Q_OBJECT
public:
  explicit InsertionViews(QWidget* parent);
  ~InsertionViews() override;

  OperationView* operation() const { return operation_; }
  ForceCharts* charts() const { return charts_; }

  /// The cochlea and the array to be shown from now on. The cochlea must outlive the views, the
  /// next call, or forgetScene().
  void setScene(const anatomy::ScalaTympani& scala, const session::Scenario& scenario);
  /// The cochlea is about to go.
  void forgetScene();
  /// What follows the array fifteen times a second.
  void showSlowly(const haptics::Snapshot& now);

  void lookFrom(visualization::CameraPreset preset);
  void setStereo(visualization::Stereo stereo);
  /// One kind after the other, round and round.
  void nextStereo();

  /// Lets the machine's speed choose how much is drawn, from what OpenGL calls itself and from the
  /// first second of frames; or keeps to a choice. Without one to that of the settings.
  void drawBy(const std::string& renderer, std::optional<QualityChoice> asked);
  visualization::Quality quality() const { return pilot_.quality(); }
  /// Looks at the frames so far.
  void weigh(const FrameMeter& meter);
  /// Whether quad-buffered stereo can be chosen.
  /// @param trouble  Why it is not to be had; empty where it is.
  void offerQuadBuffered(const QString& error);
  /// The window it is shown in; none while it is not.
  const StereoWindow* stereoWindow() const { return twin_.get(); }

Q_SIGNALS:
  /// Another tier draws from now on.
  void qualityChanged();

protected:
  QSize minimumSizeHint() const override;

private:
  void connectParts();
  void chooseQuality(QualityChoice choice);
  void redraw();
  std::unique_ptr<visualization::InsertionScene> madeScene() const;
  void openTwin();
  void closeTwin();

  OperationView* operation_;
  ForceCharts* charts_;
  FlatViews* flat_;
  ViewMenu* menu_;
  ForceSound* sound_;
  QualityPilot pilot_;
  bool hasQuadBuffers_ = false;
  std::unique_ptr<StereoWindow> twin_;
  bool measures_ = false;
  // what the scene is made of, to make it anew in another tier
  const anatomy::ScalaTympani* scala_ = nullptr;
  electrode::ArrayDesign array_;
  anatomy::Side side_ = anatomy::Side::right;
  haptics::Snapshot shown_{};
};

}  // namespace perilymph::gui
