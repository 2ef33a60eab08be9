// SPDX-License-Identifier: BSD-3-Clause

// Distances, angles, notes and key images on the page CT: placed by clicks, moved, undone, kept with the patient and
// with no other CT, written for other programs and into a report.

#include <gmock/gmock.h>

#include <QAction>
#include <QFileDialog>
#include <QImage>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <cmath>

#include "KeptPicture.h"
#include "SaveDialog.h"
#include "TheCtPage.h"
#include "gui/pages/ct/CtText.h"
#include "gui/pages/ct/PlaneOverlay.h"
#include "gui/report/KeyImagePages.h"
#include "gui/setup/CtKeyImages.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/widgets/Theme.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/imaging/MarkupFiles.h"
#include "perilymph/test/ChildProcess.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

class Markups : public TheCtPage {
protected:
  void click(gui::PlaneView& view, const QPoint& place)
  {
    QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, place);
  }
  /// A distance of 60 px to the right and 80 px down in a plane: 100 px.
  void placeDistance(int plane = 0)
  {
    rig_.click("distanceTool");
    const QPoint from = view(plane).rect().center() - QPoint(70, 40);
    click(view(plane), from);
    click(view(plane), from + QPoint(60, 80));
    rig_.pressKey(Qt::Key_Escape);
    ASSERT_EQ(study().markups().size(), 1U);
  }
  double valueOf(std::size_t which)
  {
    return ct::valueOf(study().markups().at(which), study().ctMarkups().voxelEdges_P)->value;
  }
  QLineEdit* typed() { return rig_.window().findChild<QLineEdit*>("markupText"); }
  void placeNote(const char* text)
  {
    rig_.click("noteTool");
    click(view(0), view(0).rect().center() + QPoint(30, -50));
    ASSERT_NE(typed(), nullptr);
    QTest::keyClicks(typed(), text);
    QTest::keyClick(typed(), Qt::Key_Return);
    rig_.pressKey(Qt::Key_Escape);
  }
  /// Triggers an entry of the markups' menu and answers its dialog with a path.
  void chooseEntry(const char* name, const fs::path& file)
  {
    auto* menu = rig_.window().findChild<QPushButton*>("markupsButton")->menu();
    Q_EMIT menu->aboutToShow();
    auto* action = menu->findChild<QAction*>(name);
    ASSERT_NE(action, nullptr) << name;
    QTimer poll;
    QObject::connect(&poll, &QTimer::timeout, &poll, [&] {
      if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget()))
        acceptPath(*dialog, file);
    });
    poll.start(10);
    action->trigger();
  }

  TemporaryFolder folder_;
};

TEST_F(Markups, OfTwoClicksHaveTheirDistanceOnTheScreenInMillimeters)
{
  placeDistance();
  EXPECT_NEAR(valueOf(0), 100.0 * study().pixel_mm(), 1e-9);
  EXPECT_FALSE(study().tool());
  // the crosshair and the landmarks were not touched
  EXPECT_TRUE(study().marks().isEmpty());
  EXPECT_FALSE(study().isCrosshairPlaced());
  keepPicture(rig_.window(), "markup-distance");
}

TEST_F(Markups, MayHaveTheirPointsInDifferentPlanes)
{
  rig_.pressKey(Qt::Key_D);
  const Vector3d from = study().crosshair_P(), to = from + Vector3d(1.0, 2.0, 2.0);
  click(view(0), view(0).placeOf(from).toPoint());
  study().moveCrosshair(to);
  rig_.pressKey(Qt::Key_Return);  // at the crosshair
  ASSERT_EQ(study().markups().size(), 1U);
  // the click is rounded to a pixel
  EXPECT_NEAR(valueOf(0), 3.0, study().pixel_mm());
  EXPECT_EQ(study().markups()[0].points_P[1], to);
}

TEST_F(Markups, OfThreeClicksHaveTheAngleAtTheSecond)
{
  rig_.pressKey(Qt::Key_A);
  const QPoint vertex = view(1).rect().center();
  for (const QPoint& side : {QPoint(60, 0), QPoint(0, 0), QPoint(40, -40)})
    click(view(1), vertex + side);
  ASSERT_EQ(study().markups().size(), 1U);
  EXPECT_NEAR(valueOf(0), 45.0, 1e-9);
}

