// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Recorded insertions and their PDF reports, as read by poppler.

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLocale>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <regex>
#include <stdexcept>
#include <string>
#include <system_error>

#include "gui/program/Languages.h"
#include "gui/report/InsertionReport.h"
#include "gui/run/UserSettings.h"
#include "perilymph/device/ScriptedDevice.h"
#include "perilymph/session/Insertion.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {

namespace fs = std::filesystem;

class PdfReport : public testing::Test {
protected:
  void SetUp() override
  {
    if (!has("pdftotext")) GTEST_SKIP() << "Install the package poppler-utils.";
  }
  void TearDown() override
  {
    gui::UserSettings().remove(QStringLiteral("report"));
    gui::useLanguage(*QCoreApplication::instance(), QStringLiteral("en"));
    QLocale::setDefault(QLocale::c());
  }

  static void SetUpTestSuite() { kept_ = std::make_unique<TemporaryFolder>(); }
  static void TearDownTestSuite()
  {
    recordings_.clear();
    kept_.reset();
  }

  /// The recording of an insertion, made by the first case that asks for it.
  static fs::path recordingOf(const std::string& scenarioName, const session::Overrides& overrides)
  {
    std::string key = scenarioName;
    for (const auto& [name, value] : overrides) key += ' ' + name + '=' + value;
    const auto kept = recordings_.find(key);
    if (kept != recordings_.end()) return kept->second;
    const auto scenario = session::loadScenario(scenarioName, overrides);
    if (!scenario) throw std::runtime_error(scenario.error().message);
    const fs::path file = *kept_ / (std::to_string(recordings_.size()) + ".insertion");
    auto insertion = session::Insertion::prepare(
        *scenario,
        std::make_unique<device::ScriptedDevice>(scenario->speed().si(), scenario->timeStep().si()),
        file);
    if (!insertion) throw std::runtime_error(insertion.error().message);
    const auto run = (*insertion)->runToEnd([](const haptics::TickRecord&) { return true; });
    if (!run) throw std::runtime_error(run.error().message);
    return recordings_[key] = file;
  }

  /// Writes the report of an insertion.
  void report(const std::string& scenarioName, const session::Overrides& overrides)
  {
    const fs::path recording = recordingOf(scenarioName, overrides);
    const auto content = gui::gatherReport(recording, {});
    ASSERT_TRUE(content) << content.error().message;
    const auto written = gui::writeReport(*content, pdf());
    ASSERT_TRUE(written) << written.error().message;
  }

  /// A patient with a left ear, A 0.9 SD below and B 0.5 SD above the population mean.
  static std::string leftPatient()
  {
    const fs::path file = *kept_ / "P-017.toml";
    std::ofstream(file) << "label = \"P-017\"\nside = \"left\"\na_mm = 8.84\nb_mm = 6.98\n";
    return file.string();
  }

  const fs::path& folder() const { return folder_.path(); }
  fs::path pdf() const { return folder_.path() / "report.pdf"; }

  /// The text of pages, in its layout.
  std::string text(int first = 1, int last = 99) const
  {
    return outputOf("pdftotext", {"-layout", "-f", std::to_string(first), "-l",
                                  std::to_string(last), pdf().string(), "-"});
  }
  int pages() const
  {
    const std::string facts = outputOf("pdfinfo", {pdf().string()});
    std::smatch found;
    return std::regex_search(facts, found, std::regex("Pages: +([0-9]+)")) ? std::stoi(found[1])
                                                                           : 0;
  }
  static std::string outputOf(const std::string& program, std::vector<std::string> arguments)
  {
    return run({program, std::move(arguments), {}, {}}).out;
  }

private:
  static bool has(const std::string& program)
  {
    try {
      run({program, {"-v"}, {}, {}});
      return true;
    } catch (const std::system_error&) {
      return false;
    }
  }

  static inline std::unique_ptr<TemporaryFolder> kept_;  ///< Shared by the cases of the suite.
  static inline std::map<std::string, fs::path> recordings_;
  TemporaryFolder folder_;
};

}  // namespace perilymph::test
