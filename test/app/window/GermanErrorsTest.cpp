// SPDX-License-Identifier: BSD-3-Clause

// Why a CT cannot be read, in a German window.

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLocale>
#include <fstream>

#include "dicom/DicomStatements.h"
#include "gui/program/Languages.h"
#include "gui/text/DataText.h"
#include "perilymph/anatomy/Patient.h"
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
  EXPECT_EQ(gui::dataText(missing.error().message),
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
    const Sentence& english = refused.error().message;
    const QString german = gui::dataText(english);
    EXPECT_NE(german, QString::fromStdString(english));
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
    const Sentence& english = refused.error().message;
    const QString german = gui::dataText(english);
    EXPECT_NE(german, QString::fromStdString(english));
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
  EXPECT_EQ(gui::dataText(refused.error().message).toStdString(),
            (folder / "a.nrrd").string() +
                " gibt die Voxelgröße entlang k zweimal an: 0,25 mm in space directions und 2,5 mm "
                "in spacings; exportieren Sie die Datei noch einmal aus der Originalserie.");
  EXPECT_EQ(gui::dataText(*imaging::disagreement(Sentence{"The file"}, imaging::nifti::otherQForm,
                                                 "(1, 2, 3) mm", "(4, 5, 6) mm",
                                                 Sentence{" (%1, %2, %3)", 11, 9, 7}))
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
  const Sentence two(imaging::warnings::patientOrStudy);
  for (const Phrase& phrase : imaging::warnings::all) {
    const bool isApart = std::string(phrase.english()) == imaging::warnings::listedApart.english();
    const Sentence seven = std::string("7"), other = std::string(isApart ? "9" : "8.5");
    const Sentence english(phrase, {seven, other, isApart ? two : seven, other, seven});
    const QString german = gui::dataText(english);
    EXPECT_NE(german, QString::fromStdString(english));
    EXPECT_FALSE(isEnglish(german)) << german.toStdString();
    EXPECT_TRUE(german.contains(QLatin1Char('7')) || english.find('7') == std::string::npos);
    EXPECT_FALSE(german.contains("8.5")) << german.toStdString();
  }
  for (const Phrase& reason :
       {imaging::warnings::capture, imaging::warnings::flatPanel, imaging::warnings::coneBeam}) {
    const QString german =
        gui::dataText(Sentence(imaging::warnings::grayValues, {Sentence(reason)}));
    EXPECT_FALSE(isEnglish(german)) << german.toStdString();
  }
}

TEST_F(GermanErrors, HaveEveryPairThatAFileOrSeriesStates)
{
  std::vector<imaging::StatedTwice> pairs = imaging::allDicomPairs();
  for (const imaging::StatedTwice* pair : imaging::volumePairs()) pairs.push_back(*pair);
  for (const imaging::StatedTwice& pair : pairs)
    for (const Sentence& subject : {Sentence{"The series"}, Sentence{"The file %1", "IM7"},
                                    Sentence(std::string("/ct/a.nrrd"))}) {
      const Sentence english = *imaging::disagreement(
          subject, pair, 0.5, 7.25, Sentence{" of slice %1 of %2 (%3)", 3, 9, "IM7"});
      const QString german = gui::dataText(english);
      EXPECT_NE(german, QString::fromStdString(english));
      EXPECT_FALSE(isEnglish(german)) << german.toStdString();
      EXPECT_TRUE(german.contains("7,25")) << german.toStdString();
    }
}

TEST_F(GermanErrors, TranslateASentenceWithinAnother)
{
  const Error inner{"%1 does not exist. Check the path.", "/ct/1.5 of 2"};
  const Error outer{"The left ear was not measured. %1", inner.message};
  EXPECT_EQ(gui::dataText(outer.message).toStdString(),
            "Das linke Ohr wurde nicht gemessen. /ct/1.5 of 2 gibt es nicht. Prüfen Sie den "
            "Pfad.");
}

TEST_F(GermanErrors, WriteNumbersWithADecimalComma)
{
  EXPECT_EQ(gui::dataText(Sentence{"A voxel is %1 mm long; at most 1.0 mm is allowed, and 0.6 mm "
                                   "or less is advised. Take a series with thinner slices.",
                                   "1.250"})
                .left(24)
                .toStdString(),
            "Ein Voxel ist 1,250 mm l");
  // a version or an address is no number
  EXPECT_TRUE(gui::dataText(Sentence{"%1 is not an address of this computer. 127.0.0.1 always "
                                     "is; 'ip address' lists all.",
                                     "10.1.2.3"})
                  .contains("10.1.2.3"));
}

TEST_F(GermanErrors, ThatAreUnknownStayAsTheyAre)
{
  EXPECT_EQ(gui::dataText(std::string("It failed at 0.5 mm.")), "It failed at 0.5 mm.");
  EXPECT_EQ(gui::dataText(Sentence()), "");
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
  const Sentence unsealed = noteOn(handmade);
  handmade.seal = Seal::changed;
  const auto tooMany = session::savePatientRecord(
      {std::vector<std::string>(session::maxTags + 1, "EAS"), "", false}, patient);
  const auto exported = session::exportPatient(patient, {}, folder.path());
  const auto none = planning::readPlan(folder.path());
  for (const Sentence& english :
       {noteOn(Seal::absent), noteOn(Seal::changed), unsealed, noteOn(handmade),
        tooMany.error().message, exported.error().message, none.error().message,
        meanwhile.error().message, newer.error().message, anatomy::storedNote(noteOn(handmade))}) {
    const QString german = gui::dataText(english);
    EXPECT_NE(german, QString::fromStdString(english));
    EXPECT_FALSE(german.contains(QLatin1String(" the "))) << german.toStdString();
  }
  EXPECT_TRUE(gui::dataText(newer.error().message)
                  .startsWith(QString::fromStdString(session::recordFileOf(patient).string())));
}

}  // namespace
}  // namespace perilymph::test