TEST_F(Markups, AreNotMovedByADragWhoseOwnWasRemoved)
{
  placeDistance();
  const Vector3d at = study().crosshair_P(), right = study().planes()[0].right_P,
                 down = study().planes()[0].down_P;
  const ct::Markup other{ct::MarkupKind::angle, {at + 3 * right, at + 3 * down, at - 2 * right}};
  ASSERT_TRUE(study().addMarkups({other}));
  gui::PlaneView& plane = view(0);
  const QPoint from = plane.placeOf(study().markups()[0].points_P[1]).toPoint();
  QTest::mousePress(&plane, Qt::LeftButton, Qt::NoModifier, from);
  rig_.pressKey(Qt::Key_Delete);
  QMouseEvent move(QEvent::MouseMove, from + QPointF(30, 20), Qt::NoButton, Qt::LeftButton,
                   Qt::NoModifier);
  QCoreApplication::sendEvent(&plane, &move);
  QTest::mouseRelease(&plane, Qt::LeftButton, Qt::NoModifier, from + QPoint(30, 20));
  ASSERT_EQ(study().markups().size(), 1U);
  EXPECT_EQ(study().markups()[0], other);
  // what is there is not added again
  ASSERT_TRUE(study().addMarkups({other}));
  EXPECT_EQ(study().markups().size(), 1U);
}

