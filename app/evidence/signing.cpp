// Ed25519 signatures over entries, and the shop's key files; by libsodium.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/signing.h"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <sodium.h>
#include <sys/stat.h>
#include <unistd.h>

#include "vision/core/file_io.h"

namespace spool::evidence {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSecretHead = "spoolsight-key/1\n";
constexpr std::string_view kPublicHead = "spoolsight-public-key/1\n";
static_assert(crypto_sign_SECRETKEYBYTES == 64 && crypto_sign_PUBLICKEYBYTES == 32 &&
              crypto_sign_BYTES == 64 && crypto_sign_SEEDBYTES == 32);

// Random numbers, and the fastest code of this machine; may be called again.
bool is_ready() { return sodium_init() >= 0; }

template <std::size_t N>
std::string hexadecimal(const std::array<unsigned char, N>& bytes) {
  std::string text(2 * N + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), bytes.data(), N);
  text.pop_back();
  return text;
}

template <std::size_t N>
std::optional<std::array<unsigned char, N>> bytes_of(std::string_view hex) {
  std::array<unsigned char, N> bytes{};
  std::size_t count = 0;
  const char* end = nullptr;
  if (hex.size() != 2 * N ||
      sodium_hex2bin(bytes.data(), N, hex.data(), hex.size(), nullptr, &count, &end) != 0)
    return std::nullopt;
  if (count != N || end != hex.data() + hex.size()) return std::nullopt;
  return bytes;
}

// The line after the head of a key file.
template <std::size_t N>
std::optional<std::array<unsigned char, N>> body_of(std::string_view text, std::string_view head) {
  if (!text.starts_with(head)) return std::nullopt;
  text.remove_prefix(head.size());
  while (text.ends_with('\n')) text.remove_suffix(1);
  return bytes_of<N>(text);
}

Status write_new(const fs::path& path, const std::string& text, mode_t mode) {
  const auto failed = [&](int code) {
    return Error{ErrorCode::kIo, path.string() + ": cannot be made (" +
                                     std::generic_category().message(code) +
                                     "); choose another name"};
  };
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (descriptor < 0) return failed(errno);
  const bool is_written =
      ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
      ::fsync(descriptor) == 0;
  const int code = errno;
  ::close(descriptor);
  if (is_written) return {};
  ::unlink(path.c_str());
  return failed(code);
}

}  // namespace

SigningKey::~SigningKey() { sodium_memzero(secret_.data(), secret_.size()); }

std::string SigningKey::public_key() const {
  std::array<unsigned char, 32> key{};
  crypto_sign_ed25519_sk_to_pk(key.data(), secret_.data());
  return hexadecimal(key);
}

std::string SigningKey::sign(std::string_view bytes) const {
  std::array<unsigned char, 64> signature{};
  crypto_sign_detached(signature.data(), nullptr,
                       reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                       secret_.data());
  return hexadecimal(signature);
}

Result<std::string> make_key(const fs::path& path) {
  if (!is_ready()) return Error{ErrorCode::kInternal, "libsodium does not start"};
  std::array<unsigned char, 32> seed{};
  randombytes_buf(seed.data(), seed.size());
  std::array<unsigned char, 32> key{};
  std::array<unsigned char, 64> secret{};
  crypto_sign_seed_keypair(key.data(), secret.data(), seed.data());
  sodium_memzero(secret.data(), secret.size());
  std::string text = std::string(kSecretHead) + hexadecimal(seed) + "\n";
  sodium_memzero(seed.data(), seed.size());
  const Status written = write_new(path, text, 0600);
  sodium_memzero(text.data(), text.size());
  if (!written) return written.error();
  const std::string public_key = hexadecimal(key);
  if (Status done =
          write_new(path.string() + ".pub", std::string(kPublicHead) + public_key + "\n", 0644);
      !done) {
    ::unlink(path.c_str());
    return done.error();
  }
  return public_key;
}

Result<SigningKey> read_key(const fs::path& path) {
  const auto refuse = [&](const std::string& why) {
    return Error{ErrorCode::kBadInput, path.string() + ": " + why};
  };
  if (!is_ready()) return Error{ErrorCode::kInternal, "libsodium does not start"};
  struct stat info {};
  if (::lstat(path.c_str(), &info) != 0) return refuse("is not there; make one with keygen");
  if (!S_ISREG(info.st_mode)) return refuse("is no plain file; name the key file itself");
  if ((info.st_mode & 077U) != 0)
    return refuse("may be read by others than its owner; chmod 600 it, or make another key");
  constexpr std::uint64_t kMaxBytes = 4096;
  auto text = read_file(path, kMaxBytes);
  if (!text) return text.error();
  auto seed = body_of<32>(*text, kSecretHead);
  sodium_memzero(text->data(), text->size());
  if (!seed) return refuse("is no key of spoolsight-job keygen");
  std::array<unsigned char, 32> key{};
  std::array<unsigned char, 64> secret{};
  crypto_sign_seed_keypair(key.data(), secret.data(), seed->data());
  sodium_memzero(seed->data(), seed->size());
  SigningKey made(secret);
  sodium_memzero(secret.data(), secret.size());
  return made;
}

Result<std::string> read_public_key(const fs::path& path) {
  constexpr std::uint64_t kMaxBytes = 4096;
  const auto text = read_file(path, kMaxBytes);
  if (!text) return text.error();
  const auto key = body_of<32>(*text, kPublicHead);
  if (!key)
    return Error{ErrorCode::kBadInput,
                 path.string() + ": is no public key of spoolsight-job keygen (NAME.pub)"};
  return hexadecimal(*key);
}

bool is_signed(std::string_view bytes, const std::string& signature,
               const std::string& public_key) {
  const auto raw = bytes_of<64>(signature);
  const auto key = bytes_of<32>(public_key);
  return raw && key && is_ready() &&
         crypto_sign_verify_detached(raw->data(),
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     bytes.size(), key->data()) == 0;
}

}  // namespace spool::evidence
