// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/Application.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QEvent>
#include <QLabel>
#include <QSurfaceFormat>
#include <clocale>
#include <exception>
#include <iostream>

#include "gui/widgets/FocusRing.h"
#include "gui/widgets/Theme.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::gui {

Application::Application(int& argc, char** argv) : QApplication(argc, argv)
{
  // Qt applies the user's locale; a decimal comma would break files and devices.
  std::setlocale(LC_NUMERIC, "C");
  setApplicationName(QStringLiteral("perilymph"));
  setApplicationDisplayName(QStringLiteral("Perilymph"));
  setApplicationVersion(QString::fromStdString(version()));
  setStyle(new FocusRingStyle);
  setFont(typeface(13));
}

namespace {

/// Makes labels show plain text: `<b>` in a patient's label is shown literally, and `<img>` loads
/// nothing. Includes Qt's tooltips and message boxes, which are labels.
void makePlain(QObject* receiver)
{
  auto* label = qobject_cast<QLabel*>(receiver);
  if (label != nullptr && label->textFormat() == Qt::AutoText) label->setTextFormat(Qt::PlainText);
}

}  // namespace

bool Application::notify(QObject* receiver, QEvent* event)
{
  if (event->type() == QEvent::Polish) makePlain(receiver);  // precedes the first painting
  QString sentence;
  try {
    return QApplication::notify(receiver, event);
  } catch (const std::exception& thrown) {
    sentence = tr("The action failed: %1").arg(QString::fromUtf8(thrown.what()));
  } catch (...) {
    sentence = tr("Something went wrong. See the log.");
  }
  std::cerr << sentence.toStdString() << '\n';
  if (tell_) tell_(sentence);
  return true;
}

void prepareQt()
{
  // Qt might choose EGL, which VTK cannot use.
  if (!qEnvironmentVariableIsSet("QT_XCB_GL_INTEGRATION"))
    qputenv("QT_XCB_GL_INTEGRATION", "xcb_glx");
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  // A timer paces the window. Waiting for the display's refresh in addition would round every frame
  // time up to a multiple of a sixtieth of a second (51 ms for 34 ms of work in software).
  format.setSwapInterval(0);
  QSurfaceFormat::setDefaultFormat(format);
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
}

}  // namespace perilymph::gui
