// SPDX-License-Identifier: BSD-3-Clause

// The film of README.md in the real window: from a CT over its measures and a plan to an insertion,
// and back to the scan. resources/pictures/make-film runs it to take the pictures.

#include <gtest/gtest.h>

#include <QFile>
#include <QLabel>
#include <QPainter>
#include <QTextStream>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "OwnFolders.h"
#include "Walk.h"
#include "WindowRig.h"
#include "gui/pages/ct/CtPage.h"
#include "gui/pages/insert/ForceCharts.h"
#include "gui/pages/insert/InsertionViews.h"
#include "gui/pages/plan/PlanList.h"
#include "gui/pages/plan/PlanPage.h"
#include "gui/pages/plan/PlanView.h"
#include "gui/widgets/Theme.h"
#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

/// The frames of the film, in the folder that PERILYMPH_FILM names: pictures, and frames.tsv with the
/// name and duration [s] of each. Without the variable nothing is saved.
class Film {
public:
  /// The window with a sentence below it.
  void frame(QWidget& window, const QString& caption, double seconds)
  {
    ++frames_;
    if (!isTaken()) return;
    last_ = pictureOf(window);
    QImage whole(last_.width(), last_.height() + captionHeight, QImage::Format_RGB32);
    whole.fill(QColor(12, 15, 18));
    QPainter painter(&whole);
    painter.drawImage(0, 0, last_);
    painter.setPen(QColor(240, 240, 240));
    painter.setFont(gui::typeface(16, QFont::DemiBold));
    painter.drawText(QRect(16, last_.height(), last_.width() - 32, captionHeight),
                     Qt::AlignVCenter | Qt::AlignLeft, caption);
    painter.end();
    const QString name = QStringLiteral("%1.png").arg(frames_, 3, 10, QLatin1Char('0'));
    EXPECT_TRUE(whole.save(folder_ + "/" + name)) << name.toStdString();
    QFile list(folder_ + "/frames.tsv");
    EXPECT_TRUE(list.open(QIODevice::Append));
    QTextStream(&list) << name << '\t' << seconds << '\n';
  }

  /// The last frame, without its sentence, is README's picture of the window.
  void keepLast() const
  {
    if (!isTaken()) return;
    EXPECT_TRUE(last_.save(folder_ + "/window.png", "PNG", 0));
  }

  bool isTaken() const { return !folder_.isEmpty(); }
  int frames() const { return frames_; }

private:
  static constexpr int captionHeight = 48;
  QString folder_ = qEnvironmentVariable("PERILYMPH_FILM");
  int frames_ = 0;
  QImage last_;
};

class AFilm : public testing::Test {
protected:
  AFilm() { writeDicomFiles(dicomSlices(phantom_.volume), folder_ / "ct"); }

