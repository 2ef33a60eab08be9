// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The sound of Qt 5 and of Qt 6 under one set of names: the only place that knows of both.

#include <QAudioFormat>
#include <QtGlobal>

#if QT_VERSION_MAJOR >= 6
#include <QAudioDevice>
#include <QAudioSink>
#include <QMediaDevices>
#else
#include <QAudioDeviceInfo>
#include <QAudioOutput>
#endif

namespace perilymph::gui {

#if QT_VERSION_MAJOR >= 6

using AudioDevice = QAudioDevice;
using AudioOutput = QAudioSink;

/// Returns the device on which the system plays; isNull() without one.
inline AudioDevice defaultAudioOutput() { return QMediaDevices::defaultAudioOutput(); }

/// Samples are signed integers of 16 bits, in the byte order of the machine.
inline void setSigned16Bit(QAudioFormat& format) { format.setSampleFormat(QAudioFormat::Int16); }

#else

using AudioDevice = QAudioDeviceInfo;
using AudioOutput = QAudioOutput;

/// Returns the device on which the system plays; isNull() without one.
inline AudioDevice defaultAudioOutput() { return QAudioDeviceInfo::defaultOutputDevice(); }

/// Samples are signed integers of 16 bits, in the byte order of the machine.
inline void setSigned16Bit(QAudioFormat& format)
{
  format.setSampleSize(16);
  format.setSampleType(QAudioFormat::SignedInt);
  format.setByteOrder(QAudioFormat::Endian(QSysInfo::ByteOrder));
  format.setCodec(QStringLiteral("audio/pcm"));
}

#endif

}  // namespace perilymph::gui
