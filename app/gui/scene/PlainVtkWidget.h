// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A VTK widget without VTK's own handling of mouse, touch and pixel ratio.

#include <vtkNew.h>

#include <QImage>
#include <QWidget>
#include <memory>

class vtkGenericOpenGLRenderWindow;
class vtkRenderWindow;

namespace perilymph::gui {

class ComposedPicture;
class CopiedPicture;

/// A drag over the full height of a view rotates its model by half a turn.
inline constexpr double turnPerHeight_deg = 180.0;

/// How the picture of a view comes into its window.
enum class PictureWay {
  composed,  ///< OpenGL composes the whole window: no pixel leaves the graphics card.
  copied,    ///< Into the window's image. Where the processor draws, composing would cost more.
};
/// The way that suits the OpenGL renderer of this display.
PictureWay usualPictureWay();

/// A view whose mouse events are those of Qt. It has a render window without multisampling; what it
/// shows scales its texts itself. Its picture is opaque, and widgets in it lie above the picture.
class PlainVtkWidget : public QWidget {
  Q_OBJECT
public:
  explicit PlainVtkWidget(QWidget* parent, PictureWay way = usualPictureWay());
  ~PlainVtkWidget() override;

  vtkRenderWindow* renderWindow() const;
  /// VTK can draw: the view was shown.
  bool isValid() const;
  /// The picture without the widgets in it.
  QImage picture();

Q_SIGNALS:
  /// The window with the last picture was passed to the display.
  void presented();

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void fitPicture();
  void beginCopying();

  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  ComposedPicture* composed_ = nullptr;
  std::unique_ptr<CopiedPicture> copied_;  ///< Since the view was first painted.
};

}  // namespace perilymph::gui
