// SPDX-License-Identifier: BSD-3-Clause

// The tone of a force: its pitch by the rule in the menu, its samples by counting.

#include "gui/pages/insert/ForceTone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace perilymph::test {
namespace {

using gui::toneOf;
using gui::ToneWriter;

TEST(ForceTone, IsAnOctaveHigherForEach100Millinewtons)
{
  for (const double force_mN : {10.0, 50.0, 150.0, 250.0}) {
    const double low = toneOf(millinewtons(force_mN)).frequency_Hz;
    EXPECT_NEAR(toneOf(millinewtons(force_mN + 100.0)).frequency_Hz / low, 2.0, 1e-12) << force_mN;
  }
  EXPECT_NEAR(toneOf(millinewtons(100)).frequency_Hz, 440.0, 1e-9);  // one above 220 Hz
}

TEST(ForceTone, IsSilentBelowFiveMillinewtonsAndOfWhatIsNoNumber)
{
  for (const double force : {0.0, 0.0049, -0.0049, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(toneOf(Force::fromSi(force)).loudness, 0.0) << force;
  EXPECT_GT(toneOf(millinewtons(5)).loudness, 0.0);
}

TEST(ForceTone, StaysWhereEarsHearWhateverTheForce)
{
  EXPECT_NEAR(toneOf(newtons(1000)).frequency_Hz, 3520.0, 1e-9);  // four octaves above 220 Hz
  EXPECT_EQ(toneOf(millinewtons(-80)).frequency_Hz, toneOf(millinewtons(80)).frequency_Hz);
}

std::vector<std::int16_t> samples(ToneWriter& writer, double seconds)
{
  std::vector<std::int16_t> written(std::size_t(seconds * ToneWriter::samplesPerSecond));
  writer.write(written.data(), int(written.size()));
  return written;
}

int loudest(const std::vector<std::int16_t>& written)
{
  int maximum = 0;
  for (const std::int16_t sample : written) maximum = std::max(maximum, std::abs(int(sample)));
  return maximum;
}

TEST(ToneSamples, SwingAsOftenAsTheToneSays)
{
  ToneWriter writer;
  writer.setTone({440.0, 1.0});
  const auto written = samples(writer, 0.2);
  int rises = 0;
  for (std::size_t i = 1; i < written.size(); ++i) rises += written[i - 1] < 0 && written[i] >= 0;
  EXPECT_NEAR(rises, 0.2 * 440.0, 1.0);
}

TEST(ToneSamples, DoNotJump)
{
  ToneWriter writer;
  std::vector<std::int16_t> all;
  for (const gui::Tone tone : {gui::Tone{3520.0, 1.0}, gui::Tone{}, gui::Tone{220.0, 1.0}}) {
    writer.setTone(tone);
    const auto more = samples(writer, 0.05);
    all.insert(all.end(), more.begin(), more.end());
  }
  // the maximum slope of the loudest sine of the highest pitch, plus that of the changing loudness
  const double steepest =
      loudest(all) * (2.0 * M_PI * 3520.0 + 100.0) / ToneWriter::samplesPerSecond;
  for (std::size_t i = 1; i < all.size(); ++i)
    EXPECT_LE(std::abs(all[i] - all[i - 1]), steepest + 1.0) << i;
}

TEST(ToneSamples, FadeWhenNobodyRenewsTheTone)
{
  ToneWriter writer;
  writer.setTone({440.0, 1.0});
  EXPECT_GT(loudest(samples(writer, 0.2)), 1000);
  samples(writer, 0.1);
  EXPECT_EQ(loudest(samples(writer, 0.1)), 0);
}

}  // namespace
}  // namespace perilymph::test
