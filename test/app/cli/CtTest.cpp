// SPDX-License-Identifier: BSD-3-Clause

// `ct` with phantoms written as DICOM.

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/test/Cli.h"
#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/DicomWriter.h"

namespace perilymph::test {
namespace {

using Json = nlohmann::json;

/// A phantom with 0.3 mm voxels as a folder of DICOM files, written once.
struct PhantomOnDisk {
  CtPhantom phantom = makeCtPhantom(203, highResolutionScan());
  TemporaryFolder folder;
  PhantomOnDisk() { writeDicomFiles(dicomSlices(phantom.volume), folder / "ct"); }
  std::string path() const { return (folder / "ct").string(); }
  /// A click in the cochlea, in the form of `--at`.
  std::string at() const
  {
    return std::to_string(phantom.inside_P.x()) + "," + std::to_string(phantom.inside_P.y()) + "," +
           std::to_string(phantom.inside_P.z());
  }
};

const PhantomOnDisk& onDisk()
{
  static const PhantomOnDisk made;
  return made;
}

Json jsonOf(const std::filesystem::path& file) { return Json::parse(contentOf(file)); }

void expectNoPatient(const std::string& text)
{
  for (const char* secret : {"Secretname", "SECRETID", "19010203"})
    EXPECT_THAT(text, testing::Not(testing::HasSubstr(secret)));
}

TEST(CtInfo, ListsTheSeriesOfAFolder)
{
  TemporaryFolder out;
  const auto done = cli({"ct", "info", onDisk().path(), "--json", out / "info.json"});
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(done.err, "");
  EXPECT_THAT(done.out, testing::HasSubstr("1.2.3.4\n    CT, 63 x 63 x 63 voxels"));
  const Json json = jsonOf(out / "info.json");
  ASSERT_EQ(json.at("series").size(), 1u);
  const Json& series = json.at("series")[0];
  EXPECT_EQ(series.at("uid"), "1.2.3.4");
  EXPECT_EQ(series.at("readable"), true);
  EXPECT_EQ(series.at("scanner"), "Perilymph Phantom");
  EXPECT_EQ(series.at("kernel"), "Hr64");
  EXPECT_EQ(series.at("slices"), 63);
  EXPECT_NEAR(series.at("spacing_mm")[2].get<double>(), 0.3, 1e-6);
  expectNoPatient(done.out + contentOf(out / "info.json"));
}

TEST(CtMarkups, OfAPatientWhoIsNotThereAreRefusedAsThat)
{
  const TemporaryFolder folder;
  expectRefusal(cli({"ct", "markups", folder / "none.toml"}), "there is no such file");
}

TEST(CtMeasure, MeetsTheTruthOfAPhantomWithinItsErrors)
{
  TemporaryFolder out;
  const auto done = cli({"ct", "measure", onDisk().path(), "--at", onDisk().at(), "--json",
                         out / "m.json", "--patient", out / "ear.toml", "--surface",
                         out / "wall.stl", "--picture", out / "ear.png"});
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(contentOf(out / "ear.png").substr(1, 3), "PNG");  // to check it by
  const Json json = jsonOf(out / "m.json");
  const CtPhantom& truth = onDisk().phantom;
  const auto expectNear = [&](const char* key, double value) {
    const Json& measure = json.at(key);
    EXPECT_NEAR(measure.at("value").get<double>(), value, 3.0 * measure.at("sd").get<double>());
    EXPECT_LT(measure.at("sd").get<double>(), 0.3) << key;
    EXPECT_LT(measure.at("ci95")[0], measure.at("value")) << key;
    EXPECT_GT(measure.at("ci95")[1], measure.at("value")) << key;
  };
  expectNear("A_mm", truth.a);
  expectNear("B_mm", truth.b);
  expectNear("H_mm", truth.h);
  EXPECT_GT(json.at("cdl_oc_mm").at("value"), 25.0);
  EXPECT_EQ(json.at("side"), truth.isRight ? "right" : "left");
  double along = 0.0, apart = 0.0;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    along += json.at("axis_lps")[k].get<double>() * truth.axis_P[i];
    apart += std::pow(json.at("round_window_lps_mm")[k].get<double>() - truth.roundWindow_P[i], 2);
  }
  EXPECT_GT(along, std::cos(6.0 * 3.14159265 / 180.0));
  EXPECT_LT(std::sqrt(apart), 1.5);
  EXPECT_TRUE(json.at("flags").is_array());
  EXPECT_GT(json.at("seconds"), 0.0);
  EXPECT_EQ(json.at("provenance").at("source"), "DICOM");
  EXPECT_EQ(json.at("provenance").at("series_key").get<std::string>().size(), 64u);
  EXPECT_THAT(done.out, testing::ContainsRegex("A +[0-9.]+ ± [0-9.]+ mm \\(95 %\\)"));
  EXPECT_EQ(contentOf(out / "wall.stl").size() % 50, 84u % 50);
  expectNoPatient(done.out + contentOf(out / "m.json") + contentOf(out / "ear.toml") +
                  contentOf(out / "wall.stl"));

