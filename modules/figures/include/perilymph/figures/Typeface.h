#pragma once

// The one typeface of charts and pictures.

#include <string>

namespace perilymph::figures {

/// The file of Inter: the copy that ships with the program, else the system's, else DejaVu Sans;
/// empty if there is none of them.
const std::string& typefaceFile();

}  // namespace perilymph::figures
