// SPDX-License-Identifier: BSD-3-Clause

// Data that persists: settings, log, and the marker of a crash.

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QLineEdit>
#include <QLocale>
#include <QTest>
#include <atomic>
#include <fstream>
#include <future>
#include <iterator>
#include <new>
#include <stop_token>

#include "OwnFolders.h"
#include "WindowRig.h"
#include "gui/program/CrashMarker.h"
#include "gui/program/CrashRecovery.h"
#include "gui/program/Logging.h"
#include "gui/run/UserSettings.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Notice.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/StateFolder.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

class KeptSettings : public testing::Test {
protected:
  ~KeptSettings() override { gui::UserSettings().clear(); }

  static void write(const char* text)
  {
    const QString file = gui::UserSettings().fileName();
    std::ofstream(file.toStdString()) << text;
    QSettings(file, QSettings::IniFormat).sync();
  }
};

TEST_F(KeptSettings, SayTheirFormat)
{
  EXPECT_EQ(gui::UserSettings().value("format").toInt(), gui::UserSettings::format);
}

TEST_F(KeptSettings, AreThereForTheNextStart)
{
  gui::UserSettings().setValue("look", "light");
  EXPECT_EQ(gui::UserSettings().word("look", {"dark", "light"}), "light");
}

TEST_F(KeptSettings, OfAnUnknownFormatAreForgotten)
{
  {
    gui::UserSettings settings;
    settings.setValue("look", "light");
    settings.setValue("format", 99);
  }
  EXPECT_EQ(gui::UserSettings().word("look", {"dark", "light"}), "dark");
  EXPECT_EQ(gui::UserSettings().value("format").toInt(), gui::UserSettings::format);
}

TEST_F(KeptSettings, AWordThatIsNotAllowedCountsAsNotSet)
{
  gui::UserSettings().setValue("look", "plaid");
  EXPECT_EQ(gui::UserSettings().word("look", {"dark", "light"}), "dark");
}

TEST_F(KeptSettings, ThatAreDamagedAreForgotten)
{
  write("\x01\x02[[[=\nnonsense");
  EXPECT_EQ(gui::UserSettings().word("look", {"dark", "light"}), "dark");
}

TEST(Log, IsInTheStateFolder)
{
  EXPECT_EQ(stateFolder(),
            std::filesystem::path(qgetenv("XDG_STATE_HOME").toStdString()) / "perilymph");
}

TEST(Log, ContainsTheMessages)
{
  const TemporaryFolder folder;
  const auto before = spdlog::default_logger();
  ASSERT_TRUE(gui::startLog(folder.path()));
  spdlog::warn("The tip is at {} mm.", 12.5);
  qWarning("Qt has a word to say.");
  spdlog::set_default_logger(before);
  const auto text = readWhole(folder.path() / "perilymph.log");
  ASSERT_TRUE(text);
  EXPECT_NE(text->find("The tip is at 12.5 mm."), std::string::npos);
  EXPECT_NE(text->find("Qt has a word to say."), std::string::npos);
}

TEST(Log, IsBounded)
{
  const TemporaryFolder folder;
  const auto before = spdlog::default_logger();
  ASSERT_TRUE(gui::startLog(folder.path()));
  const std::string line(1000, 'x');
  for (int i = 0; i < 8000; ++i) spdlog::warn("{}", line);  // 8 MB
  spdlog::set_default_logger(before);
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    bytes += entry.file_size();
  EXPECT_LE(bytes, 5u << 20);
}

TEST(Log, ThatCannotBeWrittenIsReported)
{
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "taken") << "a file where a folder is needed";
  const auto log = gui::startLog(folder.path() / "taken" / "below");
  ASSERT_FALSE(log);
  EXPECT_NE(log.error().message.find("XDG_STATE_HOME"), std::string::npos);
}

TEST(Log, IsNotWrittenThroughALink)
{
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "thesis") << "three years";
  std::filesystem::create_symlink("thesis", folder.path() / "perilymph.log");
  const auto log = gui::startLog(folder.path());
  ASSERT_FALSE(log);
  EXPECT_NE(log.error().message.find("is a link"), std::string::npos);
  EXPECT_EQ(std::filesystem::file_size(folder.path() / "thesis"), 11u);
}

/// The id of a process that has ended.
long endedProcess()
{
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  return child;
}

TEST(CrashMarker, OfAProgramThatIsGoneNamesItsRecordingOnce)
{
  const TemporaryFolder folder;
  const auto recording = folder.path() / "one.insertion";
  std::ofstream(recording) << "kept";
  std::ofstream(folder.path() / ("running-" + std::to_string(endedProcess())))
      << recording.string() << '\n';
  EXPECT_EQ(gui::CrashMarker::takeCrashed(folder.path()), std::vector{recording});
  EXPECT_TRUE(gui::CrashMarker::takeCrashed(folder.path()).empty());
}

TEST(CrashMarker, OfAProgramThatRunsIsLeftAlone)
{
  const TemporaryFolder folder;
  const auto recording = folder.path() / "one.insertion";
  std::ofstream(recording) << "kept";
  gui::CrashMarker mark(folder.path());
  mark.setRecording(recording);
  EXPECT_TRUE(gui::CrashMarker::takeCrashed(folder.path()).empty());
}

