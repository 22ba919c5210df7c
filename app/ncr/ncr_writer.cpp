// All files of a non-conformance report.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/ncr_writer.h"

#include "app/ncr/ncr_bcf.h"
#include "app/ncr/ncr_html.h"
#include "app/ncr/ncr_json.h"
#include "app/ncr/ncr_pdf.h"

namespace spool::ncr {

Result<std::vector<NcrFile>> ncr_files(NcrDocument document, const std::string& number) {
  set_number(number, document);
  auto pdf = ncr_pdf(document);
  if (!pdf) return pdf.error();
  auto bcf = ncr_bcf(document);
  if (!bcf) return bcf.error();
  return std::vector<NcrFile>{{number + ".pdf", *std::move(pdf)},
                              {number + ".html", ncr_html(document)},
                              {number + ".json", ncr_json(document)},
                              {number + ".bcfzip", *std::move(bcf)}};
}

Result<Issued> write_ncr(const NcrDocument& document, const std::filesystem::path& job_folder,
                         const std::string& prefix, const std::filesystem::path& copy_to) {
  return issue_ncr(
      job_folder, prefix, [&](const std::string& number) { return ncr_files(document, number); },
      copy_to);
}

}  // namespace spool::ncr
