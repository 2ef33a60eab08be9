// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The central 3D view with the large read-outs.

#include <QElapsedTimer>
#include <memory>

#include "gui/scene/PlainVtkWidget.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/visualization/InsertionScene.h"

class QHBoxLayout;
class QLabel;

namespace perilymph::gui {

class Banner;
class ForceLabel;
class PhaseLine;
class ReadOut;
class SceneLabels;
class StereoWindow;
struct ReadOutTips;

/// Shows the scene and its read-outs; the mouse rotates, moves and zooms the model.
class OperationView : public PlainVtkWidget {
  Q_OBJECT
public:
  explicit OperationView(QWidget* parent);
  ~OperationView() override;

  /// Sets the cochlea and the array to be shown.
  void setScene(std::unique_ptr<visualization::InsertionScene> scene);
  /// Replaces the drawing of the same cochlea and array; the camera is kept.
  void replaceScene(std::unique_ptr<visualization::InsertionScene> scene);
  /// The scene; null before the first setScene().
  visualization::InsertionScene* scene() { return scene_.get(); }

  /// Updates the array.
  void showArray(const haptics::Snapshot& now);
  /// Updates the array of a reference insertion: InsertionScene::showGhost().
  void showGhost(const electrode::ArrayDesign& array, std::span<const Eigen::Vector3d> nodes_W);
  /// Updates the read-outs.
  /// @param angularDepth  Angular insertion depth, of the most apical contact; the tick has the tip's.
  /// @param stopTravel    Travel at full depth.
  void showNumbers(const haptics::TickOutput& now, Angle angularDepth, Length stopTravel);
  /// Leaves only the picture and the phases, for visitors of a booth, who have
  /// a display of their own beside it. Type has a size [px, before textScale()].
  void setForVisitors(int size_px);
  /// Shows the texts for visitors in the present language.
  void retranslate();
  /// The stop travel leaves some of the array outside.
  void setPartial(bool isPartial);
  void setPartVisible(visualization::Part part, bool isVisible);

  /// Shows bone around the cochlea while the part *landmarks* is visible; null for none.
  /// @param note  What the picture then shows.
  void setBone(std::shared_ptr<const visualization::BoneModel> bone, const QString& note);
  /// Moves the cut of the bone [mm], or turns it to the viewer.
  void moveCut(double by_mm);
  void faceCut();
  const SceneLabels& labels() const { return *labels_; }

  void glideTo(visualization::CameraPreset preset);
  /// For stereo shown by another window, this view shows the picture of one eye.
  void setStereo(visualization::Stereo stereo);
  /// Sets a window that shows the same view, or null. It must outlive its use here.
  void setTwin(StereoWindow* twin)
  {
    twin_ = twin;
    isDirty_ = true;
  }
  visualization::Stereo stereo() const { return stereo_; }
  void turnModel(double azimuth_deg, double elevation_deg, double roll_deg);
  /// Moves the model, in fractions of the view's height.
  void moveModel(double right, double up);
  void zoom(double factor);
  /// One frame of camera motion.
  void stepCamera(double seconds);

  /// Shows an error with its remedy in the view; hidden if empty.
  void setBanner(const QString& sentence);
  /// Shows one line at the bottom of the view.
  void setHint(const QString& hint);

  /// Adds a control at the bottom right of the view.
  void addFooterControl(QWidget* control);

  /// Renders if anything changed. True if it did.
  bool renderIfDirty();
  /// Nothing has moved for a second: neither array nor camera.
  bool isResting() const;

Q_SIGNALS:
  /// A double click on the view.
  void maximizeRequested();
  void presetChanged(perilymph::visualization::CameraPreset preset);

protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
  void addReadOuts();
  /// Captions of depth and angle, shorter where the view is narrow.
  void captionReadOuts();
  QString depth_mm_, tip_deg_;  ///< In the captions.
  void take(std::unique_ptr<visualization::InsertionScene> scene);
  void describeView();
  void placeHint();
  void placeBoneNote();
  void fitReadOuts();
  void captionShortly();
  /// How much the view's texts take, in the order in which they yield to the picture of a low view.
  enum class Texts {
    whole,
    compact,  ///< Smaller numbers, without the speed.
    low,      ///< Also without the captions and the line of phases.
  };
  int heightOf(Texts texts) const;
  void showTexts(Texts texts);
  int footMargin() const;
  void fitScene();
  ReadOutTips tips() const;
  double pictureHeight_mm() const;

  std::unique_ptr<visualization::InsertionScene> scene_;
  visualization::Stereo stereo_ = visualization::Stereo::off;
  StereoWindow* twin_ = nullptr;
  bool isDirty_ = true;
  double describedMagnification_ = 0.0;  ///< In the view's texts.
  int visitorLetter_px_ = 0;  ///< Size of the type for visitors; 0: for users of the workstation.
  Texts texts_ = Texts::whole;
  int hintLift_ = 0;  ///< Offset of the scale bars above a hint below them.
  QElapsedTimer sinceMotion_;
  QPoint mouse_;
  SceneLabels* labels_;
  QString boneNote_;
  bool isCutHeld_ = false;
  ReadOut* travel_;
  ReadOut* angle_;
  ReadOut* force_;
  ForceLabel* forceLabel_;
  ReadOut* speed_;
  Banner* banner_;
  QLabel* hint_;
  QLabel* magnification_;
  QLabel* viewName_;
  QHBoxLayout* foot_ = nullptr;
  PhaseLine* phase_;
};

}  // namespace perilymph::gui
