#pragma once

// The picture in the middle with the big numbers on it.

#include <QVTKOpenGLNativeWidget.h>

#include <memory>

#include "perilymph/foundation/Units.h"
#include "perilymph/haptics/Snapshot.h"
#include "perilymph/visualization/InsertionScene.h"

class QFrame;
class QHBoxLayout;
class QLabel;

namespace perilymph::gui {

class ForceLabel;
class PhaseLine;
class ReadOut;
class StereoWindow;

/// Shows the scene and its read-outs; the mouse turns, moves and zooms the model.
class OperationView : public QVTKOpenGLNativeWidget {
  Q_OBJECT
public:
  explicit OperationView(QWidget* parent);
  ~OperationView() override;

  /// The cochlea and the array to be shown from now on.
  void setScene(std::unique_ptr<visualization::InsertionScene> scene);
  /// The same cochlea and array drawn otherwise: what is seen from where stays.
  void replaceScene(std::unique_ptr<visualization::InsertionScene> scene);
  /// The scene; none before the first setScene().
  visualization::InsertionScene* scene() { return scene_.get(); }

  /// Moves the array of the picture.
  void showArray(const haptics::Snapshot& now);
  /// Writes the numbers.
  /// @param stopTravel  Where this insertion is at full depth.
  void showNumbers(const haptics::TickOutput& now, Length stopTravel);
  void setPartVisible(visualization::Part part, bool isVisible);

  void glideTo(visualization::CameraPreset preset);
  /// Quad-buffered stereo is shown by another window: here is what one eye sees.
  void setStereo(visualization::Stereo stereo);
  /// A window that shows the same from the same place, or none. It must outlive its being shown.
  void setTwin(StereoWindow* twin);
  visualization::Stereo stereo() const { return stereo_; }
  void turnModel(double azimuth_deg, double elevation_deg, double roll_deg);
  /// Moves the model by a share of the picture's height.
  void moveModel(double right, double up);
  void zoom(double factor);
  /// One frame of a glide.
  void stepCamera(double seconds);

  /// What happened and what to do, in place; empty hides it.
  void setBanner(const QString& sentence);
  /// One quiet line at the foot of the picture.
  void setHint(const QString& hint);

  /// Sets a control into the foot of the picture, at its right.
  void addToFoot(QWidget* control);

  /// Renders if something changed. True if it did.
  bool renderIfDirty();

Q_SIGNALS:
  /// A double click on the picture.
  void maximizeAsked();
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
  void take(std::unique_ptr<visualization::InsertionScene> scene);
  void describeView();
  void showStereo();
  void placeHint();
  double pictureHeight_mm() const;

  std::unique_ptr<visualization::InsertionScene> scene_;
  visualization::Stereo stereo_ = visualization::Stereo::off;
  StereoWindow* twin_ = nullptr;
  bool isDirty_ = true;
  int hintLift_ = 0;  ///< Height of the scale bars over a hint that lies under them.
  QPoint mouse_;
  ReadOut* travel_;
  ReadOut* angle_;
  ReadOut* force_;
  ForceLabel* forceLabel_;
  ReadOut* speed_;
  QFrame* banner_;
  QLabel* bannerText_;
  QLabel* hint_;
  QLabel* magnification_;
  QLabel* viewName_;
  QHBoxLayout* foot_ = nullptr;
  PhaseLine* phase_;
};

}  // namespace perilymph::gui
