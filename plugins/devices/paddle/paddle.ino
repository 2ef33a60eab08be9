// SPDX-License-Identifier: BSD-3-Clause

/* A one-axis haptic paddle with an Arduino Leonardo or Micro (ATmega32U4): angle sensor on A0, motor
 * driver on pins 8 and 9, button at the handle on pin 4. README.md has the parts and the wiring.
 * Not tried on hardware. */

#include <avr/wdt.h>

#include "PaddleLogic.h"
#include "PaddleUsb.h"

static const uint8_t sensorPin = A0;
static const uint8_t directionPin = 8;
static const uint8_t dutyPin = 9; /* timer 1 */
static const uint8_t buttonPin = 4;

static paddle::PaddleUsb usb;
static paddle::Paddle state;
static uint32_t nextTime;

static void drive(int16_t duty)
{
  digitalWrite(directionPin, duty < 0 ? HIGH : LOW);
  analogWrite(dutyPin, static_cast<uint8_t>(abs(duty)));
}

void setup()
{
  pinMode(directionPin, OUTPUT);
  pinMode(dutyPin, OUTPUT);
  drive(0);
  pinMode(buttonPin, INPUT_PULLUP);
  /* Pin 9 without audible hum: timer 1 without prescaler, 31 kHz (ATmega32U4, 14.10). */
  TCCR1B = (TCCR1B & 0xf8) | 0x01;
  nextTime = micros();
  wdt_enable(WDTO_60MS); /* a loop that hangs restarts the board, and the motor is off */
}

void loop()
{
  wdt_reset();
  uint8_t report[paddle::inputSize];
  const uint8_t size = usb.receive(report);
  if (size > 0) paddle::takeReport(state, report, size);
  drive(paddle::duty(state));

  if (static_cast<int32_t>(micros() - nextTime) < 0) return;
  nextTime += 1000;
  paddle::passMillisecond(state);
  /* Not connected, or asleep: no force, whatever the last report was. */
  if (!USBDevice.configured() || USBDevice.isSuspended()) state.force = 0;
  paddle::takeAngle(state, analogRead(sensorPin));
  paddle::fillReport(state, digitalRead(buttonPin) == LOW, report);
  usb.send(report);
}
