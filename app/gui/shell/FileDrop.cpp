// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/FileDrop.h"

#include <QDropEvent>
#include <QMimeData>
#include <QUrl>
#include <QWidget>

namespace perilymph::gui {

namespace {

constexpr auto recordingEnding = ".insertion";
constexpr auto patientEnding = ".toml";

/// The one file that is dragged, if it is of a known kind; else empty.
std::filesystem::path fileOf(const QMimeData& data)
{
  const QList<QUrl> urls = data.urls();
  if (urls.size() != 1 || !urls[0].isLocalFile()) return {};
  const std::filesystem::path file = urls[0].toLocalFile().toStdString();
  const bool isKnown = file.extension() == recordingEnding || file.extension() == patientEnding;
  return isKnown ? file : std::filesystem::path();
}

}  // namespace

FileDrop::FileDrop(QWidget* window) : QObject(window)
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
  if (file.empty()) {
    drop->ignore();
    return true;
  }
  drop->acceptProposedAction();
  if (event->type() == QEvent::Drop) take(file);
  return true;
}

void FileDrop::take(const std::filesystem::path& file)
{
  if (file.extension() == recordingEnding)
    Q_EMIT recordingDropped(file);
  else
    Q_EMIT patientDropped(file);
}

}  // namespace perilymph::gui
