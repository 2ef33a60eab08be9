// SPDX-License-Identifier: BSD-3-Clause

// main() of the tests of the command line with DICOM servers: they have a network of their own, so that nothing outside of
// this process and its children reaches a server of a test, and no port is taken.

#include <gmock/gmock.h>

#include "perilymph/test/DicomServers.h"
#include "perilymph/test/runTests.h"

int main(int argc, char** argv)
{
  perilymph::test::makeOwnNetwork();
  testing::InitGoogleMock(&argc, argv);
  return perilymph::test::runTests();
}
