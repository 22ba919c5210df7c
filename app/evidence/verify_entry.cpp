// One entry of a job's evidence against what the journal, the entry before and itself say of it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/evidence/verify_entry.h"

#include <cmath>

#include "app/evidence/signing.h"
#include "vision/core/file_digest.h"
#include "vision/core/file_io.h"

namespace spool::evidence {
namespace {

using job::Change;
using Kind = job::Change::Kind;
constexpr std::uint64_t kMaxEntryBytes = std::uint64_t{4} << 20U;

// The line of entry.sig: "ed25519", public key, signature; nothing where it is none.
struct Signature {
  std::string public_key, signature;
};
std::optional<Signature> signature_of(const std::string& text) {
  constexpr std::size_t kKey = 64, kSignature = 128;
  const std::string head = "ed25519\n";
  const std::size_t size = head.size() + kKey + 1 + kSignature + 1;
  if (text.size() != size || !text.starts_with(head) || text.back() != '\n' ||
      text[head.size() + kKey] != '\n')
    return std::nullopt;
  return Signature{text.substr(head.size(), kKey), text.substr(head.size() + kKey + 1, kSignature)};
}

void check_date(const job::FileFacts& facts, double written_s, const std::string& file,
                Verified& verified) {
  if (!(std::abs(facts.modified_s - written_s) <= job::kDateSlack_s))
    verified.changes.push_back({Kind::kRedated, file,
                                "is dated " + job::utc_text(facts.modified_s) +
                                    " and was written " + job::utc_text(written_s)});
}

void verify_signature(const EntryPlace& place, const std::string& text, double written_s,
                      const VerifyOptions& options, Verified& verified) {
  const std::string file = place.prefix + kSignatureFile;
  const auto facts = job::facts_of(place.folder, kSignatureFile);
  const std::string expected = place.row ? place.row->signer : options.signer;
  if (!facts) {
    if (!expected.empty() || !options.signer.empty())
      verified.changes.push_back({Kind::kRemoved, file, "the entry is not signed any more"});
    return;
  }
  if (place.row && place.row->signer.empty()) {
    verified.changes.push_back({Kind::kAdded, file, "the entry was not signed when it was made"});
    return;
  }
  const auto bytes = read_file(place.folder / kSignatureFile, 4096);
  const auto signature = bytes ? signature_of(*bytes) : std::nullopt;
  if (!signature || !is_signed(text, signature->signature, signature->public_key)) {
    verified.changes.push_back({Kind::kChanged, file, "does not sign this entry"});
    return;
  }
  if ((place.row && signature->public_key != place.row->signer) ||
      (!options.signer.empty() && signature->public_key != options.signer)) {
    verified.changes.push_back(
        {Kind::kChanged, file, "is signed with another key, " + signature->public_key});
    return;
  }
  check_date(*facts, written_s, file, verified);
  verified.signers.insert(signature->public_key);
  ++verified.signed_entries;
}

}  // namespace

EntryVerdict verify_entry(const EntryPlace& place, const VerifyOptions& options,
                          std::map<std::string, std::string>& recorded, Verified& verified) {
  EntryVerdict verdict;
  const std::string file = place.prefix + kEntryFile;
  verdict.files = {file, place.prefix + kSignatureFile};
  const auto facts = job::facts_of(place.folder, kEntryFile);
  const auto text = facts ? read_file(place.folder / kEntryFile, kMaxEntryBytes)
                          : Result<std::string>(facts.error());
  if (!text) {
    verified.changes.push_back(
        {Kind::kRemoved, file, "the entry is not there, or is no file that can be read"});
    return verdict;
  }
  verdict.sha256 = sha256_hex(*text);
  const bool is_original = !place.row || verdict.sha256 == place.row->entry_sha256;
  if (!is_original)
    verified.changes.push_back({Kind::kChanged, file, "is not the entry that the journal has"});
  auto entry = parse_entry(*text, file);
  if (!entry) {
    if (!place.row) verified.changes.push_back({Kind::kChanged, file, "is no entry"});
    return verdict;
  }
  const double written_s = place.row ? place.row->wall_s : entry->time_s;
  if (is_original) check_date(*facts, written_s, file, verified);
  if (entry->number != place.number)
    verified.changes.push_back(
        {Kind::kChanged, file,
         "is entry " + std::to_string(entry->number) + ", not " + std::to_string(place.number)});
  if (entry->previous_sha256 != place.previous_sha256)
    verified.changes.push_back({Kind::kChanged, file, "does not follow the entry before it"});
  verify_signature(place, *text, written_s, options, verified);
  for (const job::FileFacts& each : entry->files) {
    verdict.files.insert(place.prefix + each.file);
    recorded.emplace(each.sha256, place.prefix + each.file);
    ++verified.files;
    if (auto change = job::changed(each, place.folder, place.prefix))
      verified.changes.push_back(*std::move(change));
  }
  ++verified.entries;
  verdict.entry = *std::move(entry);
  return verdict;
}

}  // namespace spool::evidence
