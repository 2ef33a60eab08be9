// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The program that writes the PDF report of a plan, called where there is no display.

#include <gtest/gtest.h>

#include <fstream>
#include <system_error>

#include "gui/run/UserSettings.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {

namespace fs = std::filesystem;

inline std::string textOf(const fs::path& pdf)
{
  return run({"pdftotext", {"-layout", pdf.string(), "-"}, {}, {}}).out;
}

class PlanReportPdf : public testing::Test {
protected:
  void SetUp() override
  {
    try {
      run({"pdftotext", {"-v"}, {}, {}});
    } catch (const std::system_error&) {
      GTEST_SKIP() << "Install the package poppler-utils.";
    }
  }
  void TearDown() override { gui::UserSettings().remove(QStringLiteral("report")); }

  /// Writes a plan's folder.
  void store(const planning::Plan& plan)
  {
    const auto json = planning::planJson(plan);
    ASSERT_TRUE(json) << json.error().message;
    std::ofstream(folder_ / "plan.json") << *json;
  }

  /// The program, called where there is no display.
  ProgramOutcome report(const fs::path& plan, const fs::path& file) const
  {
    return run(callOf(plan, file));
  }
  static ProgramCall callOf(const fs::path& plan, const fs::path& file)
  {
    ProgramCall call;
    call.program = programFolder() / "perilymph";
    call.arguments = {"--plan", plan.string(), "--report", file.string(), "--language", "en"};
    call.environment = {{"DISPLAY", std::nullopt}, {"XDG_RUNTIME_DIR", std::nullopt}};
    return call;
  }

  fs::path pdf() const { return folder_ / "plan.pdf"; }

  TemporaryFolder folder_;
};

}  // namespace perilymph::test
