// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/foundation/Sha256.h"

#include <nettle/sha2.h>

namespace perilymph {

struct Sha256::Context {
  sha256_ctx state;
};

Sha256::Sha256() : context_(std::make_unique<Context>()) { sha256_init(&context_->state); }
Sha256::Sha256(const Sha256& other) : context_(std::make_unique<Context>(*other.context_)) {}
Sha256& Sha256::operator=(const Sha256& other)
{
  *context_ = *other.context_;
  return *this;
}
Sha256::~Sha256() = default;

void Sha256::add(std::span<const unsigned char> bytes)
{
  sha256_update(&context_->state, bytes.size(), bytes.data());
}

void Sha256::add(std::string_view text)
{
  add(std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size()));
}

void Sha256::add(std::uint64_t number)
{
  std::array<unsigned char, 8> bytes{};
  for (unsigned char& byte : bytes) {
    byte = static_cast<unsigned char>(number);
    number >>= 8;
  }
  add(bytes);
}

std::string Sha256::hex() const
{
  sha256_ctx copy = context_->state;
  std::array<unsigned char, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&copy, digest.size(), digest.data());
  constexpr const char* digits = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : digest) text += {digits[byte >> 4], digits[byte & 0xf]};
  return text;
}

}  // namespace perilymph
