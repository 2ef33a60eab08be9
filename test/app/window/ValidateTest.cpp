// SPDX-License-Identifier: BSD-3-Clause

// The published experiment repeated in the window.

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QTest>

#include "WindowRig.h"
#include "gui/pages/validate/ValidatePage.h"
#include "gui/widgets/DrawingView.h"

namespace perilymph::test {
namespace {

class ValidationPage : public testing::Test {
protected:
  ValidationPage() { rig_.click("validatePageButton"); }

  gui::ValidatePage& page() { return *rig_.window().findChild<gui::ValidatePage*>(); }
  void setRuns(int runs) { typeRuns(QByteArray::number(runs).constData()); }
  void typeRuns(const char* text)
  {
    auto* field = rig_.window().findChild<QLineEdit*>("validationRuns");
    field->clear();
    QTest::keyClicks(field, QLatin1String(text));
  }
  /// The text of a figure.
  bool figureSays(const std::string& caption)
  {
    for (const figures::Mark& mark : page().findChild<gui::DrawingView*>()->drawing().marks)
      if (const auto* said = std::get_if<figures::Label>(&mark))
        if (said->text.find(caption) != std::string::npos) return true;
    return false;
  }
  int verdicts(const char* word)
  {
    int count = 0;
    for (const QLabel* label : page().findChildren<QLabel*>())
      count += label->text().endsWith(QString::fromUtf8(word)) ? 1 : 0;
    return count;
  }

  WindowRig rig_;
};

TEST_F(ValidationPage, SaysWhatItDoesBeforeAnythingWasRun)
{
  EXPECT_EQ(rig_.window().page(), "validate");
  EXPECT_TRUE(rig_.button("validateButton").isEnabled());
  EXPECT_FALSE(rig_.button("saveValidationButton").isEnabled());
  EXPECT_FALSE(rig_.button("simulationFigure").isEnabled());
  EXPECT_TRUE(figureSays("travel"));
  EXPECT_EQ(verdicts("✓ met") + verdicts("missed"), 0);
}

TEST_F(ValidationPage, RefusesANumberThatIsOutOfRangeInWords)
{
  const auto* error = page().findChild<QLabel*>("validationRunsError");
  for (const char* typed : {"0", "1", "1001", "99999999", "", "ten"}) {
    typeRuns(typed);
    EXPECT_FALSE(rig_.button("validateButton").isEnabled()) << typed;
    EXPECT_TRUE(error->isVisible()) << typed;
    EXPECT_TRUE(error->text().contains("from 2 to 1000")) << typed;
    EXPECT_EQ(page().findChild<QLineEdit*>("validationRuns")->text(), typed);
  }
  typeRuns("12");
  EXPECT_TRUE(rig_.button("validateButton").isEnabled());
  EXPECT_FALSE(error->isVisible());
}

TEST_F(ValidationPage, CountsTheInsertionsThatWereAskedFor)
{
  setRuns(12);
  rig_.click("validateButton");
  EXPECT_TRUE(WindowRig::comes([&] {
    return rig_.label("validationStatus").startsWith("Insertion ") &&
           rig_.label("validationStatus").endsWith("of 12");
  }));
  page().cancel();
  EXPECT_TRUE(WindowRig::comes([&] { return !page().isBusy(); }));
}

TEST_F(ValidationPage, EndsWithAVerdictForEachPrintedValue)
{
  setRuns(2);
  rig_.click("validateButton");
  // Another hundred insertions determine the sources of the spread; with sanitizers they take
  // minutes.
  ASSERT_TRUE(WindowRig::comes([&] { return page().result().has_value(); }, 900'000));
  EXPECT_EQ(page().result()->runs, 2);
  EXPECT_GE(verdicts("✓ met") + verdicts("missed"), 4);
  EXPECT_EQ(rig_.label("validationHeadline"), QStringLiteral("%1 of %2 criteria met")
                                                  .arg(verdicts("✓ met"))
                                                  .arg(verdicts("✓ met") + verdicts("missed")));
  EXPECT_TRUE(rig_.button("saveValidationButton").isEnabled());
  rig_.click("differenceFigure");
  EXPECT_TRUE(figureSays("experiment"));
}

TEST_F(ValidationPage, CanBeCanceledAndKeepsNothing)
{
  setRuns(1000);
  rig_.click("validateButton");
  auto* progress = page().findChild<QProgressBar*>();
  ASSERT_TRUE(WindowRig::comes([&] { return progress->value() >= 1; }));
  rig_.pressKey(Qt::Key_Escape);
  ASSERT_TRUE(WindowRig::comes([&] { return !page().isBusy(); }));
  EXPECT_FALSE(page().result());
  EXPECT_TRUE(rig_.label("validationStatus").contains("Canceled"));
  EXPECT_TRUE(rig_.button("validateButton").isEnabled());
}

}  // namespace
}  // namespace perilymph::test
