// The workstation: words of the call, what the machine can draw, then the window.

#include <QTimer>
#include <exception>
#include <iostream>

#include "Application.h"
#include "Display.h"
#include "Errands.h"
#include "KioskWindow.h"
#include "MainWindow.h"
#include "Options.h"
#include "perilymph/foundation/RealTime.h"

namespace {

using namespace perilymph;

int refuse(const std::string& sentence)
{
  std::cerr << sentence << '\n';
  return 1;
}

/// Opens a window once the loop of events runs, so that it is on the screen before the cochlea is
/// built.
template <class Window>
int openAndRun(Window& window)
{
  QTimer::singleShot(0, &window, [&window] {
    const auto opened = window.open();
    if (opened) return;
    std::cerr << opened.error().message << '\n';
    QCoreApplication::exit(1);
  });
  return gui::Application::exec();
}

int runKiosk(gui::Application& application, session::Scenario scenario, const gui::Options& options)
{
  gui::KioskWindow window(std::move(scenario), gui::kioskBoardFile());
  application.onException([](const QString&) {});  // visitors are not told; standard error is
  QObject::connect(&window, &gui::KioskWindow::ended, &application,
                   [] { QCoreApplication::quit(); });
  gui::arrangeErrands(window, options);
  window.showFullScreen();
  return openAndRun(window);
}

int run(int argc, char** argv, const gui::Options& options)
{
  auto scenario = session::loadScenario(options.scenario.value_or("contour-published"));
  if (!scenario) return refuse(scenario.error().message);
  if (const auto display = gui::probeDisplay(); !display) return refuse(display.error().message);

  registerThreadRole(ThreadRole::ui);
  gui::prepareQt();
  gui::Application application(argc, argv);
  if (const auto openGl = gui::probeOpenGl(); !openGl) return refuse(openGl.error().message);

  if (options.isKiosk) return runKiosk(application, *std::move(scenario), options);
  gui::MainWindow window(*std::move(scenario), options.record);
  application.onException([&window](const QString& sentence) { window.showTrouble(sentence); });
  const bool isTold =
      options.scenario || options.isDemo || options.measuresFrames || options.record;
  if (!isTold) window.showPage(gui::Page::start);
  gui::arrangeErrands(window, options);
  window.show();
  return openAndRun(window);
}

}  // namespace

int main(int argc, char** argv)
{
  const auto words = gui::parseOptions(argc, argv);
  if (const auto* end = std::get_if<gui::Exit>(&words)) return end->status;
  try {
    return run(argc, argv, std::get<gui::Options>(words));
  } catch (const std::exception& thrown) {
    return refuse(std::string("The workstation could not go on: ") + thrown.what() + ".");
  }
}
