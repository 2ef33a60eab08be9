// SPDX-License-Identifier: BSD-3-Clause

// Tests of the window's logic, with an event loop but without a display.

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <cstdlib>

#include "gui/run/Background.h"
#include "perilymph/test/runTests.h"

int main(int argc, char** argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  QCoreApplication application(argc, argv);
  const int status = perilymph::test::runTests();
  if (perilymph::gui::Background::isAnyThreadLeft()) std::_Exit(status);
  return status;
}
