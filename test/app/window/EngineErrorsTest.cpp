// SPDX-License-Identifier: BSD-3-Clause

// Why a CT cannot be read, in a German window.

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLocale>
#include <fstream>

#include "dicom/DicomStatements.h"
#include "gui/parts/EngineErrors.h"
#include "gui/program/Languages.h"
#include "perilymph/ct/SliceStack.h"
#include "perilymph/foundation/Seal.h"
#include "perilymph/imaging/CtSeries.h"
#include "perilymph/planning/PlanReading.h"
#include "perilymph/session/PatientRecord.h"
#include "perilymph/test/TemporaryFolder.h"
#include "statements/VolumePairs.h"
#include "statements/Warnings.h"

namespace perilymph::test {
namespace {

class GermanErrors : public testing::Test {
protected:
  GermanErrors() { gui::useLanguage(*QCoreApplication::instance(), "de"); }
  ~GermanErrors() override
  {
    gui::useLanguage(*QCoreApplication::instance(), "en");
    QLocale::setDefault(QLocale::c());
  }
};

/// Slices at these heights [mm].
std::vector<ct::SlicePose> slicesAt(const std::vector<double>& heights_mm)
{
  std::vector<ct::SlicePose> slices;
  for (const double z_mm : heights_mm)
    slices.push_back({Eigen::Vector3d(0.0, 0.0, z_mm), Eigen::Matrix<double, 3, 2>::Identity()});
  return slices;
}

TEST_F(GermanErrors, NameNumbersAndPlacesOfSlices)
{
  const auto missing = ct::stackSlices(slicesAt({0.0, 0.5, 1.0, 2.5, 3.0, 3.5, 4.0, 4.5}));
  ASSERT_FALSE(missing);
  EXPECT_EQ(gui::engineError(missing.error().message),
            "2 Schichten fehlen, die erste hinter Schicht 3 von 8 (bei 1,00 mm entlang der "
            "Normalen); die Lücke ist dort 1,50 mm und der Abstand sonst 0,50 mm. Exportieren Sie "
            "die ganze Serie noch einmal.");
}

TEST_F(GermanErrors, AreThereForEveryStackThatIsNone)
{
  const std::vector<double> even = {0.0, 0.5, 1.0, 1.5};
  auto lost = slicesAt(even), far = slicesAt(even), skew = slicesAt(even), turned = slicesAt(even);
  lost[1].position_P.reset();
  far[1].position_P->x() = 2e6;
  skew[1].axes_P->col(0) *= 2.0;
  turned[1].axes_P->col(0).swap(turned[1].axes_P->col(1));
  const std::vector<std::vector<ct::SlicePose>> stacks = {{},
                                                          slicesAt({1.0}),
                                                          slicesAt({1.0, 1.0, 1.0}),
                                                          slicesAt({0.0, 0.5, 1.5, 2.0, 2.5}),
                                                          lost,
                                                          far,
                                                          skew,
                                                          slicesAt({0.0, 0.5, 1.1, 1.5, 2.0}),
                                                          turned};
  for (const auto& stack : stacks) {
    const auto refused = ct::stackSlices(stack);
    ASSERT_FALSE(refused) << &stack - stacks.data();
    const std::string& english = refused.error().message;
    const QString german = gui::engineError(english);
    EXPECT_NE(german.toStdString(), english);
    EXPECT_FALSE(german.contains(" the ")) << german.toStdString();
  }
}

TEST_F(GermanErrors, KeepTheNameOfTheFile)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "3 of 4.nii") << std::string(400, 'x');
  std::ofstream(folder / "a b.nrrd") << "NRRD0004\ntype: short\nencoding: raw\n\n";
  std::filesystem::create_directory(folder / "empty");
  for (const char* name : {"3 of 4.nii", "a b.nrrd", "empty", "missing"}) {
    const std::filesystem::path path = folder / name;
    const auto refused = imaging::findSeries(path);
    ASSERT_FALSE(refused) << name;
    const std::string& english = refused.error().message;
    const QString german = gui::engineError(english);
    EXPECT_NE(german.toStdString(), english);
    EXPECT_TRUE(german.startsWith(QString::fromStdString(path.string() + ' ')))
        << german.toStdString();
    EXPECT_FALSE(german.contains(" the ")) << german.toStdString();
  }
}

TEST_F(GermanErrors, NameWhatAFileStatesTwice)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "a.nrrd")
      << "NRRD0004\ntype: short\ndimension: 3\nspace: LPS\nsizes: 4 4 4\nspace directions: "
         "(0.25,0,0) "
         "(0,0.25,0) (0,0,0.25)\nspacings: 0.25 0.25 2.5\nspace origin: (0,0,0)\nendian: "
         "little\nencoding: raw\n\n";
  const auto refused = imaging::findSeries(folder / "a.nrrd");
  ASSERT_FALSE(refused);
  EXPECT_EQ(gui::engineError(refused.error().message).toStdString(),
            (folder / "a.nrrd").string() +
                " gibt die Voxelgröße entlang k zweimal an: 0,25 mm in space directions und 2,5 mm "
                "in spacings; exportieren Sie die Datei noch einmal aus der Originalserie.");
  EXPECT_EQ(
      gui::engineError("The file states the place of its voxels (11, 9, 7) twice: (1, 2, 3) mm "
                       "in the SForm and (4, 5, 6) mm in the QForm of another code; the SForm "
                       "is used, so check the sides.")
          .toStdString(),
      "Die Datei gibt den Ort der Voxel (11, 9, 7) zweimal an: (1, 2, 3) mm in der SForm und "
      "(4, 5, 6) mm in der QForm mit anderem Code; die SForm wird benutzt; prüfen Sie die "
      "Seiten.");
}

