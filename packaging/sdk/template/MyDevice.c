// SPDX-License-Identifier: BSD-3-Clause

/* A device plug-in to start from: a handle at a serial line, such as a microcontroller at USB. It
 * works as it is with a device that speaks lines of text, in frame D (x right, y up, z toward the
 * user):
 *
 *     from the device, once a millisecond:  x y z rx ry rz buttons
 *         position in micrometers; rotation vector, its length the angle, in microradians; bit 0 of
 *         the buttons: the hand grasps
 *     to the device, as often:              fx fy fz tx ty tz
 *         force in millinewtons, torque in micronewton meters
 *
 * Replace what your device does differently, function by function: its name and traits, how it is
 * found, its lines. The port is the environment variable MY_DEVICE_PORT, or /dev/ttyACM0. MyHandle.c
 * plays such a device. */

#include "perilymph/device/PluginApi.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

typedef struct Device {
  int file; /* the serial line, never blocking */
  char line[128];
  size_t lineSize;
  PerilymphDeviceSampleV1 newest;
  int isLost;
} Device;

static void* create(void)
{
  Device* device = calloc(1, sizeof *device);
  if (device != 0) device->file = -1;
  return device;
}

static void destroy(void* it) { free(it); }

static int32_t traits(void* it, PerilymphDeviceTraitsV1* out)
{
  (void)it;
  snprintf(out->name, sizeof out->name, "My device");
  out->renders_force = 1;
  out->max_force_N = 1.0;         /* what the motors hold for ever; the program sends no more */
  out->nominal_period_s = 1e-3;   /* read() is called this often */
  out->workspace_radius_m = 0.05; /* around the origin of D; the force fades out before its end */
  out->sensed_translations = 3;
  out->sensed_rotations = 3;
  out->actuated_translations = 3;
  out->buttons = 1;
  out->transport_delay_s = 1e-3; /* from a force to the sample that shows its effect, both ways */
  out->watchdog_s = 0.05;        /* the device itself drops a force that is this old */
  /* A program that is older than this header has a shorter struct, and renders no torque. A device
   * without torque leaves these lines out; one with fewer axes states which in actuated_axes. */
  if (out->size >= sizeof *out) {
    out->actuated_rotations = 3;
    out->max_torque_N_m = 0.05;
  }
  return 0;
}

static int32_t openDevice(void* it, char* sentence, uint32_t capacity)
{
  Device* device = it;
  const char* port = getenv("MY_DEVICE_PORT");
  if (port == 0) port = "/dev/ttyACM0";
  device->file = open(port, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  struct termios settings;
  if (device->file < 0 || tcgetattr(device->file, &settings) != 0) {
    snprintf(sentence, capacity, "My device at %s cannot be opened: %s. Check its cable.", port,
             strerror(errno));
    if (device->file >= 0) close(device->file);
    device->file = -1;
    return 1;
  }
  cfmakeraw(&settings);
  tcsetattr(device->file, TCSANOW, &settings);
  tcflush(device->file, TCIOFLUSH);
  device->lineSize = 0;
  device->isLost = 0;
  memset(&device->newest, 0, sizeof device->newest);
  device->newest.rotation_D[0] = 1.0;
  return 0;
}

static void closeDevice(void* it)
{
  Device* device = it;
  if (device->file < 0) return;
  tcdrain(device->file); /* the last force, zero, leaves before the line closes */
  close(device->file);
  device->file = -1;
}

/* Takes one line; a line that is not understood is no sample. */
static void takeLine(Device* device)
{
  double place_um[3], turn_urad[3];
  unsigned buttons = 0;
  const int count = sscanf(device->line, "%lf %lf %lf %lf %lf %lf %u", &place_um[0], &place_um[1],
                           &place_um[2], &turn_urad[0], &turn_urad[1], &turn_urad[2], &buttons);
  if (count != 7) return;
  /* The unit quaternion of a rotation vector v: cos(|v| / 2), sin(|v| / 2) v / |v|. */
  const double angle = 1e-6 * sqrt(turn_urad[0] * turn_urad[0] + turn_urad[1] * turn_urad[1] +
                                   turn_urad[2] * turn_urad[2]);
  const double factor = angle > 0 ? 1e-6 * sin(0.5 * angle) / angle : 0;
  device->newest.rotation_D[0] = cos(0.5 * angle);
  for (int i = 0; i < 3; ++i) {
    device->newest.position_D_m[i] = 1e-6 * place_um[i];
    device->newest.rotation_D[i + 1] = factor * turn_urad[i];
  }
  device->newest.buttons = buttons;
  device->newest.sequence += 1;
}

static int32_t readDevice(void* it, PerilymphDeviceSampleV1* out)
{
  Device* device = it;
  char bytes[512];
  ssize_t count = read(device->file, bytes, sizeof bytes);
  /* 0 or another error than "nothing there yet": the line was pulled out */
  if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR)) device->isLost = 1;
  for (ssize_t i = 0; i < count; ++i) {
    if (bytes[i] == '\n') {
      device->line[device->lineSize] = 0;
      takeLine(device);
      device->lineSize = 0;
    } else if (device->lineSize + 1 < sizeof device->line) {
      device->line[device->lineSize++] = bytes[i];
    }
  }
  const uint32_t size = out->size;
  *out = device->newest;
  out->size = size;
  out->is_valid = device->isLost == 0 && device->newest.sequence > 0;
  return 0;
}

static int32_t writeDevice(void* it, const PerilymphDeviceWrenchV1* wrench)
{
  Device* device = it;
  long force_mN[3], torque_uN_m[3];
  for (int i = 0; i < 3; ++i) {
    force_mN[i] = lround(1e3 * wrench->force_D_N[i]);
    torque_uN_m[i] = lround(1e6 * wrench->torque_D_N_m[i]);
  }
  char line[160];
  const int size =
      snprintf(line, sizeof line, "%ld %ld %ld %ld %ld %ld\n", force_mN[0], force_mN[1],
               force_mN[2], torque_uN_m[0], torque_uN_m[1], torque_uN_m[2]);
  /* Also a force that did not change: the device drops one that is old. A line that does not fit
   * is refused, and the program treats the device as not responding. */
  return write(device->file, line, (size_t)size) == size ? 0 : 1;
}

const PerilymphDeviceV1* perilymph_device_v1(void);

const PerilymphDeviceV1* perilymph_device_v1(void)
{
  static const PerilymphDeviceV1 functions = {sizeof(PerilymphDeviceV1),
                                              1,
                                              create,
                                              destroy,
                                              traits,
                                              openDevice,
                                              closeDevice,
                                              readDevice,
                                              writeDevice};
  return &functions;
}
