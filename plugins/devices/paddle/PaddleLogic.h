// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/* What a one-axis haptic paddle computes: position from its angle sensor, reports for the host, and
 * the motor's duty cycle from the newest force. No call of the Arduino core, so that a test compiles
 * it on a computer; paddle.ino connects it to pins and USB. C++11, as the AVR compiler takes it.
 *
 * The handle moves along z of frame D: z grows toward the user. */

#include <stdint.h>

namespace paddle {

/* ---- To be measured on the paddle that was built. ---- */

/* Steps of the sensor for one turn of the motor's shaft: those of the converter, if the sensor's
 * output passes over its whole range in a turn. */
constexpr int32_t stepsPerTurn = 1024;
/* Travel of the handle for one turn of the motor's shaft [0.1 um]: 2 pi r R / S for a pulley of
 * radius r, a handle at the distance R from the axle and a sector of radius S. Here r = 4.8 mm,
 * R = 70 mm and S = 72 mm: 29.3 mm. */
constexpr int32_t travelPerTurn = 293215;
/* 1, or -1 if the sensor's steps grow while the handle moves away from the user. */
constexpr int32_t sensorSign = 1;
/* Force at the handle with full duty cycle [0.1 mN], from a spring scale at the handle. */
constexpr int32_t forceAtFullDuty = 20000;
/* 1, or -1 if a positive duty cycle moves the handle away from the user. */
constexpr int32_t motorSign = 1;
/* The motor gets no more than this, so that it does not overheat while it stalls: of 255. */
constexpr int32_t greatestDuty = 200;

/* ---- The protocol; the same numbers are in paddle.toml. ---- */

constexpr uint8_t inputNumber = 1;  /* report to the host: once a millisecond */
constexpr uint8_t inputSize = 15;   /* without its number */
constexpr uint8_t outputNumber = 2; /* report from the host: the force */
constexpr uint8_t outputSize = 6;   /* without its number */
/* After this long without a force from the host the motor is switched off [ms]. */
constexpr uint16_t watchdog = 50;

/* HID 1.11: one collection of a vendor's usage with both reports as plain bytes. The usage page and
 * the usage are choices by which paddle.toml recognizes the paddle on any board. */
constexpr uint8_t reportDescriptor[] = {
    0x06, 0xa1,         0xff,                         /* usage page 0xffa1 */
    0x09, 0x50,                                       /* usage 0x50 */
    0xa1, 0x01,                                       /* collection: application */
    0x15, 0x00,                                       /*   logical minimum 0 */
    0x26, 0xff,         0x00,                         /*   logical maximum 255 */
    0x75, 0x08,                                       /*   8 bits */
    0x85, inputNumber,  0x95, inputSize,  0x09, 0x51, /*   usage 0x51 */
    0x81, 0x02,                                       /*   input: data, variable, absolute */
    0x85, outputNumber, 0x95, outputSize, 0x09, 0x52, /*   usage 0x52 */
    0x91, 0x02,                                       /*   output */
    0xc0};

/* State of the paddle. */
struct Paddle {
  int32_t steps = 0;     /* of the sensor since the start, over whole turns */
  int32_t lastAngle = 0; /* of the sensor, 0 to stepsPerTurn - 1 */
  bool hasAngle = false;
  uint16_t counter = 0;    /* of the reports */
  int16_t force = 0;       /* along z [0.1 mN] */
  uint16_t age = watchdog; /* of the force [ms] */
};

/* Takes the sensor's angle; the handle is at 0 where the first one was taken. Between two calls the
 * shaft turns by less than half a turn. */
inline void takeAngle(Paddle& paddle, int32_t angle)
{
  if (!paddle.hasAngle) {
    paddle.hasAngle = true;
    paddle.lastAngle = angle;
  }
  int32_t change = angle - paddle.lastAngle;
  if (change > stepsPerTurn / 2) change -= stepsPerTurn;
  if (change < -stepsPerTurn / 2) change += stepsPerTurn;
  paddle.steps += sensorSign * change;
  paddle.lastAngle = angle;
}

/* Position along z [0.1 um]. 64 bits: 7 turns of 1024 steps would overflow 32. */
inline int32_t position(const Paddle& paddle)
{
  return static_cast<int32_t>(static_cast<int64_t>(paddle.steps) * travelPerTurn / stepsPerTurn);
}

/* Writes the next report without its number: a counter, x, y and z, and the buttons. A paddle has
 * only z; a device with more axes fills in x and y. Lowest byte first. */
inline void fillReport(Paddle& paddle, bool isPressed, uint8_t* report)
{
  for (uint8_t i = 0; i < inputSize; ++i) report[i] = 0;
  ++paddle.counter;
  report[0] = static_cast<uint8_t>(paddle.counter & 0xff);
  report[1] = static_cast<uint8_t>(paddle.counter >> 8);
  const uint32_t z = static_cast<uint32_t>(position(paddle));
  for (uint8_t i = 0; i < 4; ++i) report[10 + i] = static_cast<uint8_t>(z >> (8 * i) & 0xff);
  report[14] = isPressed ? 1 : 0;
}

/* Takes a report from the host with its number first: forces along x, y and z. False if it is
 * another one. */
inline bool takeReport(Paddle& paddle, const uint8_t* report, uint8_t size)
{
  if (size != outputSize + 1 || report[0] != outputNumber) return false;
  paddle.force = static_cast<int16_t>(
      static_cast<uint16_t>(report[5] | static_cast<uint16_t>(report[6]) << 8));
  paddle.age = 0;
  return true;
}

/* One more millisecond has passed: an old force is dropped. */
inline void passMillisecond(Paddle& paddle)
{
  if (paddle.age < watchdog) ++paddle.age;
  if (paddle.age >= watchdog) paddle.force = 0;
}

/* Duty cycle of the motor, -255 to 255, positive toward the user. */
inline int16_t duty(const Paddle& paddle)
{
  int32_t value = static_cast<int32_t>(paddle.force) * 255 / forceAtFullDuty;
  if (value > greatestDuty) value = greatestDuty;
  if (value < -greatestDuty) value = -greatestDuty;
  return static_cast<int16_t>(motorSign * value);
}

}  // namespace paddle
