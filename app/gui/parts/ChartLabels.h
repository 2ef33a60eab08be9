#pragma once

// What the charts and the picture say, in the window's language.

#include <QString>
#include <string>

namespace perilymph::gui {

/// Gives the charts and the picture their words; after the language was chosen, before a window is
/// made.
void translateCharts();

/// The name of a reference; as its file calls it where no translation is known.
QString referenceName(const std::string& label);

}  // namespace perilymph::gui
