#include "gui/program/Application.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QEvent>
#include <QLabel>
#include <QSurfaceFormat>
#include <clocale>
#include <exception>
#include <iostream>

#include "gui/parts/Theme.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::gui {

Application::Application(int& argc, char** argv) : QApplication(argc, argv)
{
  // Qt takes over the user's locale; a decimal comma would break files and devices.
  std::setlocale(LC_NUMERIC, "C");
  setApplicationName(QStringLiteral("perilymph"));
  setApplicationDisplayName(QStringLiteral("Perilymph"));
  setApplicationVersion(QString::fromStdString(version()));
  setStyle(QStringLiteral("Fusion"));
  setFont(typeface(13));
}

namespace {

/// Text of a file or of a person is text: `<b>` in a patient's label is drawn as it stands, and
/// `<img>` loads nothing. Holds for tips and boxes of Qt, too, which are labels.
void makePlain(QObject* receiver)
{
  auto* label = qobject_cast<QLabel*>(receiver);
  if (label != nullptr && label->textFormat() == Qt::AutoText) label->setTextFormat(Qt::PlainText);
}

}  // namespace

bool Application::notify(QObject* receiver, QEvent* event)
{
  if (event->type() == QEvent::Polish) makePlain(receiver);  // comes before the first drawing
  QString sentence;
  try {
    return QApplication::notify(receiver, event);
  } catch (const std::exception& thrown) {
    sentence = tr("The window could not do that: %1").arg(QString::fromUtf8(thrown.what()));
  } catch (...) {
    sentence = tr("The window could not do that, and does not know why.");
  }
  std::cerr << sentence.toStdString() << '\n';
  if (tell_) tell_(sentence);
  return true;
}

void prepareQt()
{
  // Qt could also choose EGL, which VTK cannot use.
  if (!qEnvironmentVariableIsSet("QT_XCB_GL_INTEGRATION"))
    qputenv("QT_XCB_GL_INTEGRATION", "xcb_glx");
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  // The window paces itself by a timer. Waiting for the display's refresh on top of it would round
  // every frame up to the next sixtieth of a second (51 ms for 34 ms of work in software).
  format.setSwapInterval(0);
  QSurfaceFormat::setDefaultFormat(format);
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
}

}  // namespace perilymph::gui
