// SPDX-License-Identifier: BSD-3-Clause

/* The other end of the line, to try MyDevice.c without hardware: a handle in the grip of a simulated
 * hand, as a program that behaves like the firmware of a device.
 *
 *     my-handle PORT    makes PORT, a link to a pseudo terminal, and plays in the background until
 *                       PORT is removed
 *
 * The lines are those of MyDevice.c. Each of the six axes is a mass, or an inertia, on a spring with
 * a damper: what a hand that holds still does. As a real device should, it drops a force that is
 * older than 50 ms. */

#define _GNU_SOURCE

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

enum { axes = 6 }; /* along x, y, z; about x, y, z */

static const double step_s = 1e-3;
static const int watchdog_steps = 50;
/* In kg, N/m and N.s/m; for the rotations in kg.m2, N.m and N.m.s. A choice, like a loose grip. */
static const double inertia[axes] = {0.09, 0.09, 0.09, 5e-5, 5e-5, 5e-5};
static const double stiffness[axes] = {100, 100, 100, 0.1, 0.1, 0.1};
static const double damping[axes] = {4, 4, 4, 4e-3, 4e-3, 4e-3};

typedef struct Handle {
  double place[axes], speed[axes], force[axes]; /* m, rad; N, N.m */
  int age;                                      /* of the force, in steps */
} Handle;

static void step(Handle* handle)
{
  if (++handle->age > watchdog_steps) memset(handle->force, 0, sizeof handle->force);
  for (int i = 0; i < axes; ++i) {
    const double sum =
        handle->force[i] - stiffness[i] * handle->place[i] - damping[i] * handle->speed[i];
    handle->speed[i] += step_s * sum / inertia[i];
    handle->place[i] += step_s * handle->speed[i];
  }
}

/* Takes the force of one line: millinewtons, then micronewton meters. */
static void takeLine(Handle* handle, const char* line)
{
  long value[axes];
  if (sscanf(line, "%ld %ld %ld %ld %ld %ld", &value[0], &value[1], &value[2], &value[3], &value[4],
             &value[5]) != axes)
    return;
  for (int i = 0; i < axes; ++i) handle->force[i] = (i < 3 ? 1e-3 : 1e-6) * (double)value[i];
  handle->age = 0;
}

/* Sends micrometers, microradians and the button, which the simulated hand never lets go. A line
 * that nobody reads is dropped. */
static void sendLine(const Handle* handle, int file)
{
  long value[axes];
  for (int i = 0; i < axes; ++i) value[i] = lround(1e6 * handle->place[i]);
  char line[128];
  const int size = snprintf(line, sizeof line, "%ld %ld %ld %ld %ld %ld 1\n", value[0], value[1],
                            value[2], value[3], value[4], value[5]);
  if (write(file, line, (size_t)size) < 0 && errno != EAGAIN) _exit(1);
}

/* Whether the link still leads to this line. */
static int isWanted(const char* port, const char* line)
{
  char place[128];
  const ssize_t size = readlink(port, place, sizeof place - 1);
  if (size < 0) return 0;
  place[size] = 0;
  return strcmp(place, line) == 0;
}

static void play(int file, const char* port, const char* name)
{
  Handle handle = {0};
  char line[128];
  size_t size = 0;
  struct timespec next;
  clock_gettime(CLOCK_MONOTONIC, &next);
  for (unsigned steps = 0; steps % 100 != 0 || isWanted(port, name); ++steps) {
    char bytes[512];
    const ssize_t count = read(file, bytes, sizeof bytes);
    for (ssize_t i = 0; i < count; ++i) {
      if (bytes[i] == '\n') {
        line[size] = 0;
        takeLine(&handle, line);
        size = 0;
      } else if (size + 1 < sizeof line) {
        line[size++] = bytes[i];
      }
    }
    step(&handle);
    sendLine(&handle, file);
    next.tv_nsec += (long)(1e9 * step_s);
    if (next.tv_nsec >= 1000000000L) {
      next.tv_nsec -= 1000000000L;
      ++next.tv_sec;
    }
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, 0);
  }
}

int main(int count, char** text)
{
  if (count != 2) {
    fprintf(stderr, "my-handle needs the name of the port to make, such as ./port.\n");
    return 2;
  }
  const int file = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
  if (file < 0 || grantpt(file) != 0 || unlockpt(file) != 0) {
    perror("my-handle gets no pseudo terminal");
    return 1;
  }
  /* Kept open, so that the line stays while nobody else has it open. */
  char name[128];
  snprintf(name, sizeof name, "%s", ptsname(file));
  const int line = open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
  struct termios settings;
  if (line < 0 || tcgetattr(line, &settings) != 0) {
    perror("my-handle cannot open its line");
    return 1;
  }
  cfmakeraw(&settings);
  tcsetattr(line, TCSANOW, &settings);
  unlink(text[1]); /* of an earlier handle */
  if (symlink(name, text[1]) != 0) {
    perror(text[1]);
    return 1;
  }
  /* The folder is kept, so that a relative name of the port stays valid. */
  if (daemon(1, 0) != 0) {
    perror("my-handle cannot go to the background");
    return 1;
  }
  /* As punctual as a device, where the system lets it; else its lines come late while the computer is
   * busy, and the program takes the force away. */
  const struct sched_param priority = {.sched_priority = 1};
  sched_setscheduler(0, SCHED_FIFO, &priority);
  play(file, text[1], name);
  return 0;
}
