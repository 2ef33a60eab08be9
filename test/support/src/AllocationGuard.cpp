// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/AllocationGuard.h"

#include <cerrno>
#include <cstddef>
#include <cstdlib>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PERILYMPH_HEAP_IS_WATCHED 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
#define PERILYMPH_HEAP_IS_WATCHED 0
#endif
#endif
#ifndef PERILYMPH_HEAP_IS_WATCHED
#define PERILYMPH_HEAP_IS_WATCHED 1
#endif

namespace {

// Plain thread-local numbers: access never allocates, not even in a thread's first call.
constinit thread_local std::uint64_t allocationsOfThread = 0;
constinit thread_local std::uint64_t freesOfThread = 0;

}  // namespace

#if PERILYMPH_HEAP_IS_WATCHED

extern "C" {
// The C library's own heap functions, for replacements of malloc.
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming)
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

void* malloc(std::size_t size) noexcept
{
  ++allocationsOfThread;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept
{
  ++allocationsOfThread;
  return __libc_calloc(count, size);
}

void* realloc(void* block, std::size_t size) noexcept
{
  ++allocationsOfThread;
  return __libc_realloc(block, size);
}

void* reallocarray(void* block, std::size_t count, std::size_t size) noexcept
{
  ++allocationsOfThread;
  std::size_t total = 0;
  if (__builtin_mul_overflow(count, size, &total)) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_realloc(block, total);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept
{
  ++allocationsOfThread;
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept
{
  ++allocationsOfThread;
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept
{
  ++allocationsOfThread;
  const bool isPowerOfTwo = alignment != 0 && (alignment & (alignment - 1)) == 0;
  if (!isPowerOfTwo || alignment % sizeof(void*) != 0) return EINVAL;
  void* const found = __libc_memalign(alignment, size);
  if (found == nullptr) return ENOMEM;
  *block = found;
  return 0;
}

void free(void* block) noexcept
{
  if (block != nullptr) ++freesOfThread;
  __libc_free(block);
}
}

#endif

namespace perilymph::test {

bool AllocationGuard::isAvailable() noexcept { return PERILYMPH_HEAP_IS_WATCHED != 0; }

const char* AllocationGuard::whyNot() noexcept
{
  return isAvailable() ? "" : "A sanitizer brings its own heap; allocations cannot be counted.";
}

AllocationGuard::AllocationGuard() noexcept
    : allocationsBefore_(allocationsOfThread), freesBefore_(freesOfThread)
{
}

std::uint64_t AllocationGuard::allocations() const noexcept
{
  return allocationsOfThread - allocationsBefore_;
}

std::uint64_t AllocationGuard::frees() const noexcept { return freesOfThread - freesBefore_; }

}  // namespace perilymph::test
