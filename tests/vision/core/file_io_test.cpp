// Tests of whole reads and whole writes, on a full disk too.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/core/file_io.h"

#include <csignal>
#include <filesystem>

#include <sys/resource.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "vision/core/file_digest.h"

namespace spool {
namespace {

namespace fs = std::filesystem;

// While it lives no file of this process may grow beyond `bytes`: a write fails as on a full disk.
class SizeLimit {
 public:
  explicit SizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  SizeLimit(const SizeLimit&) = delete;
  SizeLimit& operator=(const SizeLimit&) = delete;
  ~SizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(FileIo, ReadsBackEveryByteThatItWrote) {
  const test::TemporaryFolder folder;
  std::string bytes;
  for (int i = 0; i < 100000; ++i) bytes += static_cast<char>(i * 7);
  for (const std::string& text : {std::string(), std::string("a\r\n\0b", 5), bytes}) {
    ASSERT_TRUE(write_file_whole(folder.path() / "file", text));
    const auto back = read_file(folder.path() / "file");
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, text);
  }
  EXPECT_EQ(files_in(folder.path()), 1U) << "a temporary file was left";
}

TEST(FileIo, LeavesTheOldFileWholeWhenTheDiskIsFull) {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "report.json";
  ASSERT_TRUE(write_file_whole(path, "the old report"));
  Status written;
  {
    const SizeLimit limit(4096);
    written = write_file_whole(path, std::string(100000, 'x'));
  }
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kIo);
  EXPECT_NE(written.error().message.find(path.string()), std::string::npos);
  EXPECT_NE(written.error().message.find("free space"), std::string::npos);
  EXPECT_EQ(*read_file(path), "the old report");
  EXPECT_EQ(files_in(folder.path()), 1U) << "half a file was left";
}

TEST(FileIo, RefusesWithTheFileAndTheReason) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_file_whole(folder.path() / "file", "12345"));
  struct Row {
    const char* name;
    fs::path path;
    ErrorCode code;
    const char* text;
  };
  for (const Row& row :
       {Row{"missing", folder.path() / "none", ErrorCode::kBadInput, "No such file"},
        Row{"a folder", folder.path(), ErrorCode::kBadInput, "is not a file"},
        Row{"below a file", folder.path() / "file" / "x", ErrorCode::kBadInput, "Not a directory"},
        Row{"a device", "/dev/zero", ErrorCode::kBadInput, "is not a file"}}) {
    const auto read = read_file(row.path);
    ASSERT_FALSE(read) << row.name;
    EXPECT_EQ(read.error().code, row.code) << row.name;
    EXPECT_TRUE(read.error().message.starts_with(row.path.string())) << read.error().message;
    EXPECT_NE(read.error().message.find(row.text), std::string::npos) << read.error().message;
  }
  const auto large = read_file(folder.path() / "file", 4);
  ASSERT_FALSE(large);
  EXPECT_NE(large.error().message.find("is 5 bytes, more than the 4"), std::string::npos);
  EXPECT_TRUE(read_file(folder.path() / "file", 5));
}

TEST(FileIo, CannotWriteWhereThereIsNoFolderOrAFolderStands) {
  const test::TemporaryFolder folder;
  for (const fs::path& path : {folder.path() / "none" / "file", folder.path()}) {
    const Status written = write_file_whole(path, "x");
    ASSERT_FALSE(written) << path;
    EXPECT_EQ(written.error().code, ErrorCode::kIo);
  }
  EXPECT_EQ(files_in(folder.path()), 0U);
  EXPECT_FALSE(fs::exists(folder.path().string() + ".part-" + std::to_string(::getpid())));
}

TEST(FileIo, MakesFoldersAndTheOnesAbove) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(make_folder(folder.path() / "a" / "b"));
  EXPECT_TRUE(make_folder(folder.path() / "a" / "b"));  // again
  EXPECT_TRUE(fs::is_directory(folder.path() / "a" / "b"));
  ASSERT_TRUE(write_file_whole(folder.path() / "file", ""));
  const Status made = make_folder(folder.path() / "file");
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::kIo);
}

TEST(FileDigest, GivesThePublishedVectorsOfSha256) {
  // FIPS 180-4's examples and the empty text.
  EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_hex(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace
}  // namespace spool
