#pragma once

// What the window remembers from one start to the next.

#include <QSettings>

namespace perilymph::gui {

/// The user's settings: perilymph/perilymph.ini in the XDG configuration home. What an older
/// format left there is forgotten; a newer one is read as far as its words are known.
class Settings : public QSettings {
public:
  static constexpr int format = 1;
  Settings();
};

}  // namespace perilymph::gui