  // The patient file is accepted by the other commands and has the measured values.
  const auto described =
      cli({"anatomy", "--patient", out / "ear.toml", "--json", out / "anatomy.json"});
  ASSERT_EQ(described.status, 0) << described.err;
  const Json anatomy = jsonOf(out / "anatomy.json");
  EXPECT_NEAR(anatomy.at("given").at("a_mm").get<double>(),
              json.at("A_mm").at("value").get<double>(), 5e-4);
  EXPECT_EQ(anatomy.at("side"), json.at("side"));
  EXPECT_NEAR(anatomy.at("given").at("a_sd_mm").get<double>(),
              json.at("A_mm").at("sd").get<double>(), 5e-4);
  const auto patient = anatomy::loadPatient(out / "ear.toml");
  ASSERT_TRUE(patient) << patient.error().message;
  EXPECT_EQ(json.at("provenance").at("series_key"), patient->origin.seriesKey);
  EXPECT_EQ(patient->origin.landmarksByHand, "");
  EXPECT_EQ(patient->origin.landmarksProposed, "RW, OW, B1, B2, H, A, C");
  EXPECT_THAT(contentOf(out / "ear.toml"),
              testing::HasSubstr(json.at("provenance").at("series_key").get<std::string>()));
}

TEST(CtMeasure, TakesLandmarksOfSlicerInBothCoordinateSystems)
{
  TemporaryFolder out;
  const CtPhantom& truth = onDisk().phantom;
  const Eigen::Vector3d rw = truth.roundWindow_P, c = *truth.marks[ct::Mark::modiolus];
  const auto write = [&](const std::string& name, const std::string& system, double sign) {
    const auto point = [&](const char* label, const Eigen::Vector3d& place) {
      return Json{{"label", label},
                  {"positionStatus", "defined"},
                  {"position", {sign * place.x(), sign * place.y(), place.z()}}};
    };
    const Json json = {{"markups",
                        {{{"type", "Fiducial"},
                          {"coordinateSystem", system},
                          {"controlPoints", {point("RW", rw), point("C", c)}}}}}};
    std::ofstream(out / name) << json.dump();
    const auto done = cli({"ct", "measure", onDisk().path(), "--landmarks", out / name, "--json",
                           out / (name + ".out")});
    EXPECT_EQ(done.status, 0) << done.err;
    Json measured = jsonOf(out / (name + ".out"));
    measured.erase("seconds");
    return measured;
  };
  const Json lps = write("lps.mrk.json", "LPS", 1.0), ras = write("ras.mrk.json", "RAS", -1.0);
  EXPECT_EQ(lps, ras);
  EXPECT_NEAR(lps.at("A_mm").at("value").get<double>(), truth.a,
              3.0 * lps.at("A_mm").at("sd").get<double>());
}

TEST(CtMeasure, RefusesLandmarksOfAnotherShapeInOneSentence)
{
  TemporaryFolder out;
  int count = 0;
  for (const char* text :
       {"", "[]", "{\"markups\": 3}", "{\"markups\": []}", "{\"markups\": [3]}",
        R"({"markups": [{"coordinateSystem": "IJK", "controlPoints": []}]})",
        R"({"markups": [{"coordinateSystem": "LPS", "controlPoints": [{"label": "X"}]}]})",
        R"({"markups": [{"coordinateSystem": "LPS", "controlPoints": [{"label": "RW"}]}]})",
        R"({"markups": [{"coordinateSystem": "LPS", "controlPoints":
            [{"label": "RW", "position": [1, 2, "x"]}]}]})"}) {
    const auto file = out / (std::to_string(++count) + ".mrk.json");
    std::ofstream(file) << text;
    expectRefusal(cli({"ct", "measure", onDisk().path(), "--landmarks", file}),
                  "is no Slicer markups file");
  }
}

TEST(CtMeasure, FailsWithOneSentence)
{
  TemporaryFolder out;
  const std::string path = onDisk().path(), json = out / "m.json";
  expectRefusal(cli({"ct", "measure", path, "--at", "900,0,0", "--json", json}),
                "lies outside the volume");
  expectRefusal(cli({"ct", "measure", path, "--series", "9.9", "--json", json}),
                "holds no series 9.9");
  expectRefusal(cli({"ct", "measure", out.path() / "nothing", "--json", json}), "does not exist");
  expectRefusal(cli({"ct", "info", out.path()}), "holds no DICOM image");
  EXPECT_FALSE(std::filesystem::exists(json));
}

