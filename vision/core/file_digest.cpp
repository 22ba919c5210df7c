// SHA-256 by libsodium.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/core/file_digest.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <vector>

#include <sodium.h>

namespace spool {
namespace {

using Digest = std::array<unsigned char, crypto_hash_sha256_BYTES>;

std::string hexadecimal(const Digest& digest) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  text.reserve(2 * digest.size());
  for (const unsigned char byte : digest) {
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

}  // namespace

std::string sha256_hex(std::string_view bytes) {
  Digest digest{};
  crypto_hash_sha256(digest.data(), reinterpret_cast<const unsigned char*>(bytes.data()),
                     bytes.size());
  return hexadecimal(digest);
}

Result<std::string> sha256_file(const std::filesystem::path& path) {
  const auto failed = [&](int code) {
    return Error{code == ENOENT || code == ENOTDIR ? ErrorCode::kBadInput : ErrorCode::kIo,
                 path.string() + ": cannot be read (" + std::generic_category().message(code) +
                     "); check the path"};
  };
  const auto close = [](std::FILE* file) { std::fclose(file); };
  const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "rbe"), close);
  if (!file) return failed(errno);
  crypto_hash_sha256_state state;
  crypto_hash_sha256_init(&state);
  std::vector<unsigned char> part(std::size_t{1} << 20U);
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), file.get()))
    crypto_hash_sha256_update(&state, part.data(), n);
  if (std::ferror(file.get()) != 0) return failed(errno);
  Digest digest{};
  crypto_hash_sha256_final(&state, digest.data());
  return hexadecimal(digest);
}

}  // namespace spool
