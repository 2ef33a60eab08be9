// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/AllocationLimit.h"

#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

constinit thread_local std::size_t maxBytesOfThread = unlimited;

}  // namespace

// Replaces the library's operator new in programs that use the limit; a sanitizer has its own in place
// of the library's, so that each kind that operator delete frees is replaced.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return size > maxBytesOfThread ? nullptr : std::malloc(size > 0 ? size : 1);
}

void* operator new(std::size_t size)
{
  void* const block = operator new(size, std::nothrow);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void operator delete(void* block) noexcept { std::free(block); }

void operator delete(void* block, std::size_t) noexcept { std::free(block); }

namespace perilymph::test {

AllocationLimit::AllocationLimit(std::size_t maxBytes) noexcept { maxBytesOfThread = maxBytes; }

AllocationLimit::~AllocationLimit() { maxBytesOfThread = unlimited; }

}  // namespace perilymph::test
