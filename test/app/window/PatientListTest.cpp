// SPDX-License-Identifier: BSD-3-Clause

// The list of saved patients: tags and archive.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLineEdit>
#include <QListWidget>

#include "OwnFolders.h"
#include "WindowRig.h"
#include "gui/setup/PatientLibrary.h"

namespace perilymph::test {
namespace {

TEST(ListOfPatients, FindsATagAndHidesTheArchived)
{
  const DataFolder data;
  anatomy::Patient patient;
  patient.label = "P-018";
  patient.basalTurn = anatomy::BasalTurn{millimeters(9.1), millimeters(6.7), std::nullopt};
  const auto file = gui::savePatientInLibrary(patient);
  ASSERT_TRUE(file) << file.error().message;
  WindowRig rig;
  rig.window().showPage(gui::Page::start);
  rig.click("allPatientsButton");
  const auto type = [&rig](const char* field, const char* text) {
    auto* line = rig.window().findChild<QLineEdit*>(QLatin1String(field));
    line->setText(QLatin1String(text));
    Q_EMIT line->editingFinished();
  };
  auto* list = rig.window().findChild<QListWidget*>("patientList");
  ASSERT_EQ(list->count(), 1);
  type("patientTags", "EAS, revision");
  EXPECT_EQ(session::loadPatientRecord(*file)->tags, (std::vector<std::string>{"EAS", "revision"}));
  type("patientSearch", "revis");
  ASSERT_EQ(list->count(), 1);
  EXPECT_TRUE(list->item(0)->text().contains("EAS, revision"));

  rig.click("archivePatientButton");
  EXPECT_TRUE(session::loadPatientRecord(*file)->isArchived);
  EXPECT_EQ(list->count(), 0);
  rig.window().findChild<QAbstractButton*>("showArchived")->setChecked(true);
  EXPECT_EQ(list->count(), 1);
  rig.click("archivePatientButton");
  EXPECT_FALSE(session::loadPatientRecord(*file)->isArchived);
}

}  // namespace
}  // namespace perilymph::test
