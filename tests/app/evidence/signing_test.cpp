// Keys and signatures: right, wrong, readable by others, and RFC 8032's own example.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/signing.h"

#include <sys/stat.h>

#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "vision/core/file_io.h"

namespace spool::test {
namespace {

namespace fs = std::filesystem;
using evidence::is_signed;

// RFC 8032, 7.1, test 2: one byte, 0x72.
constexpr char kSeed[] = "4ccd089b28ff96da9db6c346ec114e0f5b8a319f35aba624da8cf6ed4fb8a6fb";
constexpr char kPublic[] = "3d4017c3e843895a92b70aa74d1b7ebc9c982ccf2ec4968cc0cd55f12af4660c";
constexpr char kSignature[] =
    "92a009a9f0d4cab8720e820b5f642540a2b27b5416503f8fb3762223ebdb69da"
    "085ac1e43e15996e458f3613d0f11d8c387b2eaeb4302aeeb00d291612bb0c00";

TEST(Signing, IsThatOfTheStandard) {
  const TemporaryFolder folder;
  const auto path = write_file(folder.path() / "key", std::string("spoolsight-key/1\n") + kSeed);
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  const auto key = evidence::read_key(path);
  ASSERT_TRUE(key) << key.error().message;
  EXPECT_EQ(key->public_key(), kPublic);
  EXPECT_EQ(key->sign("\x72"), kSignature);
  EXPECT_TRUE(is_signed("\x72", kSignature, kPublic));
  EXPECT_FALSE(is_signed("\x73", kSignature, kPublic));
  EXPECT_FALSE(is_signed("\x72", std::string(128, '0'), kPublic));
  EXPECT_FALSE(is_signed("\x72", std::string(kSignature).substr(2), kPublic));
  EXPECT_FALSE(is_signed("\x72", kSignature, std::string(64, 'x')));
}

TEST(Signing, KeysAreTheirOwnersAlone) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "shop.key";
  const auto made = evidence::make_key(path);
  ASSERT_TRUE(made) << made.error().message;
  struct stat info {};
  ASSERT_EQ(::stat(path.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777U, 0600U);
  EXPECT_EQ(*evidence::read_public_key(path.string() + ".pub"), *made);
  EXPECT_EQ(evidence::read_key(path)->public_key(), *made);
  expect_refused(evidence::make_key(path), ErrorCode::kIo, "shop.key", "cannot be made");
  fs::permissions(path, fs::perms::group_read, fs::perm_options::add);
  expect_refused(evidence::read_key(path), ErrorCode::kBadInput, "shop.key", "chmod 600");
  fs::create_symlink(path, folder.path() / "link");
  expect_refused(evidence::read_key(folder.path() / "link"), ErrorCode::kBadInput, "link",
                 "no plain file");
  expect_refused(evidence::read_public_key(path), ErrorCode::kBadInput, "shop.key",
                 "no public key");
}

}  // namespace
}  // namespace spool::test
