#include "OutputFile.h"

#include <charconv>

namespace perilymph::cli {

std::string fixed(double value, int digits)
{
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits);
  return {text, end.ptr};
}

}  // namespace perilymph::cli
