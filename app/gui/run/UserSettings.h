// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Persistent settings of the window.

#include <QSettings>

namespace perilymph::gui {

/// The user's settings: perilymph/perilymph.ini in the XDG configuration home. Content in an older
/// or unknown format is discarded, with an entry in the log; values out of range are ignored.
class UserSettings : public QSettings {
public:
  static constexpr int format = 1;
  UserSettings();

  /// One of the allowed words; the one at the index `unset` if none or another one is stored.
  QString word(const QString& key, const QStringList& allowed, int unset = 0) const;
};

}  // namespace perilymph::gui
