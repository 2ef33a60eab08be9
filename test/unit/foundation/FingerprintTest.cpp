// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/Places.h"

namespace perilymph {
namespace {

struct Fingerprints {
  std::string own;
  std::string library;
};

/// Output of a process whose C library may only use the instructions allowed by `tunables`.
Fingerprints printedWith(const std::optional<std::string>& tunables)
{
  test::ProgramCall call;
  call.program = test::testProgram("unit_foundation_fingerprint");
  call.environment = {{"GLIBC_TUNABLES", tunables}};
  const test::ProgramOutcome outcome = test::run(call);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::size_t lineEnd = outcome.out.find('\n');
  return {outcome.out.substr(0, lineEnd), outcome.out.substr(lineEnd + 1)};
}

constexpr const char* olderProcessor = "glibc.cpu.hwcaps=-FMA,-AVX2";

TEST(Arithmetic, GivesTheSameBitsOnAProcessorWithoutFusedMultiplyAdd)
{
  const Fingerprints here = printedWith(std::nullopt);
  const Fingerprints older = printedWith(olderProcessor);
  EXPECT_FALSE(here.own.empty());
  EXPECT_EQ(here.own, older.own);
}

TEST(Arithmetic, IsComparedWithAProcessThatReallyComputesDifferently)
{
#ifdef __x86_64__
  const bool hasFma = __builtin_cpu_supports("fma") != 0;
#else
  const bool hasFma = false;  // none that a process could be told to leave out
#endif
  if (!hasFma) GTEST_SKIP() << "Both processes use the same instructions on this processor.";
  const Fingerprints here = printedWith(std::nullopt);
  const Fingerprints older = printedWith(olderProcessor);
  if (here.library == older.library)
    GTEST_SKIP() << "This C library gives the same bits with and without FMA.";
  EXPECT_NE(here.library, older.library);
}

}  // namespace
}  // namespace perilymph
