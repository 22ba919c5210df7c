// The report as BCF: a sound ZIP, each file as our grammar of BCF 2.1 has it, texts masked.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/ncr_bcf.h"

#include <map>
#include <regex>

#include <zip.h>

#include <gtest/gtest.h>

#include "tests/app/ncr/sample_ncr.h"
#include "tests/support/process.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace spool::test {
namespace {

// All files of a ZIP, each read to its end, which checks its CRC.
std::map<std::string, std::string> unpacked(const std::filesystem::path& path) {
  std::map<std::string, std::string> files;
  int code = 0;
  zip_t* archive = zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code);
  EXPECT_NE(archive, nullptr) << "libzip's error " << code;
  if (archive == nullptr) return files;
  for (zip_int64_t k = 0; k < zip_get_num_entries(archive, 0); ++k) {
    zip_stat_t state;
    zip_stat_index(archive, static_cast<zip_uint64_t>(k), 0, &state);
    std::string bytes(state.size, '\0');
    zip_file_t* file = zip_fopen_index(archive, static_cast<zip_uint64_t>(k), 0);
    EXPECT_EQ(zip_fread(file, bytes.data(), bytes.size()), static_cast<zip_int64_t>(bytes.size()));
    char end = 0;
    EXPECT_EQ(zip_fread(file, &end, 1), 0) << state.name;
    zip_fclose(file);
    EXPECT_TRUE(files.emplace(state.name, bytes).second) << state.name << " is there twice";
  }
  zip_discard(archive);
  return files;
}

class NcrBcf : public ::testing::Test {
 protected:
  std::map<std::string, std::string> written(const ncr::NcrDocument& document) const {
    const auto bytes = ncr::ncr_bcf(document);
    EXPECT_TRUE(bytes);
    return unpacked(write_file(folder_.path() / "report.bcfzip", *bytes));
  }
  // xmllint's word on each XML file.
  void expect_grammar(const std::map<std::string, std::string>& files) const {
    for (const auto& [name, bytes] : files) {
      if (name.ends_with(".png")) continue;
      const auto path = write_file(folder_.path() / "one.xml", bytes);
      const ProcessResult checked =
          run("/usr/bin/xmllint",
              {"--noout", "--relaxng", (source_dir() / "tests/app/ncr/bcf.rng").string(), path});
      EXPECT_EQ(checked.code, 0) << name << "\n" << checked.err << bytes;
    }
  }
  TemporaryFolder folder_;
};

#define NEEDS_XMLLINT()                             \
  if (!std::filesystem::exists("/usr/bin/xmllint")) \
  GTEST_SKIP() << "xmllint (libxml2-utils) is not there"

TEST_F(NcrBcf, KeepsToTheGrammar) {
  NEEDS_XMLLINT();
  expect_grammar(written(sample_ncr()));
  ncr::NcrDocument bare;  // nobody named, no picture, no description
  bare.form = ncr::empty_form();
  bare.created = "2026-11-29T06:15:00.250Z";
  ncr::set_number("J-S-NCR-001", bare);
  expect_grammar(written(bare));
}

TEST_F(NcrBcf, HoldsTopicViewpointsAndSnapshotsThatBelongTogether) {
  const ncr::NcrDocument document = sample_ncr();
  const auto files = written(document);
  EXPECT_TRUE(files.contains("bcf.version"));
  EXPECT_TRUE(files.contains("project.bcfp"));
  const std::string topic = ncr::guid_of(document.number) + "/";
  ASSERT_TRUE(files.contains(topic + "markup.bcf"));
  const std::string& markup = files.at(topic + "markup.bcf");
  // Only the first picture says from where it is seen.
  EXPECT_EQ(files.at(topic + "snapshot.png"), document.evidence.pictures[0].png);
  EXPECT_EQ(files.size(), 5U);
  const std::string& view = files.at(topic + "viewpoint.bcfv");
  std::smatch guid;
  ASSERT_TRUE(std::regex_search(view, guid, std::regex("VisualizationInfo Guid=\"([^\"]+)\"")));
  EXPECT_NE(markup.find("<Viewpoints Guid=\"" + guid.str(1)), std::string::npos);
  EXPECT_NE(markup.find("<Viewpoint Guid=\"" + guid.str(1)), std::string::npos);
  EXPECT_NE(markup.find("<Topic Guid=\"" + ncr::guid_of(document.number)), std::string::npos);
  // +x -y +z of the design is +x, -z up and -y of the model: from below, looking up and north-west.
  std::smatch way;
  ASSERT_TRUE(std::regex_search(
      view, way, std::regex("CameraDirection><X>([^<]+)</X><Y>([^<]+)</Y><Z>([^<]+)</Z>")));
  const double third = 1 / std::sqrt(3.0);
  EXPECT_NEAR(std::stod(way.str(1)), -third, 1e-6);
  EXPECT_NEAR(std::stod(way.str(2)), third, 1e-6);
  EXPECT_NEAR(std::stod(way.str(3)), third, 1e-6);
}

TEST_F(NcrBcf, MasksTextsAndKeepsLineEnds) {
  const std::string markup =
      written(sample_ncr()).at(ncr::guid_of("JOB-F01-NCR-007") + "/markup.bcf");
  EXPECT_NE(markup.find("é &lt;b&gt;&quot;A&amp;B&quot; &#39;ø&#39; ]]&gt; ½ ß\nsecond line"),
            std::string::npos)
      << markup;
  EXPECT_NE(markup.find("operator 1 &lt;é&gt;"), std::string::npos);
}

TEST_F(NcrBcf, IsTheSameEveryTimeAndAnotherOfAnotherNumber) {
  ncr::NcrDocument document = sample_ncr();
  const auto one = ncr::ncr_bcf(document), other = ncr::ncr_bcf(document);
  ASSERT_TRUE(one);
  EXPECT_EQ(*one, *other);
  EXPECT_NE(ncr::guid_of("A-B-NCR-001"), ncr::guid_of("A-B-NCR-002"));
  EXPECT_TRUE(std::regex_match(
      ncr::guid_of("x"),
      std::regex("[0-9a-f]{8}-[0-9a-f]{4}-8[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}")));
}

}  // namespace
}  // namespace spool::test
