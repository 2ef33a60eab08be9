// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A substitute of the header of Force Dimension's SDK for tests, written from its published
// documentation: what the plug-in calls, and no more. The maker's has defaults for the last arguments.

#define DHD_ON 1
#define DHD_OFF 0
#define DHD_TIMEGUARD 1
#define DHD_MOTOR_SATURATED 2

extern "C" {
int dhdOpen();
int dhdClose(char device);
int dhdEnableForce(unsigned char isOn, char device);
int dhdSetGravityCompensation(int isOn, char device);
int dhdGetPosition(double* x, double* y, double* z, char device);
int dhdSetForce(double x, double y, double z, char device);
int dhdGetButton(int index, char device);
const char* dhdErrorGetLastStr();
}