TEST(CrashMarker, IsGoneAfterAGoodEnd)
{
  const TemporaryFolder folder;
  {
    const gui::CrashMarker mark(folder.path());
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(CrashMarker, OfADeletedRecordingIsIgnored)
{
  const TemporaryFolder folder;
  std::ofstream(folder.path() / ("running-" + std::to_string(endedProcess())))
      << (folder.path() / "gone.insertion").string() << '\n';
  EXPECT_TRUE(gui::CrashMarker::takeCrashed(folder.path()).empty());
}

/// The list entry of a recorded insertion to a depth of 3 mm.
session::SessionSummary threeMillimeters(const std::filesystem::path& file,
                                         const std::stop_token& = {})
{
  session::SessionSummary summary;
  summary.file = file;
  summary.highlights.ticks = 1500;
  summary.highlights.deepest = 3e-3;
  summary.highlights.duration = 1.4;
  return summary;
}

TEST(AnInterruptedInsertion, IsOfferedWithItsDepth)
{
  WindowRig rig;
  gui::offerRecovery(rig.window(), {"tuesday.insertion"}, threeMillimeters);
  Q_EMIT rig.window().firstFrameShown();
  ASSERT_TRUE(WindowRig::waitUntil([&] { return rig.window().notice().isVisible(); }));
  EXPECT_TRUE(rig.window().notice().sentence().contains("3.0 mm"));
  EXPECT_TRUE(rig.window().notice().sentence().contains("tuesday"));
}

TEST(AnInterruptedInsertion, IsNotOfferedIfItCannotBeReplayed)
{
  const TemporaryFolder folder;
  const auto stored = testData() / "recordings/contour-published-points.insertion";
  EXPECT_GT(gui::summarizeReplayable(stored, {}).highlights.ticks, 0u);
  // A number of its scenario is changed: its hash is another.
  std::ifstream stream(stored, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(stream), {});
  const std::size_t place = bytes.find("start_inside_mm = 2.0");
  ASSERT_NE(place, std::string::npos);
  bytes[place + 18] = '1';
  const auto forged = folder.path() / "forged.insertion";
  std::ofstream(forged, std::ios::binary) << bytes;
  EXPECT_GT(session::summarize(forged, {}).highlights.ticks, 0u);
  EXPECT_EQ(gui::summarizeReplayable(forged, {}).highlights.ticks, 0u);
}

TEST(AnInterruptedInsertion, WhoseRecordingBlocksItsReaderDoesNotBlockTheWindow)
{
  std::promise<void> gate;
  auto opened = gate.get_future().share();
  {
    WindowRig rig;
    gui::offerRecovery(rig.window(), {"bad.insertion"},
                       [opened](const std::filesystem::path& file, const std::stop_token&) {
                         opened.wait();
                         return threeMillimeters(file);
                       });
    Q_EMIT rig.window().firstFrameShown();
    rig.click("startButton");
    EXPECT_TRUE(WindowRig::waitUntil([&] { return rig.travel_mm() > 0.1; }));
  }
  gate.set_value();
}

TEST(AnInterruptedInsertion, WhoseRecordingNeedsTooMuchMemoryDoesNotEndTheWindow)
{
  WindowRig rig;
  std::atomic<bool> wasRead{false};
  gui::offerRecovery(
      rig.window(), {"bad.insertion"},
      [&wasRead](const std::filesystem::path&, const std::stop_token&) -> session::SessionSummary {
        wasRead = true;
        throw std::bad_alloc();
      });
  Q_EMIT rig.window().firstFrameShown();
  rig.click("startButton");
  EXPECT_TRUE(WindowRig::waitUntil([&] { return wasRead && rig.travel_mm() > 0.1; }));
}

/// A window in a locale with decimal commas: 9,1.
class CommaLocale : public testing::Test {
protected:
  CommaLocale() { QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany)); }
  ~CommaLocale() override { QLocale::setDefault(QLocale::c()); }
};

TEST_F(CommaLocale, NumbersAreShownWithAComma)
{
  EXPECT_EQ(gui::numberText(9.1, 1), "9,1");
  WindowRig rig;
  EXPECT_TRUE(rig.readOut("travelReadOut").contains(QLatin1Char(',')));
}

class TypedNumber : public CommaLocale, public testing::WithParamInterface<const char*> {};

TEST_P(TypedNumber, WithACommaOrAPointIsTheSameAndTheFileHasAPoint)
{
  const DataFolder data;
  WindowRig rig;
  rig.window().showPage("start");
  rig.click("patientCard");
  rig.click("byBasalTurn");
  const auto type = [&rig](const char* field, const char* text) {
    auto* line = rig.window().findChild<QLineEdit*>(QLatin1String(field));
    line->clear();
    QTest::keyClicks(line, QLatin1String(text));
  };
  type("patientName", "comma");
  type("aValue", GetParam());
  type("bValue", "6,5");
  rig.click("usePatientButton");
  ASSERT_TRUE(WindowRig::waitUntil(
      [&] { return rig.window().control().scenario().patient().basalTurn.has_value(); }));
  EXPECT_EQ(rig.window().control().scenario().patient().basalTurn->a, millimeters(9.1));
  const auto text = readWhole(patientFolder() / "comma-right.toml");
  ASSERT_TRUE(text) << text.error().message;
  EXPECT_NE(text->find("a_mm = 9.1"), std::string::npos) << *text;
  EXPECT_EQ(text->find("9,1"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(OfAPerson, TypedNumber, testing::Values("9,1", "9.1", "9.10"));

}  // namespace
}  // namespace perilymph::test
