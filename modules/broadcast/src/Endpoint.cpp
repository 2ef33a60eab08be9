// SPDX-License-Identifier: BSD-3-Clause
#include <arpa/inet.h>

#include <charconv>

#include "perilymph/broadcast/Broadcast.h"

namespace perilymph::broadcast {

namespace {

constexpr int minPort = 1024;  // below it, only the system's own services may listen

bool isNumeric(const std::string& address)
{
  in6_addr place{};
  return ::inet_pton(AF_INET, address.c_str(), &place) == 1 ||
         ::inet_pton(AF_INET6, address.c_str(), &place) == 1;
}

}  // namespace

Result<Endpoint> parseEndpoint(const std::string& text)
{
  Endpoint endpoint;
  const std::size_t colon = text.rfind(':');
  std::string port = text;
  if (colon != std::string::npos) {
    endpoint.address = text.substr(0, colon);
    port = text.substr(colon + 1);
    const bool isBracketed = endpoint.address.size() > 2 && endpoint.address.front() == '[' &&
                             endpoint.address.back() == ']';
    if (isBracketed) endpoint.address = endpoint.address.substr(1, endpoint.address.size() - 2);
  }
  int number = 0;
  const auto read = std::from_chars(port.data(), port.data() + port.size(), number);
  const bool isWhole = read.ec == std::errc() && read.ptr == port.data() + port.size();
  if (!isWhole || number < minPort || number > 65535)
    return Error{
        "The port '%1' in '%2' is none to listen at; it must be a number from 1024 to 65535, like "
        "18944.",
        port, text};
  if (!isNumeric(endpoint.address))
    return Error{
        "The address '%1' in '%2' is not numeric; use one of this machine, like 127.0.0.1 or "
        "[::1].",
        endpoint.address, text};
  endpoint.port = static_cast<std::uint16_t>(number);
  return endpoint;
}

}  // namespace perilymph::broadcast
