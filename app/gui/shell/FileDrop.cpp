// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/FileDrop.h"

#include <QDropEvent>
#include <QMimeData>
#include <QUrl>

#include "gui/shell/PageStack.h"

namespace perilymph::gui {

namespace {

/// The one file or folder that is dragged; else empty.
std::filesystem::path fileOf(const QMimeData& data)
{
  const QList<QUrl> urls = data.urls();
  if (urls.size() != 1 || !urls[0].isLocalFile()) return {};
  return urls[0].toLocalFile().toStdString();
}

}  // namespace

FileDrop::FileDrop(const PageStack& pages, QWidget* window) : QObject(window), pages_(pages)
{
  window->setAcceptDrops(true);
  window->installEventFilter(this);
}

bool FileDrop::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
    return QObject::eventFilter(watched, event);
  auto* drop = static_cast<QDropEvent*>(event);
  const std::filesystem::path file = fileOf(*drop->mimeData());
  Page* page = pages_.pageFor(file);
  if (page == nullptr) {
    drop->ignore();
    return true;
  }
  drop->acceptProposedAction();
  if (event->type() == QEvent::Drop) page->open(file);
  return true;
}

}  // namespace perilymph::gui
