// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A picture that VTK draws out of sight, as an image.

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QRegion>
#include <functional>
#include <vector>

class vtkGenericOpenGLRenderWindow;
class vtkObject;

namespace perilymph::gui {

/// Gives a render window an OpenGL context of its own, and copies what VTK has drawn.
class CopiedPicture {
public:
  /// @param window   Must outlive the picture.
  /// @param onDrawn  Called with the pixels that changed, after each drawing but those by image().
  CopiedPicture(vtkGenericOpenGLRenderWindow& window, std::function<void(const QRegion&)> onDrawn);
  ~CopiedPicture();
  CopiedPicture(const CopiedPicture&) = delete;
  CopiedPicture& operator=(const CopiedPicture&) = delete;

  /// False if the display offers no context.
  bool isValid() const { return isValid_; }
  void resize(const QSize& size_px);
  /// The last picture in the present size; VTK draws one if there is none. The image is valid until the
  /// next drawing.
  const QImage& image();

private:
  bool makeCurrent() { return context_.makeCurrent(&surface_); }
  void handle(vtkObject* window, unsigned long event, void* data);
  /// Reads the picture from OpenGL, and copies what changed.
  QRegion copy();
  bool copyTile(const QRect& tile);

  vtkGenericOpenGLRenderWindow& window_;
  std::function<void(const QRegion&)> onDrawn_;
  QOpenGLContext context_;
  QOffscreenSurface surface_;
  std::vector<unsigned long> observers_;
  bool isValid_ = false;
  bool isDrawn_ = false;      ///< In the present size.
  bool isRequested_ = false;  ///< By image().
  QImage image_;
  QImage read_;  ///< The last drawing, the lowest row first.
};

}  // namespace perilymph::gui
