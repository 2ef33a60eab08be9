// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/StereoWindow.h"

#include <QVTKInteractor.h>
#include <QVTKOpenGLWindow.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QEvent>
#include <QKeyEvent>

namespace perilymph::gui {

StereoWindow::StereoWindow(visualization::Stereo stereo, QObject* parent)
    : QObject(parent), stereo_(stereo)
{
  const bool hasTwoBuffers = stereo == visualization::Stereo::quadBuffered;
  vtkNew<vtkGenericOpenGLRenderWindow> buffers;
  buffers->SetMultiSamples(0);
  buffers->SetStereoCapableWindow(hasTwoBuffers ? 1 : 0);
  window_ = std::make_unique<QVTKOpenGLWindow>(buffers);
  QSurfaceFormat format = QVTKOpenGLWindow::defaultFormat(hasTwoBuffers);
  format.setSamples(0);
  format.setSwapInterval(0);  // the main window paces the frames
  window_->setFormat(format);
  window_->setTitle(tr("Perilymph stereo view"));
  window_->resize(960, 720);
  window_->setEnableHiDPI(false);  // the scene scales its texts itself
  if (window_->interactor() != nullptr) window_->interactor()->SetInteractorStyle(nullptr);
  window_->installEventFilter(this);
}

StereoWindow::~StereoWindow() = default;

void StereoWindow::setScene(std::unique_ptr<visualization::InsertionScene> scene)
{
  if (scene_) window_->renderWindow()->RemoveRenderer(&scene_->renderer());
  scene_ = std::move(scene);
  scene_->setScale(window_->devicePixelRatio());
  scene_->attachTo(*window_->renderWindow());
  scene_->setStereo(stereo_);
  if (!window_->isVisible()) window_->show();
}

void StereoWindow::renderAs(const visualization::InsertionScene& other)
{
  if (!scene_ || !window_->isExposed()) return;
  scene_->lookAs(other);
  window_->renderWindow()->Render();
}

bool StereoWindow::isOpen() const { return window_->isVisible(); }

void StereoWindow::close() const { window_->close(); }

bool StereoWindow::eventFilter(QObject* watched, QEvent* event)
{
  const int key =
      event->type() == QEvent::KeyPress ? static_cast<QKeyEvent*>(event)->key() : Qt::Key_unknown;
  const bool isEscape = key == Qt::Key_Escape;
  if (key == Qt::Key_F11) window_->setWindowStates(window_->windowStates() ^ Qt::WindowFullScreen);
  if (event->type() == QEvent::Close || isEscape) Q_EMIT closed();
  return QObject::eventFilter(watched, event);
}

}  // namespace perilymph::gui
