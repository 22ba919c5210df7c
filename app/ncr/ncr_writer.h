// All files of a non-conformance report.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/ncr/fill_form.h"
#include "app/ncr/ncr_register.h"

namespace spool::ncr {

// NUMBER.pdf, .html, .json and .bcfzip of a document that is given this number; for issue_ncr().
// kInternal where cairo or libzip fails. One thread.
[[nodiscard]] Result<std::vector<NcrFile>> ncr_files(NcrDocument document,
                                                     const std::string& number);

// Gives the document the next number of `prefix` and puts its files into the job, as issue_ncr()
// does, which says what fails and that nothing is used up then. One thread.
[[nodiscard]] Result<Issued> write_ncr(const NcrDocument& document,
                                       const std::filesystem::path& job_folder,
                                       const std::string& prefix,
                                       const std::filesystem::path& copy_to = {});

}  // namespace spool::ncr
