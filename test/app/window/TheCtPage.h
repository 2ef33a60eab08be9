// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The page CT of a window, with a phantom as its scan.

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QMouseEvent>
#include <QTest>
#include <filesystem>
#include <optional>

#include "OwnFolders.h"
#include "WindowRig.h"
#include "gui/pages/ct/CtPage.h"
#include "gui/pages/ct/PlaneView.h"
#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {

/// A phantom of 0.3 mm as a folder of DICOM files, made once.
struct CtOnDisk {
  CtPhantom phantom = makeCtPhantom(203, highResolutionScan());
  TemporaryFolder folder;
  CtOnDisk() { writeDicomFiles(dicomSlices(phantom.volume), folder / "ct"); }
};

inline const CtOnDisk& onDisk()
{
  static const CtOnDisk made;
  return made;
}

/// The same voxels as another series, as a folder of DICOM files, made once.
inline const std::filesystem::path& otherOnDisk()
{
  static const TemporaryFolder folder;
  static const std::filesystem::path place = [] {
    writeDicomFiles(dicomSlices(onDisk().phantom.volume, "1.2.3.9"), folder / "other");
    return folder / "other";
  }();
  return place;
}

class TheCtPage : public testing::Test {
protected:
  TheCtPage()
  {
    rig_.click("ctPageButton");
    page().open(onDisk().folder / "ct");
    EXPECT_TRUE(WindowRig::waitUntil([this] { return study().hasCt(); }));
    // it is measured at once, which takes seconds; cases measure where they need it
    EXPECT_TRUE(page().isBusy());
    page().cancel();
    EXPECT_FALSE(page().isBusy());
  }

  /// Opens another scan, and ends its measurement.
  void open(const std::filesystem::path& folder)
  {
    page().open(folder);
    EXPECT_TRUE(
        WindowRig::waitUntil([this] { return rig_.label("ctStatus").startsWith("Looking"); }));
    page().cancel();
  }
  QString code() { return rig_.window().findChild<QLineEdit*>("ctPatientCode")->text(); }

  gui::CtPage& page() { return *rig_.window().pages().find<gui::CtPage>(); }
  gui::CtStudy& study() { return page().study(); }
  gui::PlaneView& view(int plane)
  {
    return *rig_.window().findChild<gui::PlaneView*>(QStringLiteral("planeView%1").arg(plane));
  }
  /// Measures the cochlea at its place; the first page of the program by its button, which takes seconds, all later
  /// ones show what that page measured.
  void measure()
  {
    static std::optional<ct::CochleaMeasures> measured;
    study().moveCrosshair(onDisk().phantom.inside_P);
    if (measured) return study().setMeasures(*measured);
    rig_.click("measureHereButton");
    ASSERT_TRUE(WindowRig::waitUntil([this] { return study().measures() != nullptr; }));
    measured = *study().measures();
  }
  void drag(gui::PlaneView& view, const QPointF& from, const QPointF& by)
  {
    const QPoint start = from.toPoint(), end = (from + by).toPoint();
    QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, start);
    QMouseEvent move(QEvent::MouseMove, QPointF(end), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view, &move);
    QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, end);
  }

  DataFolder data_;
  WindowRig rig_;
};

}  // namespace perilymph::test
