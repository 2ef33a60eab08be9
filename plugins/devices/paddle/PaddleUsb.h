// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/* The paddle as a HID device of its own, by the Arduino core's PluggableUSB: one interface with an
 * interrupt endpoint to the host and one from it, so that a force needs no control transfer. For
 * boards with an ATmega32U4 (Leonardo, Micro). The core's own HID library has no endpoint from the
 * host. */

#include <Arduino.h>
#include <PluggableUSB.h>

#include "PaddleLogic.h"

namespace paddle {

class PaddleUsb : public PluggableUSBModule {
public:
  PaddleUsb() : PluggableUSBModule(2, 1, types_) { PluggableUSB().plug(this); }

  /* Sends a report if the host has taken the one before; else it is dropped: the loop must not wait. */
  bool send(const uint8_t* report)
  {
    uint8_t message[inputSize + 1];
    message[0] = inputNumber;
    memcpy(message + 1, report, inputSize);
    if (USB_SendSpace(pluggedEndpoint) < sizeof message) return false;
    return USB_Send(pluggedEndpoint | TRANSFER_RELEASE, message, sizeof message) > 0;
  }

  /* The newest report from the host; its size, 0 if there is none. */
  uint8_t receive(uint8_t* report)
  {
    uint8_t size = 0;
    while (USB_Available(pluggedEndpoint + 1) > 0) {
      const int count = USB_Recv(pluggedEndpoint + 1, report, outputSize + 1);
      size = count > 0 ? static_cast<uint8_t>(count) : 0;
    }
    return size;
  }

protected:
  int getInterface(uint8_t* interfaceCount) override
  {
    *interfaceCount += 1;
    /* HID 1.11, 6.2.1: the HID descriptor stands between interface and endpoints. */
    const struct {
      InterfaceDescriptor interface;
      uint8_t hid[9];
      EndpointDescriptor toHost, fromHost;
    } __attribute__((packed)) description = {
        D_INTERFACE(pluggedInterface, 2, 0x03, 0, 0),
        {9, 0x21, 0x11, 0x01, 0, 1, 0x22, sizeof reportDescriptor & 0xff,
         sizeof reportDescriptor >> 8},
        D_ENDPOINT(USB_ENDPOINT_IN(pluggedEndpoint), USB_ENDPOINT_TYPE_INTERRUPT, USB_EP_SIZE, 1),
        D_ENDPOINT(USB_ENDPOINT_OUT(pluggedEndpoint + 1), USB_ENDPOINT_TYPE_INTERRUPT, USB_EP_SIZE,
                   1)};
    return USB_SendControl(0, &description, sizeof description);
  }

  int getDescriptor(USBSetup& setup) override
  {
    constexpr uint8_t reportType = 0x22;
    if (setup.bmRequestType != REQUEST_DEVICETOHOST_STANDARD_INTERFACE ||
        setup.wValueH != reportType || setup.wIndex != pluggedInterface)
      return 0;
    return USB_SendControl(0, reportDescriptor, sizeof reportDescriptor);
  }

  bool setup(USBSetup& setup) override
  {
    if (setup.wIndex != pluggedInterface) return false;
    constexpr uint8_t setIdle = 0x0a, setProtocol = 0x0b;
    /* The host asks both of every HID device; neither changes anything here. */
    return setup.bmRequestType == REQUEST_HOSTTODEVICE_CLASS_INTERFACE &&
           (setup.bRequest == setIdle || setup.bRequest == setProtocol);
  }

  uint8_t getShortName(char* name) override
  {
    memcpy(name, "PADDLE", 6); /* part of the serial number */
    return 6;
  }

private:
  uint8_t types_[2] = {EP_TYPE_INTERRUPT_IN, EP_TYPE_INTERRUPT_OUT};
};

}  // namespace paddle
