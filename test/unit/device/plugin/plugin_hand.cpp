// SPDX-License-Identifier: BSD-3-Clause

// A program that renders a force with a plug-in until something ends it: plugin_hand LIBRARY

#include <cstdio>

#include "perilymph/device/PluginDevice.h"
#include "perilymph/foundation/Units.h"

int main(int count, char** text)
{
  using namespace perilymph;
  if (count != 2) return 2;
  const auto hand = device::loadPluginDevice(text[1]);
  if (!hand) return std::fprintf(stderr, "%s\n", hand.error().message.c_str()), 1;
  if (const auto opened = (*hand)->open(); !opened)
    return std::fprintf(stderr, "%s\n", opened.error().message.c_str()), 1;
  while (true) {
    (*hand)->await(milliseconds(5));
    (*hand)->read();
    (*hand)->write({{0.0, 0.0, 0.5}, {}});
  }
}
