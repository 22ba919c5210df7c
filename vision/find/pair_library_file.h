// The model library on disk: read whole and checked, or refused; written whole.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "vision/core/cancel.h"
#include "vision/core/result.h"
#include "vision/find/pair_library.h"

namespace spool {

// Temporary file, sync, rename: a reader sees the old library or the new one. kIo as
// write_file_whole(). Little-endian, as all machines that we run on.
[[nodiscard]] Status write_pair_library(const std::filesystem::path& path,
                                        const PairLibrary& library);

// kBadInput, with a sentence that names the file: missing, no library, of another version, cut
// short, changed since it was written, or inconsistent in itself. kIo: reading failed.
[[nodiscard]] Result<PairLibrary> read_pair_library(const std::filesystem::path& path);

// The same of a file's bytes; `name` is what messages call it.
[[nodiscard]] Result<PairLibrary> read_pair_library_bytes(std::string_view bytes,
                                                          const std::string& name);

struct OpenedPairLibrary {
  PairLibrary library;      // the designs' models
  std::size_t reused = 0;   // models that were there
  std::size_t built = 0;    // models made now and saved
  std::string not_read;     // why the file was not used, one sentence; empty where it was
  std::string not_written;  // why it could not be saved, one sentence; empty where all is well
};

// A model for every design, in their order: those that the file at `path` holds are reused, the
// others are built and added to it. A file of other options, or that cannot be read, is made anew;
// one that cannot be written costs the next caller the time. Errors are build_pair_model()'s.
[[nodiscard]] Result<OpenedPairLibrary> open_pair_library(
    const std::filesystem::path& path, std::span<const DesignModel* const> designs,
    const PairLibraryOptions& options = {}, const Watch& watch = {});

}  // namespace spool