TEST_F(Markups, AreDraggedRemovedAndBroughtBack)
{
  placeDistance();
  const ct::Markup placed = study().markups()[0];
  gui::PlaneView& plane = view(0);
  drag(plane, plane.placeOf(placed.points_P[1]), {0, -80});
  EXPECT_NEAR(valueOf(0), 60.0 * study().pixel_mm(), 1e-9);
  EXPECT_EQ(study().markups()[0].points_P[0], placed.points_P[0]);
  rig_.pressKey(Qt::Key_Delete);  // the dragged one is chosen
  EXPECT_TRUE(study().markups().empty());
  rig_.pressKey(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NEAR(valueOf(0), 60.0 * study().pixel_mm(), 1e-9);
  rig_.pressKey(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(study().markups()[0], placed);  // the drag is one step
  rig_.pressKey(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(study().markups().empty());
  rig_.pressKey(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(study().markups().at(0), placed);
}

TEST_F(Markups, EndTheirToolByEscAndUndoTheLastPointFirst)
{
  rig_.pressKey(Qt::Key_A);
  click(view(0), view(0).rect().center());
  click(view(0), view(0).rect().center() + QPoint(50, 0));
  keepPicture(rig_.window(), "markup-tool");
  rig_.pressKey(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(study().toolPoints_P().size(), 1U);
  rig_.pressKey(Qt::Key_Escape);
  EXPECT_FALSE(study().tool());
  EXPECT_TRUE(study().toolPoints_P().empty());
  EXPECT_TRUE(study().markups().empty());
  // a landmark that is to be placed ends a tool
  rig_.click("distanceTool");
  rig_.click("markRW");
  EXPECT_FALSE(study().tool());
  click(view(0), view(0).rect().center());
  EXPECT_TRUE(study().marks()[ct::Mark::roundWindow]);
  EXPECT_TRUE(study().markups().empty());
}

TEST_F(Markups, OutsideTheCtAreRefusedInASentence)
{
  rig_.click("noteTool");
  study().pan(Vector3d(50, 50, 50));
  click(view(0), view(0).rect().center());
  EXPECT_EQ(typed(), nullptr);
  EXPECT_TRUE(rig_.label("ctStatus").contains("outside the CT"));
  rig_.click("distanceTool");
  click(view(0), view(0).rect().center());
  EXPECT_TRUE(study().toolPoints_P().empty());
}

TEST_F(Markups, OfNotesHaveTheTextThatWasTyped)
{
  placeNote("high jugular bulb");
  ASSERT_EQ(study().markups().size(), 1U);
  EXPECT_EQ(study().markups()[0].text, "high jugular bulb");
  // Esc drops what is typed, and keeps the tool until it is pressed again
  rig_.click("noteTool");
  click(view(0), view(0).rect().center());
  QTest::keyClicks(typed(), "never mind");
  QTest::keyClick(typed(), Qt::Key_Escape);
  EXPECT_EQ(study().markups().size(), 1U);
  EXPECT_TRUE(study().tool());
}

TEST_F(Markups, AreDrawnWithinAMillimeterOfThePlaneFainterTheFarther)
{
  placeDistance();
  const ct::Markup markup = study().markups()[0];
  EXPECT_DOUBLE_EQ(gui::markupOpacity(study(), 0, markup), 1.0);
  const Vector3d away = study().planes()[0].away_P(), at = study().crosshair_P();
  double before = 1.0;
  for (const double behind_mm : {0.3, 0.6, 0.9}) {
    study().moveCrosshair(at + behind_mm * away);
    const double opacity = gui::markupOpacity(study(), 0, markup);
    EXPECT_LT(opacity, before);
    EXPECT_GT(opacity, 0.0);
    before = opacity;
  }
  study().moveCrosshair(at + 1.1 * away);
  EXPECT_EQ(gui::markupOpacity(study(), 0, markup), 0.0);
  EXPECT_FALSE(view(0).markupAt(view(0).placeOf(markup.points_P[0])));
  // a line through the plane is drawn wherever its ends are
  const ct::Markup across{ct::MarkupKind::distance, {at - 9.0 * away, at + 9.0 * away}};
  EXPECT_DOUBLE_EQ(gui::markupOpacity(study(), 0, across), 1.0);
}

TEST_F(Markups, OfOneCtAreNotShownOverAnother)
{
  placeDistance();
  const auto placed = study().markups();
  open(otherOnDisk());
  EXPECT_TRUE(study().markups().empty());
  open(onDisk().folder / "ct");
  EXPECT_EQ(study().markups(), placed);
}

TEST_F(Markups, AreKeptWithThePatientAndShownWhenTheCtIsOpenedAgain)
{
  measure();
  placeDistance(1);
  placeNote("Jane Doe has a high jugular bulb");
  const auto placed = study().markups();
  rig_.type("ctPatientCode", "CT-77");
  rig_.click("insertCtButton");
  ASSERT_TRUE(WindowRig::waitUntil(
      [this] { return rig_.window().control().scenario().patient().label == "CT-77"; }));
  const auto saved = gui::findSavedPatient("CT-77", study().measures()->side);
  ASSERT_TRUE(saved);
  const ct::CtMarkups* kept = session::markupsOf(saved->record, study().series().key);
  ASSERT_NE(kept, nullptr);
  EXPECT_EQ(kept->markups, placed);
  EXPECT_EQ(kept->voxelEdges_P, study().ctMarkups().voxelEdges_P);
  for (const auto& entry : fs::recursive_directory_iterator(patientFolder()))
    EXPECT_EQ(entry.path().string().find("Jane"), std::string::npos) << entry.path();
  // what is changed afterward is kept, too, and another window shows it
  rig_.click("ctPageButton");
  study().removeMarkup(0);
  ASSERT_TRUE(WindowRig::waitUntil([&] {
    const auto now = gui::findSavedPatient("CT-77", study().measures()->side);
    return session::markupsOf(now->record, study().series().key)->markups.size() == 1;
  }));
  WindowRig other;
  other.click("ctPageButton");
  auto& page = *other.window().pages().find<gui::CtPage>();
  page.open(onDisk().folder / "ct");
  ASSERT_TRUE(WindowRig::waitUntil([&] { return page.study().hasCt(); }));
  page.cancel();
  ASSERT_EQ(page.study().markups().size(), 1U);
  EXPECT_EQ(page.study().markups()[0], placed[1]);
}

TEST_F(Markups, AreWrittenForSlicerAndAsATableInLps)
{
  placeDistance();
  chooseEntry("exportSlicerMarkups", folder_ / "m.mrk.json");
  const auto read = imaging::readMarkups(folder_ / "m.mrk.json", study().series().key);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, study().markups());
  chooseEntry("exportMarkupTable", folder_ / "m.csv");
  EXPECT_EQ(*readWhole(folder_ / "m.csv"), imaging::markupsCsv(study().ctMarkups()));
  EXPECT_TRUE(fs::exists(folder_ / "m-dictionary.csv"));
  // and loaded again
  const auto placed = study().markups();
  study().removeMarkup(0);
  chooseEntry("loadMarkups", folder_ / "m.mrk.json");
  EXPECT_EQ(study().markups(), placed);
}

TEST_F(Markups, HaveTheHounsfieldUnitsOfAVoxelAtItsCenterAndTheMeanBetweenTwo)
{
  const ct::CtVolume& volume = onDisk().phantom.volume;
  const std::array<int, 3> at{volume.size()[0] / 2, volume.size()[1] / 2, volume.size()[2] / 2};
  const int one = volume.voxel(at[0], at[1], at[2]), next = volume.voxel(at[0] + 1, at[1], at[2]);
  const auto textAt = [&](double i) {
    return gui::cursorText(study(), study().volume()->toLps({i, double(at[1]), double(at[2])}));
  };
  EXPECT_EQ(textAt(at[0])[0], QStringLiteral("%1 HU").arg(one));
  const double mean = 0.5 * (one + next);
  EXPECT_NEAR(textAt(at[0] + 0.5)[0].section(' ', 0, 0).toDouble(), mean, 0.5);
  EXPECT_EQ(gui::cursorText(study(), Vector3d(1e4, 0, 0))[0], "outside the CT");
  EXPECT_EQ(gui::cursorText(study(), Vector3d(1.25, -20.5, 3))[1], "LPS 1.3; -20.5; 3.0 mm");
}

TEST(GrayValues, OfAConeBeamScannerAreNotShownAsHounsfieldUnits)
{
  auto slices = dicomSlices(onDisk().phantom.volume, "1.2.3.10");
  for (DicomData& slice : slices)
    slice.setText(0x00281054, "LO", "US");  // RescaleType: unspecified
  const TemporaryFolder folder;
  writeDicomFiles(slices, folder / "ct");
  auto loaded = imaging::readCt(folder / "ct");
  ASSERT_TRUE(loaded) << loaded.error().message;
  gui::CtStudy study;
  study.setCt(std::move(*loaded));
  const QString text = gui::cursorText(study, study.volume()->center_P())[0];
  EXPECT_TRUE(text.endsWith("gray value, not HU")) << text.toStdString();
}

TEST_F(Markups, GoIntoKeyImagesOfOneSizeWithCaptionAndPlaceAndNoCrosshair)
{
  placeDistance();
  const std::string key = study().series().key;
  rig_.click("keyImageButton");
  ASSERT_NE(typed(), nullptr);
  QTest::keyClicks(typed(), "Facial recess");
  QTest::keyClick(typed(), Qt::Key_Return);
  const auto images = gui::ctKeyImages(key);
  ASSERT_EQ(images.size(), 1U);
  EXPECT_EQ(images[0].caption, "Facial recess");
  EXPECT_TRUE(images[0].place.startsWith("Axial · through LPS ")) << images[0].place.toStdString();
  EXPECT_TRUE(images[0].place.contains("voxels 0.")) << images[0].place.toStdString();
  EXPECT_EQ(images[0].file.string().find("Facial"), std::string::npos);
  const QImage picture(QString::fromStdString(images[0].file.string()));
  EXPECT_EQ(picture.size(), QSize(gui::keyImageWidth_px, gui::keyImageHeight_px));
  EXPECT_EQ(fs::status(images[0].file).permissions() & fs::perms::others_read, fs::perms::none);
  // the same window gives the same bits
  const QImage again = view(0).pictureOf(picture.size(), 2.0);
  EXPECT_EQ(again.convertToFormat(QImage::Format_RGB32),
            picture.convertToFormat(QImage::Format_RGB32));
  keepPicture(rig_.window(), "markup-key-image");
  // of another series there is none
  EXPECT_TRUE(gui::ctKeyImages(std::string(64, '0')).empty());
  // listed and removable
  auto* menu = rig_.window().findChild<QPushButton*>("keyImagesButton")->menu();
  Q_EMIT menu->aboutToShow();
  ASSERT_EQ(menu->actions().size(), 1);
  EXPECT_EQ(menu->actions()[0]->text(), "Facial recess");
  menu->actions()[0]->menu()->actions().last()->trigger();
  EXPECT_TRUE(gui::ctKeyImages(key).empty());
}

/// The color scheme of a window that is made afterward.
struct Scheme : testing::WithParamInterface<gui::ColorScheme> {
  Scheme() { gui::setShownColorScheme(GetParam()); }
  ~Scheme() override { gui::setShownColorScheme(gui::ColorScheme::dark); }
};

class MarkupsInEveryScheme : public Scheme, public TheCtPage {
protected:
  void moveMouse(gui::PlaneView& view, const QPoint& place)
  {
    QMouseEvent move(QEvent::MouseMove, QPointF(place), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view, &move);
  }
};

INSTANTIATE_TEST_SUITE_P(Each, MarkupsInEveryScheme,
                         testing::Values(gui::ColorScheme::dark, gui::ColorScheme::light));

TEST_P(MarkupsInEveryScheme, HaveTheirBarInSmallAndLargeWindows)
{
  measure();
  const Vector3d at = study().crosshair_P(), right = study().planes()[0].right_P,
                 down = study().planes()[0].down_P, away = study().planes()[0].away_P();
  const std::vector<ct::Markup> many{
      {ct::MarkupKind::distance, {at - 4 * right, at + 3 * right + down}},
      {ct::MarkupKind::distance, {at - 3 * down, at + 0.5 * right - 3.2 * down}, "facial recess"},
      {ct::MarkupKind::angle, {at - 2 * down, at - 2 * right, at + 2 * down}},
      {ct::MarkupKind::note, {at + 2 * right + 2 * down + 0.6 * away}, "jugular bulb is high"},
      {ct::MarkupKind::facialNerve,
       {at + 4 * right - 3 * down, at + 4 * right, at + 4.5 * right + 3 * down}},
      {ct::MarkupKind::distance, {at - 4 * away, at + 4 * away + right}}};
  ASSERT_TRUE(study().addMarkups(many));
  const bool isDark = GetParam() == gui::ColorScheme::dark;
  for (const QSize& size : {QSize(1024, 640), QSize(1366, 768), QSize(1920, 1080)}) {
    rig_.window().resize(size);
    ASSERT_TRUE(WindowRig::waitUntil([&] { return rig_.window().size() == size; }));
    auto* bar = rig_.window().findChild<QWidget*>("markupBar");
    ASSERT_TRUE(WindowRig::waitUntil([&] { return bar->width() == bar->parentWidget()->width(); }));
    EXPECT_GE(bar->width(), bar->minimumSizeHint().width()) << size.width();
    auto* panel = rig_.window().findChild<QWidget*>("ctPanel");
    ASSERT_TRUE(
        WindowRig::waitUntil([&] { return panel->width() + bar->width() == size.width(); }));
    for (int k = 0; k < 5; ++k) QCoreApplication::processEvents();  // what follows from its width
    moveMouse(view(0), view(0).rect().center() + QPoint(30, 20));
    keepPicture(rig_.window(),
                "markups-" + std::to_string(size.width()) + (isDark ? "" : "-light"));
  }
}

TEST_F(Markups, OfKeyImagesAreOnPagesOfAReport)
{
  try {
    run({"pdftotext", {"-v"}, {}, {}});
  } catch (const std::system_error&) {
    GTEST_SKIP() << "Install the package poppler-utils.";
  }
  const std::string key = study().series().key;
  for (const char* caption : {"Facial recess", "Jugular bulb", "Round window"})
    ASSERT_TRUE(gui::keepCtKeyImage(
        key, view(0).pictureOf({gui::keyImageWidth_px, gui::keyImageHeight_px}, 2.0), caption,
        "Axial · through LPS 1.0; 2.0; 3.0 mm"));
  gui::ReportPages pages;
  pages.title = "Report";
  pages.paintRecord = [](gui::ReportSheet&, const gui::ReportIssuer&, const gui::ReportArea&) {};
  gui::addKeyImagePages(pages, std::string(64, '0'));
  EXPECT_TRUE(pages.figures.empty());
  gui::addKeyImagePages(pages, key);
  ASSERT_EQ(pages.figures.size(), 2U);  // two on each page
  ASSERT_TRUE(gui::writeReportPages(pages, folder_ / "report.pdf"));
  const std::string text =
      run({"pdftotext", {"-layout", (folder_ / "report.pdf").string(), "-"}, {}, {}}).out;
  EXPECT_THAT(text, testing::HasSubstr("Key image 1: Facial recess"));
  EXPECT_THAT(text, testing::HasSubstr("Key image 3: Round window"));
  EXPECT_THAT(text, testing::HasSubstr("through LPS 1.0; 2.0; 3.0 mm"));
  if (const QString kept = qEnvironmentVariable("PERILYMPH_SCREEN_PICTURES"); !kept.isEmpty())
    fs::copy_file(folder_ / "report.pdf", kept.toStdString() + "/key-images.pdf",
                  fs::copy_options::overwrite_existing);
}

}  // namespace
}  // namespace perilymph::test
