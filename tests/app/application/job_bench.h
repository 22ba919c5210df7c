// The application on a job of the bracket, which has joints here.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/job/job.h"
#include "render/image.h"
#include "tests/app/application/bench.h"
#include "tests/support/write_file.h"
#include "vision/design/gltf_writer.h"

namespace spool::test {

// The bracket with an arm and a post that are welded to its base.
inline DesignModel jointed_bracket() {
  DesignModel design = bracket_design();
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

class JobOnScreen : public Bench {
 protected:
  void SetUp() override {
    Bench::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    const Result<std::string> glb = write_gltf(jointed_bracket());
    ASSERT_TRUE(glb) << glb.error().message;
    const auto file = write_file(folder_.path() / "bracket.glb", *glb);
    const Status made = job::create_job(path_, {.design = file});
    ASSERT_TRUE(made) << made.error().message;
  }

  // So many steps accepted already, at a tape.
  void open(int accepted, const std::string& operator_name = "operator 1", int width = 800,
            int height = 480) {
    {
      auto job = job::Job::open(path_, job::JobUse::kWork);
      ASSERT_TRUE(job) << job.error().message;
      for (int i = 0; i < accepted; ++i) {
        job::CheckRecord record;
        record.outcome = job::Outcome::kAccept;
        record.override_reason = "measured with a tape";
        record.at = job::now();
        ASSERT_TRUE(job->add(i, record));
      }
    }
    auto session = JobSession::open(path_, operator_name);
    ASSERT_TRUE(session) << session.error().message;
    auto prepared = PreparedDesign::prepare(session->job().design());
    ASSERT_TRUE(prepared);
    design_ = *prepared;
    job_ = std::make_unique<JobSession>(std::move(*session));
    start(standing_still(60), width, height);
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

}  // namespace spool::test
