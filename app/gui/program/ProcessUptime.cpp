// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/ProcessUptime.h"

#include <time.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <string>

namespace perilymph::gui {

double processUptime_s()
{
  // Field 22 of /proc/self/stat: start time in clock ticks since boot. Field 2, the program's name,
  // may contain spaces; the following fields come after its closing parenthesis.
  std::ifstream file("/proc/self/stat");
  std::string line;
  std::getline(file, line);
  const std::size_t nameEnd = line.rfind(')');
  if (nameEnd == std::string::npos) return 0.0;
  std::istringstream fields(line.substr(nameEnd + 1));
  std::string skipped;
  for (int field = 3; field < 22; ++field) fields >> skipped;
  double startTicks = 0.0;
  if (!(fields >> startTicks)) return 0.0;

  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  const double now_s = static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  return now_s - startTicks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace perilymph::gui
