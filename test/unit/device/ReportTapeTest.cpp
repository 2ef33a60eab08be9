// SPDX-License-Identifier: BSD-3-Clause

// Tapes of reports: written by hid-recorder, written by the program, damaged, recorded and played.

#include "tape/ReportTape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "VirtualTime.h"
#include "perilymph/test/FakeHid.h"
#include "perilymph/test/TemporaryFolder.h"
#include "tape/TapePorts.h"
#include "tape/TapeReader.h"

namespace perilymph::device {
namespace {

using test::FakeHid;
using test::FakeReport;
using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

// Output of hid-recorder 1.x (hid-tools) for a mouse with three buttons.
constexpr const char* hidRecorded = R"(# Mouse
D: 0
R: 52 05 01 09 02 a1 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 02 95 01 75 05 81 03 05 01 09 30 09 31 09 38 15 81 25 7f 75 08 95 03 81 06 c0 c0
N: A maker's mouse
P: usb-0000:00:14.0-1/input0
I: 3 046d c077
E: 000000.000000 4 00 01 00 00
E: 000000.008012 4 01 fe 00 00
)";

Result<ReportTape> taped(const std::string& lines)
{
  return parseTape(std::string(hidRecorded) + lines, "a tape");
}

TEST(ReportTape, ReadsWhatHidRecorderWrote)
{
  const auto tape = taped("");
  ASSERT_TRUE(tape) << tape.error().message;
  EXPECT_EQ(tape->name, "A maker's mouse");
  EXPECT_EQ(tape->bus, 3u);
  EXPECT_EQ(tape->identity.vendor, 0x046d);
  EXPECT_EQ(tape->identity.product, 0xc077);
  EXPECT_EQ(tape->descriptor.size(), 52u);
  ASSERT_EQ(tape->entries.size(), 2u);
  EXPECT_EQ(tape->entries[1].time, 8'012'000);
  // A mouse without report numbers: RawReport prepends a 0.
  EXPECT_EQ(tape->entries[1].bytes, (Bytes{0, 1, 0xfe, 0, 0}));
}

TEST(ReportTape, ReadsBackEveryLineItWrites)
{
  RawReport report;
  report.bytes[1] = 0xab;
  report.size = 3;
  const auto tape = taped(tapeLine(TapeEvent::written, 10 * millisecond, 977'001, report) +
                          tapeLine(TapeEvent::refused, 11 * millisecond, 5, report) +
                          tapeLine(TapeEvent::featureSet, 12 * millisecond, 6, report) +
                          tapeLine(TapeEvent::featureGot, 13 * millisecond, 7, report) +
                          tapeLine(TapeEvent::gone, 14 * millisecond, 0, {}));
  ASSERT_TRUE(tape) << tape.error().message;
  ASSERT_EQ(tape->entries.size(), 7u);
  const TapeEntry& written = tape->entries[2];
  EXPECT_EQ(written.event, TapeEvent::written);
  EXPECT_EQ(written.time, 10 * millisecond);
  EXPECT_EQ(written.took, 977'001);
  EXPECT_EQ(written.bytes, (Bytes{0, 0xab, 0}));
  EXPECT_EQ(tape->entries[3].event, TapeEvent::refused);
  EXPECT_EQ(tape->entries[4].event, TapeEvent::featureSet);
  EXPECT_EQ(tape->entries[5].event, TapeEvent::featureGot);
  EXPECT_EQ(tape->entries[6].event, TapeEvent::gone);
}

TEST(ReportTape, KeepsIdentityAndDescriptorInItsHead)
{
  const auto first = taped("");
  ASSERT_TRUE(first);
  const auto again = parseTape(tapeHead(*first) + "E: 000000.000000 4 00 01 00 00\n", "again");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->name, first->name);
  EXPECT_EQ(again->identity.product, first->identity.product);
  EXPECT_EQ(again->descriptor, first->descriptor);
}

struct Damage {
  const char* line;
  const char* complaint;
};

class DamagedTape : public testing::TestWithParam<Damage> {};

TEST_P(DamagedTape, IsAnsweredWithItsLineAndASentence)
{
  const auto tape = taped(std::string(GetParam().line) + "\n");
  ASSERT_FALSE(tape);
  EXPECT_THAT(tape.error().message, HasSubstr("a tape, line 9: "));
  EXPECT_THAT(tape.error().message, HasSubstr(GetParam().complaint));
}

INSTANTIATE_TEST_SUITE_P(
    Lines, DamagedTape,
    testing::Values(Damage{"E: noon 4 00 01 00 00", "seconds"},
                    Damage{"E: 0.5 4 00 01 00", "hexadecimal bytes"},
                    Damage{"E: 0.5 4 00 01 00 00 00", "more on the line"},
                    Damage{"E: 0.5 4 00 01 00 100", "hexadecimal bytes"},
                    Damage{"E: 0.5 0", "hexadecimal bytes"},
                    Damage{"E: 0.5 99999 00", "hexadecimal bytes"},
                    Damage{"E: -1.0 1 00", "seconds"}, Damage{"E: 0.1234567891 1 00", "decimals"},
                    Damage{"W: 0.5 4 00 01 00 00", "hexadecimal bytes"},
                    Damage{"I: 3 046d", "identity"}, Damage{"I: 3 046d 1c0770", "identity"},
                    Damage{"R: 5000 05", "at most 4096"}, Damage{"D: 1", "one device"},
                    Damage{"\x7f"
                           "ELF",
                           "not a line of a tape"}));

TEST(ReportTape, LeavesOutALastLineThatWasCutOff)
{
  const auto tape = taped("E: 000000.016000 4 01 f");
  ASSERT_TRUE(tape) << tape.error().message;
  EXPECT_EQ(tape->entries.size(), 2u);
}

TEST(ReportTape, IsRefusedWhereThereIsNone)
{
  EXPECT_FALSE(parseTape("", "nothing"));
  EXPECT_FALSE(parseTape("# a remark\n", "a remark"));
  EXPECT_THAT(loadTape("no-such-tape.hid").error().message, HasSubstr("no-such-tape.hid"));
}

TEST(RecordedPort, KeepsWhatWasReadAndWrittenWithItsTimes)
{
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "capture.hid";
  virtualNow = 5 * millisecond;
  FakeHid hid;
  {
    ReportTape head;
    head.name = "Fake";
    const auto port = recordingPort(hid.port(), file, head, virtualClock);
    ASSERT_TRUE(port) << port.error().message;
    const auto reading = (*port)->open();
    const auto writing = (*port)->open();
    ASSERT_TRUE(reading && writing);
    RawReport report;
    virtualNow = 7 * millisecond;
    hid.send(FakeReport{42, {1, 2, 3}, 1});
    EXPECT_EQ((*reading)->read(report, {}), Transfer::done);
    EXPECT_EQ((*reading)->read(report, {}), Transfer::nothing);
    virtualNow = 8 * millisecond;
    report.size = 7;
    EXPECT_EQ((*writing)->write(report), Transfer::done);
    hid.refuseWrites(true);
    EXPECT_EQ((*writing)->write(report), Transfer::failed);
    virtualNow = 9 * millisecond;
    hid.unplug();
    EXPECT_EQ((*reading)->read(report, {}), Transfer::gone);
  }
  const auto tape = loadTape(file);
  ASSERT_TRUE(tape) << tape.error().message;
  ASSERT_EQ(tape->entries.size(), 4u);
  const RawReport sent = FakeReport{42, {1, 2, 3}, 1}.raw();
  EXPECT_EQ(tape->entries[0].event, TapeEvent::input);
  EXPECT_EQ(tape->entries[0].time, 2 * millisecond);
  EXPECT_EQ(tape->entries[0].bytes, Bytes(sent.view().begin(), sent.view().end()));
  EXPECT_EQ(tape->entries[1].event, TapeEvent::written);
  EXPECT_EQ(tape->entries[1].time, 3 * millisecond);
  EXPECT_EQ(tape->entries[2].event, TapeEvent::refused);
  EXPECT_EQ(tape->entries[3].event, TapeEvent::gone);
  EXPECT_EQ(tape->lost, 0u);
}

TEST(RecordedPort, SaysWhereItCannotWrite)
{
  FakeHid hid;
  const auto port = recordingPort(hid.port(), "no/such/folder/capture.hid", {});
  ASSERT_FALSE(port);
  EXPECT_THAT(port.error().message, HasSubstr("no/such/folder/capture.hid"));
}

ReportTape tapeOf(const std::vector<std::pair<std::int64_t, FakeReport>>& reports)
{
  ReportTape tape;
  for (const auto& [time, report] : reports) {
    const RawReport raw = report.raw();
    tape.entries.push_back({time, 0, TapeEvent::input, {raw.view().begin(), raw.view().end()}});
  }
  return tape;
}

TEST(PlayedPort, RepeatsEveryReportAtItsTime)
{
  virtualNow = 100 * millisecond;
  const auto port = playingPort(tapeOf({{0, {1, {}, 0}}, {3 * millisecond, {2, {}, 0}}}),
                                {virtualClock, [](std::int64_t passed) { virtualNow += passed; }});
  const auto handle = *port->open();
  RawReport report;
  EXPECT_EQ(handle->read(report, {}), Transfer::done);
  EXPECT_EQ(report.bytes[1], 1);
  EXPECT_EQ(handle->read(report, {}), Transfer::nothing);
  EXPECT_EQ(handle->read(report, Duration::fromSi(0.002)), Transfer::nothing);
  EXPECT_EQ(virtualNow, 102 * millisecond);
  EXPECT_EQ(handle->read(report, Duration::fromSi(0.002)), Transfer::done);
  EXPECT_EQ(virtualNow, 103 * millisecond);
  EXPECT_EQ(report.bytes[1], 2);
  EXPECT_EQ(handle->read(report, Duration::fromSi(0.002)), Transfer::nothing);
}

TEST(PlayedPort, RefusesTheReportThatWasRefusedAndIsGoneWhenItWasUnplugged)
{
  virtualNow = 0;
  ReportTape tape;
  tape.entries.push_back({0, 0, TapeEvent::written, {0, 1}});
  tape.entries.push_back({0, 0, TapeEvent::refused, {0, 1}});
  tape.entries.push_back({millisecond, 0, TapeEvent::gone, {}});
  const auto port = playingPort(tape, {virtualClock, [](std::int64_t t) { virtualNow += t; }});
  const auto handle = *port->open();
  RawReport report;
  EXPECT_EQ(handle->write(report), Transfer::done);
  EXPECT_EQ(handle->write(report), Transfer::failed);
  EXPECT_EQ(handle->write(report), Transfer::done);
  EXPECT_EQ(handle->read(report, Duration::fromSi(0.01)), Transfer::gone);
}

TEST(TapeReading, CountsMissingReportsAndMeasuresTheWorkspaceUsed)
{
  ReportTape tape = tapeOf({{0 * millisecond, {1, {100, 0, 0}, 0}},
                            {1 * millisecond, {2, {200, -300, 0}, 1}},
                            {2 * millisecond, {2, {200, -300, 0}, 1}},    // again
                            {4 * millisecond, {5, {-50, 0, 1000}, 0}}});  // two are missing
  tape.entries.push_back({5 * millisecond, 977'000, TapeEvent::written, {0, 1}});
  test::FakeCodec codec;
  const TapeReading told = readTape(tape, codec, 1e-3);
  EXPECT_EQ(told.reading.fresh, 3u);
  EXPECT_EQ(told.reading.duplicates, 1u);
  EXPECT_EQ(told.reading.lost, 2u);
  EXPECT_NEAR(told.reading.rate, 2.0 / 4e-3, 1e-6);
  EXPECT_NEAR(told.min_D[0], -50e-5, 1e-12);
  EXPECT_NEAR(told.max_D[0], 200e-5, 1e-12);
  EXPECT_NEAR(told.min_D[1], -300e-5, 1e-12);
  EXPECT_EQ(told.buttons, 1u);
  EXPECT_NEAR(told.writing.timeMax, 977e-6, 1e-12);
  EXPECT_NEAR(told.duration, 5e-3, 1e-12);
}

}  // namespace
}  // namespace perilymph::device
