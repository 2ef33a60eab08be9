// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/* C interface for devices implemented outside the project: C functions and plain structs. A plug-in
 * is a shared library that exports perilymph_device_v1(). Neither exceptions nor ownership cross
 * this interface: a plug-in destroys what it creates and keeps no pointer that it receives.
 *
 * Lengths in meters, forces in newtons, times in seconds; frame D is right-handed: x right, y up,
 * z toward the user. Inserting is motion along -z.
 *
 * Every struct begins with its size. Later programs only append members: before you read or write a
 * member that is marked as appended, check that `size` reaches beyond it; a program that is older
 * than this header has a shorter struct. An appended member that a plug-in does not write is 0. */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Axes of D, as bits: translation along x, y, z, and rotation about them. */
enum {
  PERILYMPH_AXIS_X = 1,
  PERILYMPH_AXIS_Y = 2,
  PERILYMPH_AXIS_Z = 4,
  PERILYMPH_AXIS_TURN_X = 8,
  PERILYMPH_AXIS_TURN_Y = 16,
  PERILYMPH_AXIS_TURN_Z = 32
};

/* Capabilities of the device. 0 means unknown. */
typedef struct PerilymphDeviceTraitsV1 {
  uint32_t size; /* Set by the program. */
  uint32_t renders_force;
  char name[64]; /* Display name, UTF-8, zero-terminated. */
  double max_force_N;
  double nominal_period_s;
  double workspace_radius_m;
  double max_stiffness_N_m;
  double max_damping_N_s_m;
  double position_quantum_m;
  double force_quantum_N;
  double transport_delay_s;
  double watchdog_s;
  int32_t sensed_translations;
  int32_t sensed_rotations;
  int32_t actuated_translations;
  int32_t actuated_rotations;
  int32_t buttons; /* At least 1 of a device that renders force or torque. */
  int32_t reserved;
  /* Appended. */
  double max_torque_N_m;  /* 0: renders no torque. */
  uint32_t actuated_axes; /* Bits of the axes it pushes along and turns about, as many as the two
                             counts of actuated ones; 0: the first ones of each count. */
  uint32_t reserved_2;
} PerilymphDeviceTraitsV1;

/* One sample of the hand. */
typedef struct PerilymphDeviceSampleV1 {
  uint32_t size;     /* Set by the program. */
  uint32_t buttons;  /* Bit 0: the dead-man's button is held. */
  uint64_t sequence; /* Incremented with each fresh sample. */
  double position_D_m[3];
  double rotation_D[4]; /* Unit quaternion w, x, y, z. */
  uint32_t is_valid;    /* 0 after the device stopped responding. */
  uint32_t reserved;
} PerilymphDeviceSampleV1;

typedef struct PerilymphDeviceWrenchV1 {
  uint32_t size; /* Set by the program. */
  uint32_t reserved;
  double force_D_N[3];    /* At most max_force_N long. */
  double torque_D_N_m[3]; /* At most max_torque_N_m long; zero without it. */
} PerilymphDeviceWrenchV1;

/* The functions of a plug-in; all are required. `device` is the result of create(). 0 means success,
 * any other result failure.
 *
 * A plug-in runs in a process of its own, where one thread calls all functions. create, traits and
 * destroy are also called to list the plug-in, while another process may have the device open: they
 * must not open or move it. create, destroy, traits, open and close may take seconds. While the
 * device is open, read is called once per nominal_period_s and write after each time step of the
 * program: they must not block, lock, allocate or log. Values that are not finite are no sample.
 * write is called with zero before close, and when no force came for 50 ms or three periods.
 *
 * If read or write does not return within 50 ms, the process ends. After a read that hangs, write is
 * called once more, with zero, and then close, from another thread; after a crash outside write and
 * open, write with zero. A device should drop its force when its file is closed: the end of the
 * process closes it whatever happened. */
typedef struct PerilymphDeviceV1 {
  uint32_t size;    /* sizeof(PerilymphDeviceV1), set by the plug-in. */
  uint32_t version; /* 1 */
  /* The device, not yet opened; a null pointer if there is none. */
  void* (*create)(void);
  void (*destroy)(void* device);
  int32_t (*traits)(void* device, PerilymphDeviceTraitsV1* traits);
  /* On failure writes a zero-terminated message of at most `capacity` bytes into `sentence`. */
  int32_t (*open)(void* device, char* sentence, uint32_t capacity);
  void (*close)(void* device);
  /* The newest sample, whether fresh or not. */
  int32_t (*read)(void* device, PerilymphDeviceSampleV1* sample);
  /* Rendered until the next call. */
  int32_t (*write)(void* device, const PerilymphDeviceWrenchV1* wrench);
} PerilymphDeviceV1;

/* Exported by the plug-in under the name perilymph_device_v1. The result must stay valid while the
 * library is loaded. */
typedef const PerilymphDeviceV1* (*PerilymphDeviceEntryV1)(void);

#ifdef __cplusplus
}
#endif
