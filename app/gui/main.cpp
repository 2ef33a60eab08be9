// The workstation: words of the call, what the machine can draw, then the window.

#include <QTimer>
#include <exception>
#include <iostream>

#include "Application.h"
#include "Display.h"
#include "Errands.h"
#include "InsertionViews.h"
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

int run(int argc, char** argv, const gui::Options& options)
{
  auto scenario = session::loadScenario(options.scenario.value_or("contour-published"));
  if (!scenario) return refuse(scenario.error().message);
  if (const auto display = gui::probeDisplay(); !display) return refuse(display.error().message);

  registerThreadRole(ThreadRole::ui);
  gui::prepareQt();
  gui::Application application(argc, argv);
  if (const auto openGl = gui::probeOpenGl(); !openGl) return refuse(openGl.error().message);

  gui::MainWindow window(*std::move(scenario), options.record);
  application.onException([&window](const QString& sentence) { window.showTrouble(sentence); });
  const bool isTold =
      options.scenario || options.isDemo || options.measuresFrames || options.record;
  if (!isTold) window.showPage(gui::Page::start);
  gui::arrangeErrands(window, options);
  window.views().drawBy(gui::openGlRenderer(),
                        options.quality ? gui::qualityNamed(*options.quality) : std::nullopt);
  window.views().refuseQuadBuffered(gui::quadBufferedTrouble());
  window.show();

  // Once the loop of events runs, so that the window is on the screen before the cochlea is built.
  QTimer::singleShot(0, &window, [&window] {
    const auto opened = window.open();
    if (opened) return;
    std::cerr << opened.error().message << '\n';
    QCoreApplication::exit(1);
  });
  return gui::Application::exec();
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
