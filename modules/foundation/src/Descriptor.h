// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <string>
#include <system_error>
#include <utility>

namespace perilymph {

/// The system's message for an error number, such as "Permission denied".
inline std::string reason(int errorNumber) { return std::generic_category().message(errorNumber); }

/// An open file, closed by the destructor.
class Descriptor {
public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  explicit operator bool() const { return number_ >= 0; }
  int number() const { return number_; }

  /// Closes the file; false if the system reports that writing failed.
  bool close()
  {
    if (number_ < 0) return true;
    const bool closed = ::close(number_) == 0;
    number_ = -1;
    return closed;
  }

private:
  int number_;
};

}  // namespace perilymph
