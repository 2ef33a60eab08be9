// SPDX-License-Identifier: BSD-3-Clause

// The published experiment repeated in the window.

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QTest>
#include <algorithm>
#include <utility>

#include "KeptPicture.h"
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
  EXPECT_TRUE(WindowRig::waitUntil([&] {
    return rig_.label("validationStatus").startsWith("Insertion ") &&
           rig_.label("validationStatus").endsWith("of 12");
  }));
  page().cancel();
  EXPECT_TRUE(WindowRig::waitUntil([&] { return !page().isBusy(); }));
}

TEST_F(ValidationPage, EndsWithAVerdictForEachPrintedValue)
{
  setRuns(2);
  rig_.click("validateButton");
  // Another hundred insertions determine the sources of the spread; with sanitizers they take
  // minutes.
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page().result().has_value(); }, 900'000));
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
  ASSERT_TRUE(WindowRig::waitUntil([&] { return progress->value() >= 1; }));
  rig_.pressKey(Qt::Key_Escape);
  ASSERT_TRUE(WindowRig::waitUntil([&] { return !page().isBusy(); }));
  EXPECT_FALSE(page().result());
  EXPECT_TRUE(rig_.label("validationStatus").contains("Canceled"));
  EXPECT_TRUE(rig_.button("validateButton").isEnabled());
}

/// Height of the ink in a picture [px].
int heightOfInk(const QImage& picture)
{
  const QRgb ground = picture.pixel(picture.width() / 2, 2);
  int first = picture.height(), last = -1;
  for (int y = 8; y < picture.height() - 8; ++y)
    for (int x = 8; x < picture.width() - 8; ++x)
      if (picture.pixel(x, y) != ground) {
        first = std::min(first, y);
        last = y;
      }
  return last - first + 1;
}

TEST_F(ValidationPage, HasFiguresWithTextAsLargeAsThePagesWhateverTheSizeOfTheWindow)
{
  figures::Drawing drawing;
  drawing.width = 480.0;
  drawing.height = 360.0;
  figures::Label letters;
  letters.at = {200.0, 180.0};
  letters.text = "HHH";
  drawing.marks = {letters};
  // an upper-case letter of Inter is 0.73 of the size of the type high
  for (const auto& [width, text_px] : {std::pair{400, 10}, {1000, 13}, {1900, 13}}) {
    gui::DrawingView view(nullptr);
    view.show(drawing);
    view.resize(width, width * 3 / 4);
    EXPECT_NEAR(heightOfInk(view.grab().toImage()), 0.73 * text_px, 1.6) << width;
  }
  keepPicture(rig_.window(), "validate");
}

}  // namespace
}  // namespace perilymph::test
