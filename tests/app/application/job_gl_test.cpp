// A job's step on the screen: the ghost of what comes next, a check into the journal, Accept.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "app/job/job_progress.h"
#include "render/image.h"
#include "tests/app/application/bench.h"
#include "tests/support/write_file.h"
#include "vision/design/gltf_writer.h"

namespace spool {
namespace {

using job::Outcome;

// The bracket with an arm and a post that are welded to its base.
DesignModel jointed_bracket() {
  DesignModel design = test::bracket_design();
  const auto port = [](const char* name, const Eigen::Vector3d& at, double z) {
    return Port{name, at, {0, 0, z}, 4, EndType::kButtWeld};
  };
  const auto low = [&](int part) {
    const Part& of = design.parts[static_cast<std::size_t>(part)];
    Eigen::AlignedBox3d box;
    for (std::uint32_t t = 0; t < of.triangle_count; ++t)
      for (const std::uint32_t v : design.mesh.triangles[of.first_triangle + t])
        box.extend(design.mesh.vertices[v].cast<double>());
    return Eigen::Vector3d(box.center().x(), box.center().y(), box.min().z());
  };
  const Eigen::Vector3d arm = low(1), post = low(2);
  design.parts[0].ports = {port("arm", arm, 1), port("post", post, 1)};
  design.parts[1].ports = {port("base", arm, -1)};
  design.parts[2].ports = {port("base", post, -1)};
  design.joints = {{"W1", 0, 0, 1, 0}, {"W2", 0, 1, 2, 0}};
  return design;
}

class JobOnScreen : public test::Bench {
 protected:
  void SetUp() override {
    Bench::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    const Result<std::string> glb = write_gltf(jointed_bracket());
    ASSERT_TRUE(glb) << glb.error().message;
    const auto file = test::write_file(folder_.path() / "bracket.glb", *glb);
    const Status made = job::create_job(path_, {.design = file});
    ASSERT_TRUE(made) << made.error().message;
  }

  // So many steps accepted already, at a tape.
  void open(int accepted) {
    {
      auto job = job::Job::open(path_, job::JobUse::kWork);
      ASSERT_TRUE(job) << job.error().message;
      for (int i = 0; i < accepted; ++i) {
        job::CheckRecord record;
        record.outcome = Outcome::kAccept;
        record.override_reason = "measured with a tape";
        record.at = job::now();
        ASSERT_TRUE(job->add(i, record));
      }
    }
    auto session = JobSession::open(path_, "operator 1");
    ASSERT_TRUE(session) << session.error().message;
    auto prepared = PreparedDesign::prepare(session->job().design());
    ASSERT_TRUE(prepared);
    design_ = *prepared;
    job_ = std::make_unique<JobSession>(std::move(*session));
    start(test::standing_still(60));
  }

  void align() {
    pick_three();
    press("Done");
    ASSERT_EQ(screen_["screen"], "work") << screen_.dump();
  }

  // Pixels of the ghost's sky blue.
  [[nodiscard]] int blue() const {
    const render::Image image = app_->picture().target().read();
    int count = 0;
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
      const int r = image.rgba[i], g = image.rgba[i + 1], b = image.rgba[i + 2];
      count += b > 120 && b - r > 60 && g - r > 30 && b > g ? 1 : 0;
    }
    return count;
  }

  [[nodiscard]] std::vector<job::CheckRecord> journal() const {
    auto job = job::Job::open(path_, job::JobUse::kLook);
    return job ? job->records() : std::vector<job::CheckRecord>{};
  }

  std::filesystem::path path_ = folder_.path() / "bracket.spooljob";
};

TEST_F(JobOnScreen, ShowsTheNextPartsGhostUntilItIsAccepted) {
  ASSERT_NO_FATAL_FAILURE(open(2));
  EXPECT_EQ(screen_["step"], "step 3 of 3");
  ASSERT_NO_FATAL_FAILURE(align());
  EXPECT_NE(std::string(screen_["hint"]).find("W2, fab weld"), std::string::npos)
      << screen_["hint"];
  const int with_ghost = blue();
  EXPECT_GT(with_ghost, 300);
  EXPECT_FALSE(offers("Accept")) << "it was not checked";
  press("Check");
  for (int i = 0; i < 6 && !offers("Accept"); ++i) step();
  ASSERT_TRUE(offers("Accept")) << screen_.dump();
  EXPECT_EQ(journal().size(), 3U) << "the check is in the journal before anybody decides";
  press("Accept");
  EXPECT_EQ(screen_["step"], "all 3 steps accepted");
  EXPECT_FALSE(offers("Accept"));
  EXPECT_LT(blue() + 500, with_ghost) << "buttons are blue as well, before and after";
  const std::vector<job::CheckRecord> records = journal();
  ASSERT_EQ(records.size(), 4U);
  EXPECT_EQ(records[2].outcome, Outcome::kRedo);
  EXPECT_EQ(records[3].outcome, Outcome::kAccept);
  EXPECT_EQ(records[3].report_sha256, records[2].report_sha256);
  EXPECT_FALSE(records[3].report_sha256.empty());
  EXPECT_EQ(records[3].operator_name, "operator 1");
  const auto histories = job::joint_histories(records);
  ASSERT_EQ(histories.size(), 2U);
  EXPECT_EQ(histories[1].tries, 1) << "one check, decided";
}

// What is not on the table is neither drawn nor proposed nor picked.
TEST_F(JobOnScreen, LeavesOutWhatIsNotBuiltYet) {
  ASSERT_NO_FATAL_FAILURE(open(0));
  EXPECT_EQ(screen_["step"], "step 1 of 3");
  EXPECT_EQ(std::string(screen_["hint"]).find("arm"), std::string::npos) << screen_["hint"];
  EXPECT_EQ(std::string(screen_["hint"]).find("post"), std::string::npos) << screen_["hint"];
  const auto pairs = three();
  int refused = 0;
  for (const test::SpotPair& pair : pairs) {
    tap_at(pair.design);
    const std::string hint = screen_["hint"];
    EXPECT_EQ(hint.find("arm,"), std::string::npos) << hint;
    EXPECT_EQ(hint.find("post,"), std::string::npos) << hint;
    if (hint.find("where you tapped") == std::string::npos)
      ++refused;
    else
      press("Undo");  // what was chosen stays so, whatever is tapped next
  }
  EXPECT_GT(refused, 0) << "the three points lie on more than the base";
}

TEST_F(JobOnScreen, IsHeldAlone) {
  ASSERT_NO_FATAL_FAILURE(open(0));
  const auto second = JobSession::open(path_, "");
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace spool
