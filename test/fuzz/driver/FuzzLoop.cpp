// SPDX-License-Identifier: BSD-3-Clause

// Drives a fuzz target without libFuzzer: inputs number 0, 1, 2, ... are mutations of the target's
// seeds. Each depends only on its number, so that it can be reproduced.
//
//     fuzz_<target> COUNT [FIRST [SECONDS]]
//
// Fails where an assertion fails, where an input takes more than SECONDS (60) of processor time,
// and where memory grows.

#include <malloc.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <iterator>
#include <random>
#include <string>

#include "FuzzTarget.h"

namespace {

using perilymph::fuzz::Bytes;

volatile std::sig_atomic_t currentHigh = 0;
volatile std::sig_atomic_t currentLow = 0;
constexpr unsigned long chunk = 1000000;

/// Prints the number of the input; safe in a signal handler.
extern "C" void tellInput(int signal)
{
  char text[] = "\nThe fuzzed input was number        000000. Run again: fuzz_<target> 1 NUMBER\n";
  char* digits = std::strchr(text, '0') + 5;
  unsigned long number =
      static_cast<unsigned long>(currentHigh) * chunk + static_cast<unsigned long>(currentLow);
  for (int i = 0; i < 13 && (number > 0 || i == 0); ++i, number /= 10)
    *digits-- = static_cast<char>('0' + number % 10);
  if (::write(STDERR_FILENO, text, sizeof text - 1) < 0) ::_exit(3);
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t limit) { return limit == 0 ? 0 : random() % limit; }

/// One small change.
void change(Bytes& bytes, const Bytes& other, Random& random)
{
  constexpr std::uint8_t interesting[] = {0x00, 0x01, 0x7f, 0x80, 0xff,
                                          0xc0, 0xa1, 0xa4, 0xb4, 0xfe};
  const std::size_t at = below(random, bytes.size());
  const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
  switch (bytes.empty() ? 2 : random() % 8) {
    case 0:
      bytes[at] ^= static_cast<std::uint8_t>(1u << (random() % 8));
      break;
    case 1:
      bytes[at] = static_cast<std::uint8_t>(random());
      break;
    case 2:
      bytes.insert(place, 1 + below(random, 6), static_cast<std::uint8_t>(random()));
      break;
    case 3:
      bytes.erase(place,
                  place + static_cast<std::ptrdiff_t>(
                              1 + below(random, std::min<std::size_t>(8, bytes.size() - at))));
      break;
    case 4:
      bytes[at] = interesting[random() % std::size(interesting)];
      break;
    case 5: {  // repeat a piece
      const std::size_t length = std::min<std::size_t>(1 + below(random, 32), bytes.size() - at);
      const Bytes piece(place, place + static_cast<std::ptrdiff_t>(length));
      bytes.insert(place, piece.begin(), piece.end());
      break;
    }
    case 6: {  // insert a piece of another seed
      const std::size_t from = below(random, other.size());
      const std::size_t length = std::min<std::size_t>(1 + below(random, 32), other.size() - from);
      const auto begin = other.begin() + static_cast<std::ptrdiff_t>(from);
      bytes.insert(place, begin, begin + static_cast<std::ptrdiff_t>(length));
      break;
    }
    default:
      if (random() % 4 == 0) bytes.resize(at);
      break;
  }
}

Bytes makeInput(unsigned long number, const std::vector<Bytes>& seeds)
{
  Random random(0x9e3779b97f4a7c15ull * (number + 1));
  if (random() % 32 == 0) {  // only random bytes
    Bytes noise(below(random, 300));
    for (auto& byte : noise) byte = static_cast<std::uint8_t>(random());
    return noise;
  }
  Bytes bytes = seeds[below(random, seeds.size())];
  const Bytes& other = seeds[below(random, seeds.size())];
  // Mostly few changes: nearly valid inputs reach the most code.
  const std::size_t changes = 1 + below(random, random() % 4 == 0 ? 24 : 4);
  for (std::size_t i = 0; i < changes; ++i) change(bytes, other, random);
  return bytes;
}

/// Sends SIGPROF after this processor time in seconds; 0 disables it.
void limitProcessorTime(long seconds)
{
  const itimerval timer = {{0, 0}, {seconds, 0}};
  ::setitimer(ITIMER_PROF, &timer, nullptr);
}

std::size_t memoryInUse() { return ::mallinfo2().uordblks; }

}  // namespace

int main(int count, char** label)
{
  if (count < 2 || count > 4) {
    std::fprintf(stderr, "Usage: fuzz_<target> COUNT [FIRST [SECONDS]]\n");
    return 2;
  }
  const unsigned long inputs = std::stoul(label[1]);
  const unsigned long first = count > 2 ? std::stoul(label[2]) : 0;
  const long seconds = count > 3 ? std::stol(label[3]) : 60;
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS, SIGPROF})
    ::signal(signal, tellInput);

  const std::vector<Bytes> seeds = perilymph::fuzz::seeds();
  for (const Bytes& seed : seeds) LLVMFuzzerTestOneInput(seed.data(), seed.size());

  std::size_t before = 0;
  const unsigned long warmUp = inputs / 10;
  for (unsigned long i = 0; i < inputs; ++i) {
    currentHigh = static_cast<std::sig_atomic_t>((first + i) / chunk);
    currentLow = static_cast<std::sig_atomic_t>((first + i) % chunk);
    if (i == warmUp) before = memoryInUse();
    limitProcessorTime(seconds);
    const Bytes input = makeInput(first + i, seeds);
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  limitProcessorTime(0);
  // A leak of one byte per input would show; caches of the library do not count.
  const std::size_t after = memoryInUse();
  const std::size_t grown = after > before ? after - before : 0;
  std::printf("%lu inputs from number %lu on, %zu seeds, memory grown by %zu bytes\n", inputs,
              first, seeds.size(), grown);
  if (grown > 65536 && grown > inputs) {
    std::fprintf(stderr, "Memory grows with the inputs.\n");
    return 1;
  }
  return 0;
}
