// SPDX-License-Identifier: BSD-3-Clause

/* A plug-in to start from: a handle that exists only here. It is a mass that moves along z, in the
 * grip of a simulated hand, which leads it slowly into the cochlea and then rests; the force that
 * the program renders pushes it out of the place where the hand wants it. One read is one
 * millisecond of its life. */

#include "perilymph/device/PluginApi.h"

#include <stdio.h>

static const double step_s = 1e-3;
static const double mass_kg = 0.09;
/* The grip: a choice, soft enough that the handle is seen to move in the test of its force. */
static const double grip_N_m = 100.0;
static const double grip_N_s_m = 4.0;
/* The way of the hand, a choice: as fast as a slow insertion, and well within the reach of 0.1 m. */
static const double handSpeed_m_s = -2e-3;
static const double handEnd_m = -0.04;

typedef struct Handle {
  double hand_m; /* where the hand wants the handle along z; 0 is where it begins */
  double z_m;
  double speed_m_s;
  double force_N;
  uint64_t sequence;
  int isOpen;
} Handle;

/* There is one, and nothing to allocate. A real plug-in would look for its hardware here. */
static Handle theHandle;
static int isTaken;

static void* create(void)
{
  if (isTaken) return 0;
  isTaken = 1;
  theHandle = (Handle){0};
  return &theHandle;
}

static void destroy(void* device)
{
  (void)device;
  isTaken = 0;
}

static int32_t traits(void* device, PerilymphDeviceTraitsV1* out)
{
  (void)device;
  snprintf(out->name, sizeof out->name, "Example handle");
  out->renders_force = 1;
  out->max_force_N = 3.0;
  out->nominal_period_s = step_s;
  out->workspace_radius_m = 0.1;
  out->sensed_translations = 1;
  out->actuated_translations = 1;
  out->buttons = 1;
  /* It moves along z: without this, the first axis, x, would be meant. */
  if (out->size >= sizeof *out) out->actuated_axes = PERILYMPH_AXIS_Z;
  return 0;
}

static int32_t openHandle(void* device, char* sentence, uint32_t capacity)
{
  Handle* handle = device;
  if (handle->isOpen) {
    snprintf(sentence, capacity, "The example handle is open already. Close it first.");
    return 1;
  }
  *handle = (Handle){0};
  handle->isOpen = 1;
  return 0;
}

static void closeHandle(void* device)
{
  Handle* handle = device;
  handle->isOpen = 0;
  handle->force_N = 0.0;
}

static int32_t readHandle(void* device, PerilymphDeviceSampleV1* out)
{
  Handle* handle = device;
  const double handSpeed = handle->hand_m > handEnd_m ? handSpeed_m_s : 0.0;
  handle->hand_m += step_s * handSpeed;
  const double sum_N = grip_N_m * (handle->hand_m - handle->z_m) +
                       grip_N_s_m * (handSpeed - handle->speed_m_s) + handle->force_N;
  handle->speed_m_s += step_s * sum_N / mass_kg;
  handle->z_m += step_s * handle->speed_m_s;
  handle->sequence += 1;

  out->sequence = handle->sequence;
  out->position_D_m[2] = handle->z_m;
  out->buttons = 1; /* the simulated hand never lets go */
  out->is_valid = 1;
  return 0;
}

static int32_t writeHandle(void* device, const PerilymphDeviceWrenchV1* wrench)
{
  Handle* handle = device;
  handle->force_N = wrench->force_D_N[2];
  return 0;
}

const PerilymphDeviceV1* perilymph_device_v1(void);

const PerilymphDeviceV1* perilymph_device_v1(void)
{
  static const PerilymphDeviceV1 functions = {
      sizeof(PerilymphDeviceV1),
      1,
      create,
      destroy,
      traits,
      openHandle,
      closeHandle,
      readHandle,
      writeHandle,
  };
  return &functions;
}
