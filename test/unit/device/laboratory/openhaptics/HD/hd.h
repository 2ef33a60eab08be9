// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A substitute of the header of OpenHaptics for tests, written from the published API reference: what
// the plug-in calls, and no more. Values of the constants are arbitrary, those of the maker differ.

using HHD = unsigned int;
using HDenum = unsigned int;
using HDint = int;
using HDdouble = double;
using HDushort = unsigned short;
using HDerror = unsigned int;
using HDstring = const char*;
using HDCallbackCode = unsigned int;
using HDSchedulerHandle = unsigned long;
struct HDErrorInfo {
  HDerror errorCode;
  int internalErrorCode;
  HHD hHD;
};

#define HDCALLBACK
#define HD_DEFAULT_DEVICE nullptr
#define HD_INVALID_HANDLE 0xfffu
#define HD_SUCCESS 0u
#define HD_DEVICE_ERROR(error) ((error).errorCode != HD_SUCCESS)
#define HD_CALLBACK_DONE 11u
#define HD_CALLBACK_CONTINUE 12u
#define HD_CURRENT_POSITION 21u
#define HD_CURRENT_TRANSFORM 22u
#define HD_CURRENT_BUTTONS 23u
#define HD_CURRENT_FORCE 24u
#define HD_NOMINAL_MAX_FORCE 25u
#define HD_FORCE_OUTPUT 31u
#define HD_CALIBRATION_OK 41u
#define HD_CALIBRATION_NEEDS_MANUAL_INPUT 42u
#define HD_DEVICE_BUTTON_1 1
#define HD_DEVICE_BUTTON_2 2
#define HD_MAX_SCHEDULER_PRIORITY 51

using HDSchedulerCallback = HDCallbackCode(HDCALLBACK*)(void*);

extern "C" {
HHD hdInitDevice(HDstring name);
void hdDisableDevice(HHD device);
void hdMakeCurrentDevice(HHD device);
void hdBeginFrame(HHD device);
void hdEndFrame(HHD device);
void hdEnable(HDenum capability);
void hdDisable(HDenum capability);
void hdGetDoublev(HDenum name, HDdouble* values);
void hdGetIntegerv(HDenum name, HDint* values);
void hdSetDoublev(HDenum name, const HDdouble* values);
HDErrorInfo hdGetError();
HDstring hdGetErrorString(HDerror error);
HDenum hdCheckCalibration();
void hdStartScheduler();
void hdStopScheduler();
HDSchedulerHandle hdScheduleAsynchronous(HDSchedulerCallback callback, void* data,
                                         HDushort priority);
void hdUnschedule(HDSchedulerHandle handle);
}
