// SPDX-License-Identifier: BSD-3-Clause

// `ct contacts` with phantoms, and with series that are no CT after surgery of the ear.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/test/Cli.h"
#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/DicomWriter.h"
#include "perilymph/test/HostileSeries.h"
#include "perilymph/test/ImplantPhantom.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string textOf(const Eigen::Vector3d& point)
{
  return std::to_string(point.x()) + "," + std::to_string(point.y()) + "," +
         std::to_string(point.z());
}

/// The command with files to write, of which a refused call may leave none.
struct Call {
  TemporaryFolder out;
  ProgramOutcome run(std::vector<std::string> arguments) const
  {
    std::vector<std::string> all{"ct", "contacts"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    for (const std::string& each :
         {std::string("--array"), std::string("flex24"), std::string("--json"),
          (out / "o.json").string(), std::string("--csv"), (out / "o.csv").string()})
      all.push_back(each);
    return cli(all);
  }
  /// One sentence on one line, and nothing written.
  void expectRefusal(const std::vector<std::string>& arguments, const std::string& part) const
  {
    const auto done = run(arguments);
    EXPECT_EQ(done.status, 1) << part;
    EXPECT_EQ(done.out, "") << part;
    EXPECT_THAT(done.err, testing::HasSubstr(part));
    EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    EXPECT_THAT(done.err, testing::Not(testing::HasSubstr("Secretname")));
    EXPECT_TRUE(fs::is_empty(out.path())) << part;
  }
};

TEST(CtContacts, RefusesWhatIsNoSeriesOfOneEarAndWritesNothing)
{
  const CtPhantom phantom = makeCtPhantom(203, highResolutionScan());
  for (const HostileSeries& each : hostileSeries()) {
    SCOPED_TRACE(each.name);
    const TemporaryFolder folder;
    each.write(dicomSlices(phantom.volume), folder / "ct");
    Call().expectRefusal({(folder / "ct").string(), "--at", textOf(phantom.inside_P)},
                         each.sentence);
  }
}

TEST(CtContacts, RefusesACtWithoutMetal)
{
  const CtPhantom phantom = makeCtPhantom(203, highResolutionScan());
  const TemporaryFolder folder;
  writeDicomFiles(dicomSlices(phantom.volume), folder / "ct");
  Call().expectRefusal({(folder / "ct").string(), "--at", textOf(phantom.inside_P)},
                       "There is no array in this ear");
}

/// An implanted ear as two folders, written once. Its contacts are 1.9 mm apart.
struct ImplantOnDisk {
  ImplantPhantom phantom = [] {
    ImplantCondition condition;
    condition.array = "flex24";
    return makeImplantPhantom(31, highResolutionImplantScan(), condition);
  }();
  TemporaryFolder folder;
  ImplantOnDisk()
  {
    writeDicomFiles(dicomSlices(phantom.preoperative.volume, "1.2.3.31"), folder / "before");
    writeDicomFiles(dicomSlices(phantom.postoperative, "1.2.4.31"), folder / "after");
  }
  std::string before() const { return (folder / "before").string(); }
  std::string after() const { return (folder / "after").string(); }
  std::string atBefore() const { return textOf(phantom.preoperative.inside_P); }
  std::string atAfter() const { return textOf(phantom.truth.inside_P); }
};

const ImplantOnDisk& implant()
{
  static const ImplantOnDisk made;
  return made;
}

TEST(CtContacts, FindsThemWhereTheyAreAndSaysThatTheImagesStateTheOtherSide)
{
  // the scanner's operator chose the wrong side
  auto slices = dicomSlices(implant().phantom.postoperative, "1.2.4.31");
  for (DicomData& each : slices)
    each.setText(0x00200060, "CS", implant().phantom.truth.isRight ? "L" : "R");
  const TemporaryFolder folder;
  writeDicomFiles(slices, folder / "after");
  const Call call;
  const auto done = call.run(
      {(folder / "after").string(), "--preop", implant().before(), "--at", implant().atBefore()});
  ASSERT_EQ(done.status, 0) << done.err;
  const Json json = Json::parse(contentOf(call.out / "o.json"));
  const auto& truth = implant().phantom.truth;
  ASSERT_EQ(json.at("contacts").size(), truth.contacts.size());
  for (std::size_t i = 0; i < truth.contacts.size(); ++i) {
    const Json& place = json["contacts"][i]["position_lps_mm"];
    const Eigen::Vector3d found(place[0].get<double>(), place[1].get<double>(),
                                place[2].get<double>());
    // twice the 95th percentile of the table in the README of the module outcome; a neighbor is 1.9 mm away
    EXPECT_LT((found - truth.contacts[i].position_P).norm(), 0.44) << i;
  }
  EXPECT_EQ(json.at("side"), truth.isRight ? "right" : "left");
  EXPECT_THAT(done.out, testing::HasSubstr("The images state a "));
}

TEST(CtContacts, OfAnotherPatientsRecordAreFlagged)
{
  const TemporaryFolder folder;
  anatomy::Patient patient;
  patient.label = "P-9";
  patient.side = implant().phantom.truth.isRight ? anatomy::Side::right : anatomy::Side::left;
  patient.basalTurn = anatomy::BasalTurn{millimeters(implant().phantom.truth.a + 1.2),
                                         millimeters(implant().phantom.truth.b), std::nullopt};
  ASSERT_TRUE(anatomy::savePatient(patient, folder / "patient.toml"));
  const Call call;
  const auto done = call.run({implant().after(), "--preop", implant().before(), "--at",
                              implant().atBefore(), "--patient", folder / "patient.toml"});
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_THAT(done.out, testing::HasSubstr("another_ear"));
  EXPECT_THAT(done.out, testing::HasSubstr("mm for the patient"));
  EXPECT_THAT(contentOf(call.out / "o.json"), testing::HasSubstr("another_ear"));
}

TEST(CtContacts, RefusesAPairOfCtsInWhichOneIsNotWhatItIsGivenAs)
{
  // the CT after surgery as that before it: the same series, and another one with metal
  Call().expectRefusal(
      {implant().after(), "--preop", implant().after(), "--at", implant().atAfter()},
      "are the same series");
  const TemporaryFolder folder;
  writeDicomFiles(dicomSlices(implant().phantom.postoperative, "1.2.4.32"), folder / "again");
  Call().expectRefusal(
      {implant().after(), "--preop", (folder / "again").string(), "--at", implant().atAfter()},
      "shows metal in the cochlea");
  // both the wrong way round
  Call().expectRefusal(
      {implant().before(), "--preop", implant().after(), "--at", implant().atAfter()},
      "shows metal in the cochlea");
  // the CT before surgery as that after it
  Call().expectRefusal({implant().before(), "--at", implant().atBefore()},
                       "There is no array in this ear");
}

TEST(CtContacts, RefusesTheCtBeforeSurgeryOfAnotherPatient)
{
  const CtPhantom other = makeCtPhantom(203, highResolutionScan());
  const TemporaryFolder folder;
  writeDicomFiles(dicomSlices(other.volume, "1.2.3.203"), folder / "other");
  const Call call;
  const auto done = call.run(
      {implant().after(), "--preop", (folder / "other").string(), "--at", textOf(other.inside_P)});
  // found or not, it is said
  EXPECT_THAT(done.out + done.err, testing::HasSubstr("do not agree"));
  EXPECT_TRUE(done.status == 0 || fs::is_empty(call.out.path()));
}

}  // namespace
}  // namespace perilymph::test
