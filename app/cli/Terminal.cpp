// SPDX-License-Identifier: BSD-3-Clause
#include "Terminal.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <initializer_list>
#include <system_error>

namespace perilymph::cli {

namespace {

/// Number of characters of a UTF-8 text.
std::size_t widthOf(std::string_view text)
{
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char letter) { return (letter & 0xc0) != 0x80; }));
}

/// A padded value; `layout` is the text between the braces.
std::string placed(std::string_view layout, const std::string& value)
{
  if (layout.empty()) return value;
  layout.remove_prefix(1);  // the colon
  const bool isRight = layout.front() == '>';
  if (isRight || layout.front() == '<') layout.remove_prefix(1);
  std::size_t width = 0;
  std::from_chars(layout.data(), layout.data() + layout.size(), width);
  const std::string padding(width - std::min(width, widthOf(value)), ' ');
  return isRight ? padding + value : value + padding;
}

std::string filled(std::string_view format, std::span<const std::string> values)
{
  std::string text;
  for (const std::string& value : values) {
    const std::size_t open = format.find('{'), close = format.find('}', open);
    text += format.substr(0, open);
    text += placed(format.substr(open + 1, close - open - 1), value);
    format.remove_prefix(close + 1);
  }
  return text.append(format);
}

int outputError = 0;  // the first error of standard output, whose stream only keeps a flag

void put(std::FILE* stream, const std::string& text)
{
  const bool isTaken = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  if (!isTaken && stream == stdout && outputError == 0) outputError = errno;
}

}  // namespace

void printText(const std::string& text) { put(stdout, text); }

void printFilled(const char* format, std::span<const std::string> values)
{
  put(stdout, filled(format, values));
}

void printErrorFilled(const char* format, std::span<const std::string> values)
{
  put(stderr, filled(format, values));
}

void flushOutput()
{
  if (std::fflush(stdout) != 0 && outputError == 0) outputError = errno;
}

Result<void> finishOutput()
{
  flushOutput();
  if (outputError == 0 && std::ferror(stdout) == 0) return {};
  const int number = outputError != 0 ? outputError : EIO;
  return Error{"Standard output did not take all that was printed: " +
               std::generic_category().message(number) +
               ". Make room where it goes, or print somewhere else."};
}

void openStandardStreams()
{
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(number, F_GETFD) < 0) static_cast<void>(::open("/dev/null", O_RDWR));
}

std::string fixed(double value, int digits)
{
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits);
  return {text, end.ptr};
}

}  // namespace perilymph::cli