  gui::CtPage& ct() { return *rig_.window().pages().find<gui::CtPage>(); }
  gui::PlanPage& plan() { return *rig_.window().findChild<gui::PlanPage*>(); }
  bool isComputed()
  {
    return WindowRig::waitUntil([&] {
      const auto labels = rig_.window().findChildren<QLabel*>();
      return std::none_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->isVisible() && label->text() == "computing…";
      });
    });
  }
  /// A scenario whose insertions take little time.
  std::string coarse() const
  {
    const auto file = folder_ / "coarse.toml";
    std::ofstream(file) << "title = 'coarse'\narray = 'flex28'\nanatomy = 'mean'\n"
                           "friction = 'soap-10'\nnodes = 20\ndt_ms = 10.0\nspeed_mm_s = 4.0\n"
                           "start_inside_mm = 1.0\nstop_travel_mm = 20.0\n";
    return file.string();
  }

  void measure()
  {
    rig_.click("ctPageButton");
    ct().open(folder_ / "ct");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return ct().study().hasCt(); }));
    ct().study().moveCrosshair(phantom_.inside_P);
    film_.frame(rig_.window(), "1. Open the CT of a temporal bone. This one is synthetic.", 5.0);
    ASSERT_TRUE(WindowRig::waitUntil([&] { return ct().study().measures() != nullptr; }));
    EXPECT_NEAR(ct().study().measures()->a.value, phantom_.a, 0.4);
    film_.frame(rig_.window(),
                "2. The cochlea is found and measured: A, B, H and duct length, with their errors.",
                7.0);
  }

  void choose()
  {
    rig_.type("ctPatientCode", "CT-014");
    rig_.click("planCtButton");
    if (!film_.isTaken()) plan().setScenario(coarse());
    rig_.click("planNoArraysButton");
    for (const char* array : {"plan-array-flex24", "plan-array-hifocus-slimj"}) rig_.click(array);
    rig_.choose("planDraws", film_.isTaken() ? "32" : "16");
    film_.frame(rig_.window(), "3. Choose electrode arrays for a plan.", 5.0);
    rig_.click("computePlanButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return plan().plan() && !plan().isBusy(); }, 600'000));
    film_.frame(
        rig_.window(),
        "4. Each array is inserted many times: angle, force and risks, with bands of 5 to 95 %.",
        8.0);
    plan().list().selectRow(0);
    rig_.click("openPlanArrayButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return plan().view().shownScenes() == 1; }));
    film_.frame(rig_.window(), "5. One array in this cochlea: where its contacts come to lie.",
                7.0);
    rig_.click("planTableButton");
  }

  void insert()
  {
    const std::string array = plan().list().model()->index(0, 0).data().toString().toStdString();
    plan().list().selectRow(0);
    rig_.click("insertPlanArrayButton");
    ASSERT_TRUE(WindowRig::waitUntil([&] {
      return rig_.window().page() == "insert" &&
             rig_.window().control().scenario().array().name == array &&
             rig_.button("startButton").isEnabled();
    }));
    // as deep as the median of the plan, where most of its insertions were stopped by resistance
    const double start_mm = inMillimeters(rig_.window().control().scenario().startInside());
    const auto& arrays = plan().plan()->arrays;
    const auto planned = std::find_if(arrays.begin(), arrays.end(),
                                      [&](const auto& each) { return each.name == array; });
    ASSERT_NE(planned, arrays.end());
    const double median_mm = planned->depth_mm.median;
    const double stop_mm = film_.isTaken() ? median_mm - start_mm : 5.0;
    rig_.type("panelStop", QString::number(stop_mm, 'f', 1).toUtf8());
    ASSERT_TRUE(WindowRig::waitUntil([&] {
      const Length stop = rig_.window().control().scenario().stopTravel();
      return std::abs(inMillimeters(stop) - stop_mm) < 0.1 &&
             rig_.button("startButton").isEnabled();
    }));
    ASSERT_TRUE(isComputed());
    film_.frame(rig_.window(), "6. Insert it: with a haptic device, the mouse, or automatically.",
                5.0);
    EXPECT_TRUE(rig_.window().views().charts()->showPlanIn(rig_.window().control().scenario()));
    rig_.click("startButton");
    const int steps = film_.isTaken() ? 17 : 3;
    for (int i = 1; i < steps; ++i) {
      ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.travel_mm() > stop_mm * i / steps; }));
      film_.frame(rig_.window(),
                  "7. A thousand times a second: how the array bends, touches the wall and slides "
                  "along it.",
                  0.8);
    }
    film_.keepLast();
    ASSERT_TRUE(WindowRig::waitUntil([&] { return isOver(); }));
    EXPECT_NEAR(rig_.travel_mm(), stop_mm, 0.1);
    film_.frame(rig_.window(),
                "8. At the median depth of the plan: angle and force, beside its band.", 8.0);
  }

  void goBackToTheScan()
  {
    rig_.click("ctPageButton");
    const auto& measures = *ct().study().measures();
    ct().study().moveCrosshair(ct::basalTurnCenter_P(measures) - 0.3 * measures.axis_P);
    // the tip lies within the measured cochlea
    ASSERT_FALSE(ct().study().array().nodes.empty());
    const auto& tip = ct().study().array().nodes.back();
    EXPECT_LT((tip.center_P - measures.center_P).norm(), 0.5 * measures.a.value + 1.0);
    film_.frame(rig_.window(), "9. The array lies in the scan.", 7.0);
  }

  bool isOver() { return rig_.now().output.workflow == haptics::Workflow::finished; }

  DataFolder data_;
  StateFolder state_;
  TemporaryFolder folder_;
  CtPhantom phantom_ = makeCtPhantom(14, highResolutionScan());  // a right ear of ordinary size
  WindowRig rig_;
  Film film_;
};

TEST_F(AFilm, GoesFromACtToAnInsertionAndBackToTheScan)
{
  ASSERT_NO_FATAL_FAILURE(measure());
  ASSERT_NO_FATAL_FAILURE(choose());
  ASSERT_NO_FATAL_FAILURE(insert());
  ASSERT_NO_FATAL_FAILURE(goBackToTheScan());
  EXPECT_GE(film_.frames(), 8);
}

}  // namespace
}  // namespace perilymph::test
