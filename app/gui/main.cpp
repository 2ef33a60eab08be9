// SPDX-License-Identifier: BSD-3-Clause

// The workstation: parses the command line, checks the display, then opens the window.

#include <spdlog/spdlog.h>

#include <QGuiApplication>
#include <QScreen>
#include <QTimer>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "gui/kiosk/KioskWindow.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/program/Application.h"
#include "gui/program/CommandLine.h"
#include "gui/program/CrashMarker.h"
#include "gui/program/CrashRecovery.h"
#include "gui/program/DisplayProbe.h"
#include "gui/program/FreedMemory.h"
#include "gui/program/Languages.h"
#include "gui/program/Logging.h"
#include "gui/program/PlanReporting.h"
#include "gui/program/PrivateFiles.h"
#include "gui/program/ScreenLock.h"
#include "gui/program/StartupActions.h"
#include "gui/program/TerminationSignals.h"
#include "gui/run/Background.h"
#include "gui/run/InsertionBroadcast.h"
#include "gui/run/UserSettings.h"
#include "gui/scene/RendererName.h"
#include "gui/setup/SetupHistory.h"
#include "gui/shell/MainWindow.h"
#include "gui/shell/Navigation.h"
#include "gui/shell/SettingsOverlay.h"
#include "gui/shell/WindowMemory.h"
#include "gui/shell/WindowPlace.h"
#include "gui/widgets/Theme.h"
#include "perilymph/foundation/RealTime.h"
#include "perilymph/foundation/RenamedKeys.h"
#include "perilymph/foundation/StateFolder.h"
#include "perilymph/foundation/Version.h"

