// SPDX-License-Identifier: BSD-3-Clause

// Tests of the real window, on the screen that test/support/with-display provides.

#include <gtest/gtest.h>

#include <QString>
#include <QTest>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "gui/program/Application.h"
#include "gui/program/DisplayProbe.h"
#include "gui/run/Background.h"
#include "perilymph/test/DicomServers.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/runTests.h"

namespace {

QtMessageHandler usual = nullptr;

/// A text whose places and values do not match fails the test that shows it.
void watchTexts(QtMsgType type, const QMessageLogContext& context, const QString& message)
{
  if (message.startsWith(QLatin1String("QString::arg"))) ADD_FAILURE() << message.toStdString();
  if (usual != nullptr) usual(type, context, message);
}

}  // namespace

int main(int argc, char** argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  if (GTEST_FLAG_GET(list_tests)) return perilymph::test::runTests();  // needs no display
  // Servers of the tests are reached by nothing outside. In such a network a display is reached by its file
  // alone, which an ending server of another test may take away: only where there are servers.
  const std::string filter = GTEST_FLAG_GET(filter);
  if (filter == "*" || filter.find("Archive") != std::string::npos)
    perilymph::test::makeOwnNetwork();
  const perilymph::test::TemporaryFolder data;  // keeps the tests' sessions apart from the user's
  setenv("XDG_DATA_HOME", data.path().c_str(), 1);
  setenv("XDG_CONFIG_HOME", (data.path() / "config").c_str(), 1);
  setenv("XDG_STATE_HOME", (data.path() / "state").c_str(), 1);
  std::filesystem::create_directories(data.path() / "config");
  std::ofstream(data.path() / "config" / "user-dirs.dirs")
      << "XDG_PICTURES_DIR=\"" << (data.path() / "pictures").string() << "\"\n";
  setenv("XDG_RUNTIME_DIR", data.path().c_str(), 1);
  if (const auto display = perilymph::gui::probeDisplay(); !display) {
    std::fprintf(stderr, "%s\n", display.error().message.c_str());
    return 77;
  }
  usual = qInstallMessageHandler(watchTexts);
  perilymph::gui::prepareQt();
  perilymph::gui::Application application(argc, argv);
  if (const auto openGl = perilymph::gui::probeOpenGl(); !openGl) {
    std::fprintf(stderr, "%s\n", openGl.error().message.c_str());
    return 77;
  }
  const int status = perilymph::test::runTests();
  if (perilymph::gui::Background::isAnyThreadLeft()) std::_Exit(status);
  return status;
}
