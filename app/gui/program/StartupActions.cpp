// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/StartupActions.h"

#include <QCoreApplication>
#include <QPixmap>
#include <QTimer>
#include <cstdio>
#include <iostream>

#include "gui/kiosk/KioskWindow.h"
#include "gui/program/BoneBenchmark.h"
#include "gui/program/FrameBenchmark.h"
#include "gui/program/ProcessUptime.h"
#include "gui/program/StudyBenchmark.h"
#include "gui/run/InputChoice.h"
#include "gui/shell/MainWindow.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::gui {

namespace {

/// Ends the application with an error message.
void fail(const std::string& sentence)
{
  std::cerr << sentence << '\n';
  QCoreApplication::exit(1);
}

void takeScreenshot(QWidget& window, const std::filesystem::path& file)
{
  const QPixmap picture = window.grab();
  const Result<void> written = writeWhole(file, [&](const std::filesystem::path& place) {
    return picture.save(QString::fromStdString(place.string()), "PNG");
  });
  if (!written) return fail(written.error().message);
  QCoreApplication::exit(0);
}

void takeScreenshotLater(QWidget& window, const CommandLine& options)
{
  if (!options.screenshot) return;
  QTimer::singleShot(int(options.after_s * 1e3), &window,
                     [&window, file = *options.screenshot] { takeScreenshot(window, file); });
}

/// Starts with the device that the command line names, which may still be opened in the background.
void startOnceOpened(InsertionController& insertion)
{
  if (insertion.openingText().isEmpty()) return insertion.start();
  auto* waiting = new QObject(&insertion);
  QObject::connect(&insertion, &InsertionController::prepared, waiting, [&insertion, waiting] {
    waiting->deleteLater();
    if (insertion.control().input() == InputSource::device) insertion.start();
  });
}

}  // namespace

void arrangeStartupActions(MainWindow& window, const CommandLine& options)
{
  const bool isDemo = options.isDemo || (options.measuresFrames && !options.study && !options.bone);
  QObject::connect(&window, &MainWindow::firstFrameShown, &window, [&window, options, isDemo] {
    if (options.plugin) window.insertion().useDevice(*options.plugin);
    if (options.device) window.insertion().useDevice(inputNamed(*options.device));
    if (isDemo) {
      std::printf("first frame after %.1f s\n", processUptime_s());
      std::fflush(stdout);
      if (!options.measuresFrames) startOnceOpened(window.insertion());
    }
    if (options.measuresFrames && options.study)
      measureStudyFrames(window, *options.study);
    else if (options.measuresFrames && options.bone)
      measureBoneFrames(window, *options.bone);
    else if (options.measuresFrames)
      measureFrames(window, options.measuredTicks);
    else if (options.study)
      window.openOnPage(QStringLiteral("studies"), *options.study);
    else if (options.file)
      window.openFile(*options.file);
    takeScreenshotLater(window, options);
  });
}

void arrangeStartupActions(KioskWindow& window, const CommandLine& options)
{
  QObject::connect(&window, &KioskWindow::firstFrameShown, &window,
                   [&window, options] { takeScreenshotLater(window, options); });
}

}  // namespace perilymph::gui
