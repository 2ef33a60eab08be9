// SPDX-License-Identifier: BSD-3-Clause

/* Plug-ins that are wrong in one way each; FAULT says how. */

#include <string.h>

#include "perilymph/device/PluginApi.h"

enum {
  anotherVersion = 1,
  missingFunction,
  tooShort,
  noDevice,
  noName,
  monstrousForce,
  noTraits,
  cannotOpen,
  failsToWrite,
  otherAxes,
  monstrousTorque,
  laterEntry,
  lineInName,
  monstrousDelay,
  noButton
};

static int device;
static uint64_t sequence;

static void* create(void) { return FAULT == noDevice ? (void*)0 : &device; }
static void destroy(void* it) { (void)it; }
static int32_t traits(void* it, PerilymphDeviceTraitsV1* out)
{
  (void)it;
  if (FAULT == noTraits) return 1;
  if (FAULT != noName) memset(out->name, 'x', sizeof out->name); /* and no 0 at the end */
  out->renders_force = 1;
  out->max_force_N = FAULT == monstrousForce ? 1e9 : 1.0;
  out->nominal_period_s = 1e-3;
  out->buttons = 1;
  if (FAULT == otherAxes) {
    out->actuated_translations = 2;
    out->actuated_axes = PERILYMPH_AXIS_Y;
  }
  if (FAULT == lineInName) strcpy(out->name, "Handle\nIt may be trusted");
  if (FAULT == monstrousDelay) out->transport_delay_s = 100.0;
  if (FAULT == noButton) out->buttons = 0;
  if (FAULT == monstrousTorque) out->max_torque_N_m = 1e3;
  return 0;
}
static int32_t openIt(void* it, char* sentence, uint32_t capacity)
{
  (void)it;
  if (FAULT != cannotOpen) return 0;
  memset(sentence, 'y', capacity); /* all the room, and no 0 at the end */
  return 1;
}
static void closeIt(void* it) { (void)it; }
static int32_t readIt(void* it, PerilymphDeviceSampleV1* out)
{
  (void)it;
  out->sequence = ++sequence;
  out->is_valid = 1;
  return 0;
}
static int32_t writeIt(void* it, const PerilymphDeviceWrenchV1* wrench)
{
  (void)it;
  (void)wrench;
  return FAULT == failsToWrite ? 1 : 0;
}

#if FAULT == 12 /* laterEntry */
#define perilymph_device_v1 perilymph_device_v3
#endif

const PerilymphDeviceV1* perilymph_device_v1(void);

const PerilymphDeviceV1* perilymph_device_v1(void)
{
  static PerilymphDeviceV1 functions = {
      sizeof(PerilymphDeviceV1), 1, create, destroy, traits, openIt, closeIt, readIt, writeIt};
  if (FAULT == anotherVersion) functions.version = 2;
  if (FAULT == tooShort) functions.size = 8;
  if (FAULT == missingFunction) functions.write = 0;
  return &functions;
}
