// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/ForceSound.h"

#include <QIODevice>
#include <QMetaObject>

#include "gui/pages/insert/ForceTone.h"
#include "perilymph/foundation/RealTime.h"

#if PERILYMPH_HAS_SOUND
#include "gui/pages/insert/AudioOutput.h"
#endif

namespace perilymph::gui {

#if PERILYMPH_HAS_SOUND

namespace {

QAudioFormat format()
{
  QAudioFormat wanted;
  wanted.setSampleRate(ToneWriter::samplesPerSecond);
  wanted.setChannelCount(1);
  setSigned16Bit(wanted);
  return wanted;
}

/// An endless sample stream, generated on request of the audio output.
class Stream : public QIODevice {
public:
  explicit Stream(QObject* parent) : QIODevice(parent) { open(QIODevice::ReadOnly); }
  void setTone(const Tone& tone) { writer_.setTone(tone); }
  bool isSequential() const override { return true; }
  qint64 bytesAvailable() const override { return 8192 + QIODevice::bytesAvailable(); }

protected:
  qint64 readData(char* data, qint64 size) override
  {
    const qint64 count = size / qint64(sizeof(std::int16_t));
    writer_.write(reinterpret_cast<std::int16_t*>(data), int(count));
    return count * qint64(sizeof(std::int16_t));
  }
  qint64 writeData(const char*, qint64) override { return -1; }

private:
  ToneWriter writer_;
};

}  // namespace

/// Runs in the audio thread.
class ForceVoice : public QObject {
public:
  QString reason() const
  {
    const AudioDevice output = defaultAudioOutput();
    if (output.isNull()) return ForceSound::tr("no audio device");
    if (!output.isFormatSupported(format()))
      return ForceSound::tr("audio device does not support 16 bit at 44.1 kHz");
    return {};
  }

  void play(bool isOn)
  {
    if (isOn && output_ == nullptr) {
      stream_ = new Stream(this);
      output_ = new AudioOutput(defaultAudioOutput(), format(), this);
      output_->start(stream_);
    } else if (!isOn && output_ != nullptr) {
      output_->stop();
      delete output_;
      delete stream_;
      output_ = nullptr;
      stream_ = nullptr;
    }
  }

  void setTone(const Tone& tone)
  {
    if (stream_ != nullptr) stream_->setTone(tone);
  }

private:
  Stream* stream_ = nullptr;
  AudioOutput* output_ = nullptr;
};

#else

class ForceVoice : public QObject {
public:
  QString reason() const { return ForceSound::tr("built without audio support"); }
  void play(bool) {}
  void setTone(const Tone&) {}
};

#endif

ForceSound::ForceSound(QObject* parent) : QObject(parent), voice_(new ForceVoice)
{
  voice_->moveToThread(&thread_);
  connect(&thread_, &QThread::started, voice_, [] { declareThread(ThreadRole::sound); });
  connect(&thread_, &QThread::finished, voice_, &QObject::deleteLater);
}

ForceSound::~ForceSound()
{
  if (!thread_.isRunning()) {
    delete voice_;
    return;
  }
  thread_.quit();
  thread_.wait();
}

void ForceSound::ask()
{
  if (thread_.isRunning()) return;
  thread_.start();
  QMetaObject::invokeMethod(voice_, [this, voice = voice_] { Q_EMIT known(voice->reason()); });
}

void ForceSound::setOn(bool isOn)
{
  ask();
  isOn_ = isOn;
  QMetaObject::invokeMethod(voice_, [voice = voice_, isOn] { voice->play(isOn); });
}

void ForceSound::show(Force onHand)
{
  if (!isOn_) return;
  QMetaObject::invokeMethod(voice_,
                            [voice = voice_, tone = toneOf(onHand)] { voice->setTone(tone); });
}

}  // namespace perilymph::gui