/// What is left of English where a sentence or a word of it was not translated.
bool isEnglish(const QString& text)
{
  for (const char* word : {" the ", " its ", " is ", " of ", " and ", "Its ", "The ", " check "})
    if (text.contains(QLatin1String(word))) return true;
  return false;
}

TEST_F(GermanErrors, HaveEveryWarningOfTheReaders)
{
  const std::string two = imaging::warnings::patientOrStudy;
  for (const char* const sentence : imaging::warnings::all) {
    const std::string english = imaging::worded(
        sentence, {"7", sentence == imaging::warnings::listedApart ? "9" : "8.5",
                   sentence == imaging::warnings::listedApart ? two : "6", "5", "4"});
    const QString german = gui::seriesWarning(english);
    EXPECT_NE(german.toStdString(), english);
    EXPECT_FALSE(isEnglish(german)) << german.toStdString();
    EXPECT_TRUE(german.contains(QLatin1Char('7')) || english.find('7') == std::string::npos);
  }
  for (const char* const reason :
       {imaging::warnings::capture, imaging::warnings::flatPanel, imaging::warnings::coneBeam}) {
    const QString german =
        gui::seriesWarning(imaging::worded(imaging::warnings::grayValues, {reason}));
    EXPECT_FALSE(isEnglish(german)) << german.toStdString();
  }
}

TEST_F(GermanErrors, HaveEveryPairThatAFileOrSeriesStates)
{
  std::vector<imaging::StatedTwice> pairs = imaging::allDicomPairs();
  for (const imaging::StatedTwice* pair : imaging::volumePairs()) pairs.push_back(*pair);
  for (const imaging::StatedTwice& pair : pairs)
    for (const char* const subject : {"The series", "The file IM7", "/ct/a.nrrd"}) {
      const std::string english =
          *imaging::disagreement(subject, pair, 0.5, 7.25, " of slice 3 of 9 (IM7)");
      const QString german = gui::seriesWarning(english);
      EXPECT_NE(german.toStdString(), english);
      EXPECT_FALSE(isEnglish(german)) << german.toStdString();
      EXPECT_TRUE(german.contains("7,25")) << german.toStdString();
    }
}

TEST_F(GermanErrors, SayThatVoxelsAreLabelsOrFarAway)
{
  for (const char* const english :
       {"/a/b.nii states by its intent_code 1002 that its voxels are labels or statistics and no "
        "gray values. Save the CT itself, with the code 0.",
        "/a/b.nii lies more than 1 km from the origin of the patient's coordinates, where no "
        "scanner "
        "measures. Export it again with its orientation."}) {
    const QString german = gui::engineError(english);
    EXPECT_TRUE(german.startsWith("/a/b.nii ")) << german.toStdString();
    EXPECT_FALSE(isEnglish(german)) << german.toStdString();
  }
}

TEST_F(GermanErrors, SayHowManyOtherFilesHaveSuchFaults)
{
  EXPECT_EQ(gui::engineError("The file IM3 states RescaleSlope (0028,1053) as \"abc\", where one "
                             "number belongs; export the series again as original images. Other "
                             "files have such faults: 4.")
                .toStdString(),
            "Die Datei IM3 gibt RescaleSlope (0028,1053) als \"abc\" an, wo eine Zahl stehen "
            "muss; exportieren Sie die Serie noch einmal als Originalbilder. Andere Dateien haben "
            "solche Fehler: 4.");
}

TEST_F(GermanErrors, ThatAreUnknownStayAsTheyAre)
{
  EXPECT_EQ(gui::engineError("It failed at 0.5 mm."), "It failed at 0.5 mm.");
}

TEST_F(GermanErrors, AreThereForFilesThatWereChangedAndInUse)
{
  const TemporaryFolder folder;
  const auto patient = folder / "P-017-left.toml";
  ASSERT_TRUE(session::savePatientRecord({{"EAS"}, "", false}, patient));
  const auto meanwhile = session::savePatientRecord({{"other"}, "", false}, patient);
  ASSERT_FALSE(meanwhile);
  std::ofstream(session::recordFileOf(patient)) << "{\"format\": 3}";
  const auto newer = session::loadPatientRecord(patient);
  ASSERT_FALSE(newer);
  anatomy::Patient handmade;
  handmade.origin.software = "Other 7";
  handmade.seal = Seal::absent;
  const std::string unsealed = noteOn(handmade);
  handmade.seal = Seal::changed;
  const auto tooMany = session::savePatientRecord(
      {std::vector<std::string>(session::maxTags + 1, "EAS"), "", false}, patient);
  const auto exported = session::exportPatient(patient, {}, folder.path());
  const auto none = planning::readPlan(folder.path());
  for (const std::string& english :
       {noteOn(Seal::absent), noteOn(Seal::changed), unsealed, noteOn(handmade),
        tooMany.error().message, exported.error().message, none.error().message,
        meanwhile.error().message, newer.error().message,
        std::string("/a/draws.sqlite was changed after the program wrote it, so its results are "
                    "not continued. Delete it or give another folder.")}) {
    const QString german = gui::engineError(english);
    EXPECT_NE(german, QString::fromStdString(english));
    EXPECT_FALSE(german.contains(QLatin1String(" the "))) << german.toStdString();
  }
  EXPECT_TRUE(gui::engineError(newer.error().message)
                  .startsWith(QString::fromStdString(session::recordFileOf(patient).string())));
}

}  // namespace
}  // namespace perilymph::test
