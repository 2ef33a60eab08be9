#pragma once

// What the window remembers from one start to the next.

#include <QSettings>

namespace perilymph::gui {

/// The user's settings: perilymph/perilymph.ini in the XDG configuration home. What an older or an
/// unknown format left there is forgotten, and the log says so; values out of range count as not
/// set.
class UserSettings : public QSettings {
public:
  static constexpr int format = 1;
  UserSettings();

  /// One of the words allowed; the first of them where there is none or another one.
  QString word(const QString& key, const QStringList& allowed) const;
};

}  // namespace perilymph::gui
