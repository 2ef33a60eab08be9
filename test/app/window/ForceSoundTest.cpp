// SPDX-License-Identifier: BSD-3-Clause

// The tone as a listener hears it: played to a sound server of the test's own, and recorded from its speaker. The oracle
// is the rule in the menu: 100 mN are an octave above 220 Hz.

#include "gui/pages/insert/ForceSound.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

namespace perilymph::test {
namespace {

constexpr int samplesPerSecond = 44100;

/// A sound server without hardware, whose only speaker is recorded.
class SoundServer {
public:
  SoundServer()
  {
    const QString socket = folder_.filePath(QStringLiteral("socket"));
    qputenv("PULSE_SERVER", "unix:" + socket.toUtf8());
    qputenv("PULSE_RUNTIME_PATH", folder_.path().toUtf8());
    // Qt 6 would first look for another server, that of the user's session.
    qputenv("PIPEWIRE_RUNTIME_DIR", folder_.path().toUtf8());
    server_.start(
        QStringLiteral("pulseaudio"),
        {QStringLiteral("-n"), QStringLiteral("--daemonize=no"),
         QStringLiteral("--use-pid-file=no"), QStringLiteral("--exit-idle-time=-1"),
         QStringLiteral("--disable-shm=yes"), QStringLiteral("-L"),
         QStringLiteral("module-null-sink sink_name=speaker rate=44100 channels=1"),
         QStringLiteral("-L"),
         QStringLiteral("module-native-protocol-unix auth-anonymous=1 socket=") + socket});
    isReady_ = server_.waitForStarted() &&
               QTest::qWaitFor([&socket] { return QFileInfo::exists(socket); }, 20000);
    recorder_.setStandardOutputFile(recording());
    recorder_.start(QStringLiteral("parec"),
                    {QStringLiteral("--device=speaker.monitor"), QStringLiteral("--format=s16le"),
                     QStringLiteral("--rate=44100"), QStringLiteral("--channels=1"),
                     QStringLiteral("--raw"), QStringLiteral("--latency-msec=50")});
    // It writes silence as soon as it listens.
    isReady_ = isReady_ && recorder_.waitForStarted() &&
               QTest::qWaitFor([this] { return QFileInfo(recording()).size() > 0; }, 20000);
  }

  ~SoundServer()
  {
    stop(recorder_);
    stop(server_);
  }

  bool isReady() const { return isReady_; }

  /// Everything that was heard so far.
  std::vector<std::int16_t> heard() const
  {
    QFile file(recording());
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QByteArray bytes = file.readAll();
    std::vector<std::int16_t> samples(std::size_t(bytes.size()) / sizeof(std::int16_t));
    if (!samples.empty())
      std::memcpy(samples.data(), bytes.constData(), samples.size() * sizeof(std::int16_t));
    return samples;
  }

private:
  QString recording() const { return folder_.filePath(QStringLiteral("heard")); }

  static void stop(QProcess& process)
  {
    process.terminate();
    if (!process.waitForFinished(5000)) process.kill();
    process.waitForFinished();
  }

  QTemporaryDir folder_;
  QProcess server_, recorder_;
  bool isReady_ = false;
};

/// The pitch of what was heard [Hz], of a second at least: from the median duration of ten swings, because a busy
/// machine leaves gaps.
std::optional<double> pitchOf(const std::vector<std::int16_t>& samples)
{
  const auto isLoud = [](std::int16_t sample) { return sample > 1000 || sample < -1000; };
  const auto begin = std::find_if(samples.begin(), samples.end(), isLoud);
  if (samples.end() - begin < samplesPerSecond) return std::nullopt;
  std::vector<std::ptrdiff_t> rises;
  for (auto sample = begin; sample + 1 < samples.end(); ++sample)
    if (*sample < 0 && *(sample + 1) >= 0) rises.push_back(sample - begin);
  constexpr std::size_t swings = 10;
  std::vector<std::ptrdiff_t> durations;
  for (std::size_t i = 0; i + swings < rises.size(); ++i)
    durations.push_back(rises[i + swings] - rises[i]);
  if (durations.empty()) return std::nullopt;
  std::nth_element(durations.begin(), durations.begin() + std::ptrdiff_t(durations.size() / 2),
                   durations.end());
  return double(swings) * samplesPerSecond / double(durations[durations.size() / 2]);
}

TEST(ForceSound, IsHeardFromTheSpeakerAtThePitchOfTheForce)
{
  for (const char* program : {"pulseaudio", "parec"})
    if (QStandardPaths::findExecutable(QString::fromLatin1(program)).isEmpty())
      GTEST_SKIP() << program << " is not installed (Debian: pulseaudio, pulseaudio-utils).";
  SoundServer server;
  ASSERT_TRUE(server.isReady());
  gui::ForceSound sound(nullptr);
  std::optional<QString> reason;
  QObject::connect(&sound, &gui::ForceSound::known, &sound,
                   [&reason](const QString& why) { reason = why; });
  sound.setOn(true);
  ASSERT_TRUE(QTest::qWaitFor([&reason] { return reason.has_value(); }, 20000));
  ASSERT_EQ(reason->toStdString(), "");
  std::optional<double> pitch_Hz;
  // The longer it is heard, the less do the gaps of a busy machine count.
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        sound.show(millinewtons(100));
        pitch_Hz = pitchOf(server.heard());
        return pitch_Hz && std::abs(*pitch_Hz - 440.0) < 2.0;
      },
      20000))
      << server.heard().size() << " samples were heard, " << pitch_Hz.value_or(0.0) << " Hz";

  // A sound turned off ends, though the force is still shown.
  sound.setOn(false);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        sound.show(millinewtons(100));
        const auto all = server.heard();
        return all.size() > samplesPerSecond / 2 &&
               std::all_of(all.end() - samplesPerSecond / 2, all.end(),
                           [](std::int16_t sample) { return sample == 0; });
      },
      20000));
}

}  // namespace
}  // namespace perilymph::test
