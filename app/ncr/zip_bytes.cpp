// Files packed into one ZIP in memory.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/zip_bytes.h"

#include <memory>

#include <zip.h>

namespace spool::ncr {
namespace {

struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, FreeSource>;

Error zip_error(const char* why) {
  return {ErrorCode::kInternal, std::string("libzip could not pack the report: ") + why};
}

Result<std::string> bytes_of(zip_source_t* source) {
  zip_stat_t state;
  if (zip_source_stat(source, &state) != 0 || zip_source_open(source) != 0)
    return zip_error(zip_error_strerror(zip_source_error(source)));
  std::string bytes(state.size, '\0');
  const zip_int64_t read = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (read < 0 || static_cast<std::size_t>(read) != bytes.size()) return zip_error("short read");
  return bytes;
}

}  // namespace

Result<std::string> zip_bytes(const std::vector<ZipEntry>& entries) {
  zip_error_t error;
  zip_error_init(&error);
  const Source buffer(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!buffer) return zip_error(zip_error_strerror(&error));
  zip_t* archive = zip_open_from_source(buffer.get(), ZIP_TRUNCATE, &error);
  if (archive == nullptr) return zip_error(zip_error_strerror(&error));
  zip_source_keep(buffer.get());  // the archive frees one, we the other
  for (const ZipEntry& each : entries) {
    constexpr zip_uint16_t kFirstDay = (1 << 5) | 1;  // 1980-01-01 as DOS counts
    zip_source_t* source =
        zip_source_buffer(archive, each.bytes.data(), each.bytes.size(), 0);  // borrowed
    const zip_int64_t index =
        source == nullptr ? -1 : zip_file_add(archive, each.path.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
      const std::string why = zip_error_strerror(zip_get_error(archive));
      zip_source_free(source);
      zip_discard(archive);
      return zip_error(why.c_str());
    }
    zip_file_set_dostime(archive, static_cast<zip_uint64_t>(index), 0, kFirstDay, 0);
  }
  if (zip_close(archive) != 0) {
    const std::string why = zip_error_strerror(zip_get_error(archive));
    zip_discard(archive);
    return zip_error(why.c_str());
  }
  return bytes_of(buffer.get());
}

}  // namespace spool::ncr
