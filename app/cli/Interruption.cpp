#include "Interruption.h"

#include <csignal>
#include <initializer_list>

namespace perilymph::cli {

namespace {

volatile std::sig_atomic_t wasAsked = 0;

extern "C" void noteSignal(int) { wasAsked = 1; }

}  // namespace

void watchForInterruption()
{
  struct sigaction action = {};
  action.sa_handler = noteSignal;
  sigemptyset(&action.sa_mask);
  // A second signal ends the program as usual.
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

bool isInterrupted() { return wasAsked != 0; }

}  // namespace perilymph::cli
