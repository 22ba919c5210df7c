// spoolsight-inspect --verify: a line for whatever of a job is not as it was recorded.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/inspect_evidence.h"

#include <iostream>

#include <fmt/format.h>

#include "app/evidence/signing.h"
#include "app/evidence/verify.h"
#include "tools/plain_text.h"

namespace spool::tools {

void add_evidence_options(CLI::App& app, EvidenceOptions& options) {
  auto* verify = app.add_option("--verify", options.verify,
                                "Say what of a job was changed, removed, added or re-dated since "
                                "it was recorded; exit 0 intact, 1 altered")
                     ->type_name("JOB");
  app.add_option("--signer", options.signer,
                 "With --verify: every entry has to be signed with this key")
      ->needs(verify)
      ->type_name("NAME.pub");
  app.add_option("--replay", options.replay,
                 "Make a captured report again from its stored frames into --out, and say what "
                 "differs; exit 0 the same, 1 not")
      ->excludes(verify)
      ->type_name("JOB[/evidence/N]");
}

Result<int> verify(const EvidenceOptions& options) {
  evidence::VerifyOptions asked;
  if (!options.signer.empty()) {
    auto key = evidence::read_public_key(options.signer);
    if (!key) return key.error();
    asked.signer = *std::move(key);
  }
  const auto verified = evidence::verify_job(options.verify, asked);
  if (!verified) return verified.error();
  for (const auto& change : verified->changes)
    std::cout << plain_text(
                     fmt::format("{}: {}: {}", job::name(change.kind), change.file, change.text))
              << "\n";
  for (const auto& note : verified->notes) std::cout << plain_text("note: " + note) << "\n";
  for (const auto& signer : verified->signers) std::cout << "signed by " << signer << "\n";
  if (verified->entries > verified->signed_entries)
    std::cout << fmt::format(
        "not signed: {} of {} entries; without a key this shows what was "
        "altered by chance or carelessly, not who could have made it anew\n",
        verified->entries - verified->signed_entries, verified->entries);
  const bool is_intact = verified->changes.empty();
  std::cout << fmt::format("{}: {} entries, {} files in them, {} changes\n",
                           is_intact ? "intact" : "altered", verified->entries, verified->files,
                           verified->changes.size());
  return is_intact ? 0 : 1;
}

}  // namespace spool::tools
