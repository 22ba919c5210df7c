// Ed25519 signatures over entries, and the shop's key files.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "vision/core/result.h"

namespace spool::evidence {

// A shop's secret key. Wiped when it goes.
class SigningKey {
 public:
  explicit SigningKey(const std::array<unsigned char, 64>& secret) : secret_(secret) {}
  SigningKey(const SigningKey&) = default;
  SigningKey& operator=(const SigningKey&) = default;
  ~SigningKey();

  [[nodiscard]] std::string public_key() const;  // 64 hexadecimal digits
  // Detached signature (RFC 8032) of exactly these bytes, 128 hexadecimal digits.
  [[nodiscard]] std::string sign(std::string_view bytes) const;

 private:
  std::array<unsigned char, 64> secret_;  // seed and public key, as libsodium keeps them
};

// Makes `path` (mode 0600, never over a file that is there) and the public key beside it as
// path.pub. Gives the public key. kIo: there already, or not writable.
[[nodiscard]] Result<std::string> make_key(const std::filesystem::path& path);

// kBadInput: no key file of ours, a link, or one that others than its owner may read.
[[nodiscard]] Result<SigningKey> read_key(const std::filesystem::path& path);
// The public key of a path.pub, 64 hexadecimal digits; kBadInput for anything else.
[[nodiscard]] Result<std::string> read_public_key(const std::filesystem::path& path);

// False also where key or signature are no hexadecimal text of their length.
[[nodiscard]] bool is_signed(std::string_view bytes, const std::string& signature,
                             const std::string& public_key);

}  // namespace spool::evidence
