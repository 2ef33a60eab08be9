#include "Errands.h"

#include <QCoreApplication>
#include <QPixmap>
#include <QTimer>
#include <cstdio>
#include <iostream>

#include "KioskWindow.h"
#include "MainWindow.h"
#include "ProgramAge.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::gui {

namespace {

constexpr int pollInterval_ms = 100;

/// Ends the application with a sentence.
void fail(const std::string& sentence)
{
  std::cerr << sentence << '\n';
  QCoreApplication::exit(1);
}

void takeScreenshot(QWidget& window, const std::filesystem::path& file)
{
  const QPixmap picture = window.grab();
  const Result<Done> written = writeWhole(file, [&](const std::filesystem::path& place) {
    return picture.save(QString::fromStdString(place.string()), "PNG");
  });
  if (!written) return fail(written.error().message);
  QCoreApplication::exit(0);
}

void takeScreenshotLater(QWidget& window, const Options& options)
{
  if (!options.screenshot) return;
  QTimer::singleShot(int(options.after_s * 1e3), &window,
                     [&window, file = *options.screenshot] { takeScreenshot(window, file); });
}

/// Ends the application with the frame times once the demonstration has ended.
void reportFramesAtEnd(MainWindow& window)
{
  auto* poll = new QTimer(&window);
  QObject::connect(poll, &QTimer::timeout, &window, [&window] {
    const haptics::Workflow workflow = window.control().now().output.workflow;
    if (workflow == haptics::Workflow::fault)
      return fail("The demonstration ended with a fault; its frames were not measured to the end.");
    if (workflow != haptics::Workflow::finished) return;
    std::printf("%s\n", window.meter().report().c_str());
    std::fflush(stdout);
    QCoreApplication::exit(0);
  });
  poll->start(pollInterval_ms);
}

}  // namespace

void arrangeErrands(MainWindow& window, const Options& options)
{
  const bool isDemo = options.isDemo || options.measuresFrames;
  QObject::connect(&window, &MainWindow::firstFrameShown, &window, [&window, options, isDemo] {
    if (options.plugin) window.usePlugin(*options.plugin);
    if (isDemo) {
      std::printf("first frame after %.1f s\n", programAge_s());
      std::fflush(stdout);
      window.start();
    }
    if (options.measuresFrames) {
      window.restartMeter();
      reportFramesAtEnd(window);
    }
    takeScreenshotLater(window, options);
  });
}

void arrangeErrands(KioskWindow& window, const Options& options)
{
  QObject::connect(&window, &KioskWindow::firstFrameShown, &window,
                   [&window, options] { takeScreenshotLater(window, options); });
}

}  // namespace perilymph::gui