TEST(CtMeasure, WritesNoDuctLengthOfAShortCochlea)
{
  TemporaryFolder out;
  PhantomCondition condition;
  condition.turns = 1.5;
  const CtPhantom ear = makeCtPhantom(502, clinicalScan(), condition);
  writeDicomFiles(dicomSlices(ear.volume), out / "ct");
  const std::string at = std::to_string(ear.inside_P.x()) + "," + std::to_string(ear.inside_P.y()) +
                         "," + std::to_string(ear.inside_P.z());
  const auto done = cli({"ct", "measure", out / "ct", "--at", at, "--json", out / "m.json"});
  ASSERT_EQ(done.status, 0) << done.err;
  const Json json = jsonOf(out / "m.json");
  EXPECT_TRUE(json.at("cdl_oc_mm").is_null());
  EXPECT_THAT(json.at("cdl_oc_reason").get<std::string>(), testing::HasSubstr("2.5 turns"));
  EXPECT_THAT(json.at("flags"), testing::Contains("few_turns"));
  EXPECT_THAT(done.out, testing::HasSubstr("CDL (OC)     not given"));
  expectRefusal(cli({"ct", "measure", out / "ct", "--at", at, "--patient", out / "p.toml"}),
                "2.5 turns");
}

TEST(CtMeasure, WritesNoDuctLengthOfACavityInsteadOfUpperTurns)
{
  TemporaryFolder out;
  PhantomCondition condition;
  condition.turns = 1.5;
  condition.isCystic = true;
  const CtPhantom ear = makeCtPhantom(502, clinicalScan(), condition);
  writeDicomFiles(dicomSlices(ear.volume), out / "ct");
  const std::string at = std::to_string(ear.inside_P.x()) + "," + std::to_string(ear.inside_P.y()) +
                         "," + std::to_string(ear.inside_P.z());
  const auto done = cli({"ct", "measure", out / "ct", "--at", at, "--json", out / "m.json"});
  ASSERT_EQ(done.status, 0) << done.err;
  const Json json = jsonOf(out / "m.json");
  EXPECT_TRUE(json.at("cdl_oc_mm").is_null());
  EXPECT_THAT(json.at("cdl_oc_reason").get<std::string>(), testing::HasSubstr("modiolus"));
  EXPECT_THAT(json.at("flags"), testing::Contains("cystic_apex"));
  EXPECT_THAT(done.out, testing::HasSubstr("CDL (OC)     not given: no modiolus"));
}

TEST(CtExport, WritesVoxelsAndGeometryWithoutThePatient)
{
  TemporaryFolder out;
  const auto done = cli({"ct", "export", onDisk().path(), "--out", out / "ear.nrrd"});
  ASSERT_EQ(done.status, 0) << done.err;
  const std::string content = contentOf(out.path() / "ear.nrrd");
  expectNoPatient(content);
  EXPECT_THAT(content.substr(0, 400), testing::HasSubstr("sizes: 63 63 63"));
  EXPECT_GT(content.size(), 2u * 63 * 63 * 63);
  const auto again =
      cli({"ct", "measure", out / "ear.nrrd", "--at", onDisk().at(), "--json", out / "again.json"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_NEAR(jsonOf(out.path() / "again.json").at("A_mm").at("value").get<double>(),
              onDisk().phantom.a, 0.4);
  expectRefusal(cli({"ct", "export", onDisk().path(), "--out", out / "ear.dcm"}), ".nrrd");
}

TEST(CtMeasure, ReportsUsageErrors)
{
  expectUsageError(cli({"ct"}), "subcommand");
  expectUsageError(cli({"ct", "measure"}), "path");
  for (const char* at : {"1,2", "1,2,3,4", "1;2;3", "a,b,c", "1,2,nan", "1,2,3x"})
    expectUsageError(cli({"ct", "measure", "x", "--at", at}), "X,Y,Z");
  expectUsageError(cli({"ct", "measure", "x", "--side", "neither"}), "neither");
  expectRefusal(cli({"ct", "measure", "x", "--side", "both", "--at", "1,2,3"}), "--at");
  expectRefusal(cli({"ct", "measure", "x", "--side", "both", "--surface", "w.stl"}), "one ear");
  expectUsageError(cli({"ct", "measure", "x", "--at", "1,2,3", "--landmarks", "y"}), "excludes");
  // a negative first number is no option
  expectRefusal(cli({"ct", "measure", "nowhere", "--at", "-12,3,-4"}), "does not exist");
  expectRefusal(cli({"ct", "measure", "nowhere", "--at=-12,3,-4"}), "does not exist");
}

TEST(CtMeasure, ListsEveryFlagInItsHelp)
{
  const auto help = cli({"ct", "measure", "--help"});
  EXPECT_EQ(help.status, 0);
  for (const ct::Flag flag : ct::allFlags())
    EXPECT_THAT(help.out, testing::HasSubstr(ct::nameOf(flag)));
}

TEST(CtMeasure, ReplacesNoFileOfTheSeries)
{
  const auto slice = std::filesystem::directory_iterator(onDisk().path())->path();
  const std::string before = contentOf(slice);
  expectRefusal(cli({"ct", "measure", onDisk().path(), "--at", onDisk().at(), "--json", slice}),
                "which path reads");
  expectRefusal(cli({"ct", "info", onDisk().path(), "--json", slice}), "which path reads");
  EXPECT_EQ(contentOf(slice), before);
}

}  // namespace
}  // namespace perilymph::test
