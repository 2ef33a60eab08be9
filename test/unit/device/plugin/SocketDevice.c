// SPDX-License-Identifier: BSD-3-Clause

/* A plug-in whose device is at the other end of a socket: each wrench is a message of two numbers,
 * force and torque z,
 * and as with a real device, the connection ends with the process. From the first force on it has
 * the fault that PERILYMPH_TEST_FAULT names. */

#include <math.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "perilymph/device/PluginApi.h"

static int connection = -1;
static int hasPushed;
static uint64_t sequence;

static int hasFault(const char* name)
{
  const char* fault = getenv("PERILYMPH_TEST_FAULT");
  return fault != 0 && strcmp(fault, name) == 0;
}

static void fail(const char* where)
{
  char name[32];
  snprintf(name, sizeof name, "hang in %s", where);
  if (hasFault(name))
    for (;;) pause();
  snprintf(name, sizeof name, "spin in %s", where);
  if (hasFault(name))
    for (volatile int i = 0;; i = !i) {
    }
  snprintf(name, sizeof name, "block in %s", where);
  char byte;
  if (hasFault(name))
    for (;;) recv(connection, &byte, 1, 0); /* the device never answers */
  snprintf(name, sizeof name, "crash in %s", where);
  if (hasFault(name))
    raise(SIGSEGV); /* a bad address would end under a sanitizer of its own accord */
  snprintf(name, sizeof name, "abort in %s", where);
  if (hasFault(name)) abort();
  snprintf(name, sizeof name, "exit in %s", where);
  if (hasFault(name)) exit(7);
}

static void* create(void)
{
  fail("create");
  if (hasFault("leaves a child") && fork() == 0)
    for (;;) pause();
  return &connection;
}
static void destroy(void* it) { (void)it; }

static int32_t traits(void* it, PerilymphDeviceTraitsV1* out)
{
  (void)it;
  snprintf(out->name, sizeof out->name, "Socket handle");
  out->renders_force = 1;
  out->max_force_N = 1.0;
  out->nominal_period_s = 1e-3;
  out->buttons = 1;
  out->sensed_translations = 3;
  out->actuated_translations = 3;
  out->actuated_rotations = 1;
  out->max_torque_N_m = 0.05;
  out->actuated_axes =
      PERILYMPH_AXIS_X | PERILYMPH_AXIS_Y | PERILYMPH_AXIS_Z | PERILYMPH_AXIS_TURN_Z;
  return 0;
}

static int32_t openIt(void* it, char* sentence, uint32_t capacity)
{
  (void)it;
  fail("open");
  const char* name = getenv("PERILYMPH_TEST_SOCKET");
  struct sockaddr_un place = {.sun_family = AF_UNIX};
  if (name != 0) strncpy(place.sun_path + 1, name, sizeof place.sun_path - 2);
  const socklen_t size =
      (socklen_t)(offsetof(struct sockaddr_un, sun_path) + 1 + strlen(place.sun_path + 1));
  connection = socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0);
  if (connect(connection, (const struct sockaddr*)&place, size) == 0) return 0;
  snprintf(sentence, capacity, "Nobody listens at the socket.");
  return 1;
}

static void closeIt(void* it)
{
  (void)it;
  close(connection);
  connection = -1;
}

static int32_t readIt(void* it, PerilymphDeviceSampleV1* out)
{
  (void)it;
  if (hasPushed) fail("read");
  out->sequence = ++sequence;
  if (hasFault("none but it moves")) out->position_D_m[2] = -4e-6 * (double)sequence; /* 4 mm/s */
  out->position_D_m[0] = hasPushed && hasFault("NaN from read") ? NAN : 0.0;
  out->buttons = 1;
  out->is_valid = 1;
  return 0;
}

static int32_t writeIt(void* it, const PerilymphDeviceWrenchV1* wrench)
{
  (void)it;
  const double force = wrench->force_D_N[2];
  const double message[2] = {force, wrench->torque_D_N_m[2]};
  send(connection, message, sizeof message, MSG_NOSIGNAL);
  if (force != 0.0) hasPushed = 1;
  if (hasPushed) fail("write");
  return 0;
}

const PerilymphDeviceV1* perilymph_device_v1(void);

const PerilymphDeviceV1* perilymph_device_v1(void)
{
  static const PerilymphDeviceV1 functions = {
      sizeof(PerilymphDeviceV1), 1, create, destroy, traits, openIt, closeIt, readIt, writeIt};
  return &functions;
}
