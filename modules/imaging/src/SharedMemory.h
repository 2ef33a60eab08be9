// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/mman.h>

#include <cstddef>

namespace perilymph::imaging {

/// Memory that a process and its child see alike; zero at first.
class SharedMemory {
public:
  explicit SharedMemory(std::size_t bytes)
      : size_(bytes),
        start_(::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))
  {
  }
  ~SharedMemory()
  {
    if (isThere()) ::munmap(start_, size_);
  }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  bool isThere() const { return start_ != MAP_FAILED; }
  std::byte* start() const { return static_cast<std::byte*>(start_); }

private:
  std::size_t size_;
  void* start_;
};

}  // namespace perilymph::imaging