namespace {

using namespace perilymph;

constexpr int openAnew = 1000;  // not an exit status: the window closes and is opened again

int refuse(const std::string& sentence)
{
  std::cerr << sentence << '\n';
  return 1;
}

/// Opens a window when the event loop runs, so that it is visible before the cochlea is built.
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

/// Exit status that a shell expects after a signal.
int statusOf(int signal) { return 128 + signal; }

void logClients(const gui::InsertionBroadcast& broadcast)
{
  QObject::connect(&broadcast, &gui::InsertionBroadcast::clientRefused, &broadcast,
                   [](const QString& sentence) { spdlog::warn("{}", sentence.toStdString()); });
}

int runKiosk(gui::Application& application, const gui::TerminationSignals& signals,
             session::Scenario scenario, const gui::CommandLine& options)
{
  gui::KioskWindow window(std::move(scenario), gui::kioskBoardFile());
  application.onException([](const QString&) {});  // not shown to visitors, but on standard error
  QObject::connect(&window, &gui::KioskWindow::ended, &application,
                   [] { QCoreApplication::quit(); });
  QObject::connect(&window, &gui::KioskWindow::languageRequested, &application,
                   [&application](const QString& word) { gui::useLanguage(application, word); });
  QObject::connect(&signals, &gui::TerminationSignals::received, &window,
                   [](int signal) { QCoreApplication::exit(statusOf(signal)); });
  const gui::ScreenLock screen(nullptr);
  QObject::connect(&screen, &gui::ScreenLock::locked, &window, &gui::KioskWindow::stopDevice);
  gui::InsertionBroadcast broadcast([&window] { return gui::shownBy(window.control()); }, nullptr);
  logClients(broadcast);
  if (options.igtl)  // a booth listens only if it is told to
    if (const auto listening = broadcast.listen(*options.igtl); !listening)
      return refuse(listening.error().message);
  gui::arrangeStartupActions(window, options);
  window.showFullScreen();
  return openAndRun(window);
}

/// Initial state of a window.
struct Beginning {
  session::Scenario scenario;
  QString page = QStringLiteral("start");
  gui::CommandLine options;  ///< Startup actions apply to the first window only.
  std::vector<std::filesystem::path> interrupted;
  std::optional<gui::WindowMemory> memory;  ///< From the previous window.
  std::shared_ptr<gui::CochleaStore> cochleae = std::make_shared<gui::CochleaStore>();
};

/// How a window ended: with an exit status, or to be opened again.
struct WindowEnd {
  int status = 0;
  std::optional<Beginning> next;
};

WindowEnd runWindow(gui::Application& application, const gui::TerminationSignals& signals,
                    const Beginning& beginning)
{
  const gui::CommandLine& options = beginning.options;
  QGuiApplication::setQuitOnLastWindowClosed(true);
  gui::CrashMarker mark(stateFolder());
  gui::MainWindow window(beginning.scenario, options.record, beginning.cochleae);
  application.onException([&window](const QString& sentence) { window.showError(sentence); });
  window.showPage(beginning.page);
  if (beginning.memory) gui::resume(window, *beginning.memory);
  gui::arrangeStartupActions(window, options);
  window.views().drawBy(gui::openGlRenderer(),
                        options.quality ? gui::qualityNamed(*options.quality) : std::nullopt);
  window.views().offerQuadBuffered(gui::quadBufferedError(gui::hasStereoBuffers()));
  gui::offerRecovery(window, beginning.interrupted);
  QObject::connect(&window, &gui::MainWindow::recordingChanged, &window,
                   [&window, &mark] { mark.setRecording(window.control().recording()); });
  QObject::connect(&signals, &gui::TerminationSignals::received, &window, [&window](int signal) {
    window.insertion().safety().end();
    QCoreApplication::exit(statusOf(signal));
  });
  const gui::ScreenLock screen(nullptr);
  QObject::connect(&screen, &gui::ScreenLock::locked, &window.insertion(),
                   &gui::InsertionController::stopDevice);
  QObject::connect(&window, &gui::MainWindow::reopenRequested, &window,
                   [] { QCoreApplication::exit(openAnew); });
  // a screenshot or a benchmark uses the default size, not the last one
  const bool isPlain = !options.screenshot && !options.measuresFrames;
  if (isPlain) gui::restorePlace(window);
  logClients(window.navigation().broadcast());
  if (!options.igtl && isPlain) window.navigation().listenAsSet();
  if (options.igtl && !window.navigation().listen(*options.igtl, options.igtlCoordinates) &&
      !beginning.memory)
    return {refuse(window.navigation().status().toStdString()), std::nullopt};
  window.show();
  const int status = openAndRun(window);
  if (isPlain) gui::keepPlace(window);
  application.onException({});
  if (status != openAnew) return {status, std::nullopt};
  QGuiApplication::setQuitOnLastWindowClosed(false);  // closing it does not end the program
  gui::CommandLine kept;
  kept.quality = options.quality;
  kept.plugin = options.plugin;
  kept.igtl = window.navigation().broadcast().endpoint();
  kept.igtlCoordinates = window.navigation().broadcast().coordinates();
  return {0, Beginning{window.control().scenario(),
                       window.page(),
                       kept,
                       {},
                       gui::memoryOf(window),
                       beginning.cochleae}};
}

/// Applies the user's settings, or those of this call.
void applyChoices(gui::Application& application, const gui::CommandLine& options)
{
  const gui::UserSettings settings;
  const QString look = settings.word(QStringLiteral("look"), gui::colorSchemeText());
  gui::setShownColorScheme(look == QLatin1String("light") ? gui::ColorScheme::light
                                                          : gui::ColorScheme::dark);
  const double textScale =
      settings.word(QStringLiteral("textSize"), gui::textSizeText(), gui::normalTextSize)
          .toDouble() /
      100.0;
  const QScreen* screen = QGuiApplication::primaryScreen();
  gui::setTextScale(screen == nullptr
                        ? textScale
                        : gui::fittingTextScale(textScale, screen->availableGeometry()));
  gui::useLanguage(application, options.language ? QString::fromStdString(*options.language)
                                                 : settings.word(QStringLiteral("language"),
                                                                 gui::languageText()));
}

/// Ends the program at once if a thread cannot be ended: it may still use objects that are
/// destroyed after main().
void leaveThreads(int status)
{
  if (!gui::Background::isAnyThreadLeft()) return;
  spdlog::warn("A file that could not be read to its end keeps a thread from ending.");
  spdlog::shutdown();
  std::fflush(nullptr);
  std::_Exit(status);
}

/// Writes a plan's report: no display, no window.
int runReport(int argc, char** argv, const gui::CommandLine& options)
{
  const auto content = gui::reportedPlan(options);
  if (!content) return refuse(content.error().message);
  gui::drawWithoutDisplay();
  gui::Application application(argc, argv);
  applyChoices(application, options);
  const auto written = gui::writeReport(*content, options);
  return written ? 0 : refuse(written.error().message);
}

int run(int argc, char** argv, const gui::CommandLine& options)
{
  gui::keepFilesPrivate();
  if (options.plan) return runReport(argc, argv, options);
  auto scenario = session::loadScenario(
      options.scenario.value_or(options.isKiosk ? "booth" : "contour-published"));
  if (!scenario) return refuse(scenario.error().message);
  if (const auto display = gui::probeDisplay(); !display) return refuse(display.error().message);

  gui::keepFreedMemory();
  gui::prepareQt();
  gui::Application application(argc, argv);
  const gui::TerminationSignals signals(nullptr);
  if (const auto openGl = gui::probeOpenGl(); !openGl) return refuse(openGl.error().message);
  if (const auto log = gui::startLog(stateFolder()); !log)
    std::cerr << log.error().message << '\n';  // the window works without it
  gui::prepareOwnFolders();
  spdlog::info("perilymph {} begins.", buildId());
  setWarningHandler([](const std::string& warning) { spdlog::warn("{}", warning); });

  applyChoices(application, options);
  if (options.isKiosk) return runKiosk(application, signals, *std::move(scenario), options);
  const bool isTold = options.scenario || options.isDemo || options.measuresFrames ||
                      options.record || options.plugin;
  WindowEnd end =
      runWindow(application, signals,
                {*std::move(scenario), isTold ? QStringLiteral("insert") : QStringLiteral("start"),
                 options, gui::CrashMarker::takeCrashed(stateFolder()), std::nullopt});
  while (end.next) {
    applyChoices(application, end.next->options);
    end = runWindow(application, signals, Beginning(*std::move(end.next)));
  }
  spdlog::info("perilymph ends with status {}.", end.status);
  leaveThreads(end.status);
  return end.status;
}

}  // namespace

int main(int argc, char** argv)
{
  const auto text = gui::parseCommandLine(argc, argv);
  if (const auto* end = std::get_if<gui::Exit>(&text)) return end->status;
  declareThread(ThreadRole::window);
  try {
    return run(argc, argv, std::get<gui::CommandLine>(text));
  } catch (const std::exception& thrown) {
    return refuse(std::string("The workstation could not go on: ") + thrown.what() + ".");
  }
}
