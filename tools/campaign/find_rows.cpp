// The rows of the finding campaign.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/find_rows.h"

#include <utility>

namespace spool::campaign {
namespace {

SceneRequest laser(ObjectKind kind, std::size_t points, double clutter) {
  return {.kind = kind, .scene_points = points, .clutter_ratio = clutter};
}

SceneRequest by_hand(ObjectKind kind, double clutter) {
  SceneRequest request = laser(kind, 80'000, clutter);
  request.sensor = SensorKind::kHandheld;
  return request;
}

void add_defects(const std::string& of, const SceneRequest& whole, std::vector<FindRow>& rows) {
  for (const auto& [what, defect, amount] :
       {std::tuple("turned", DefectKind::kTurned, 0.0), std::tuple("long", DefectKind::kLong, 80.0),
        std::tuple("swapped", DefectKind::kSwapped, 0.0),
        std::tuple("missing", DefectKind::kMissing, 0.0),
        std::tuple("extra", DefectKind::kExtra, 0.0)}) {
    SceneRequest request = whole;
    request.defects = {{.kind = defect, .amount = amount}};
    rows.push_back({of + "-" + what, std::move(request)});
  }
}

}  // namespace

std::vector<FindRow> find_rows() {
  constexpr auto kSpool = ObjectKind::kPipeSpool3m;
  constexpr auto kFrame = ObjectKind::kBoxFrame;
  constexpr auto kSmall = ObjectKind::kSmallSpool;
  constexpr auto kAny = ObjectKind::kRandomSpool;
  std::vector<FindRow> rows{{"spool-clutter-12", laser(kSpool, 81'000, 12)},
                            {"spool-clutter-51", laser(kSpool, 322'000, 51)},
                            {"spool-580k", laser(kSpool, 580'000, 12)},
                            {"frame-clutter-3", laser(kFrame, 61'000, 3)},
                            {"frame-clutter-10", laser(kFrame, 159'000, 10)},
                            {"frame-clutter-21", laser(kFrame, 322'000, 21)}};
  for (const int ratio : {20, 10, 5, 2, 1})
    for (const auto& [of, kind] : {std::pair("spool", kSpool), std::pair("frame", kFrame)})
      rows.push_back({std::string(of) + "-density-" + std::to_string(ratio),
                      laser(kind, static_cast<std::size_t>(ratio) * kModelPoints, 49)});
  for (const int percent : {90, 70, 50}) {
    SceneRequest request = laser(kSpool, 81'000, 12);
    request.completeness = 0.01 * percent;
    rows.push_back({"spool-complete-" + std::to_string(percent), request});
  }
  for (const auto& [of, kind] : {std::pair("spool", kSpool), std::pair("frame", kFrame),
                                 std::pair("small", kSmall), std::pair("random", kAny)}) {
    SceneRequest request = laser(kind, 81'000, 12);
    request.copies = 0;
    rows.push_back({std::string(of) + "-absent", request});
  }
  SceneRequest two = laser(kSpool, 81'000, 12);
  two.copies = 2;
  rows.push_back({"spool-two", two});
  rows.push_back({"random-laser", laser(kAny, 81'000, 12)});
  rows.push_back({"four-laser", laser(ObjectKind::kFourBranch, 81'000, 12)});
  rows.push_back({"small-hand", by_hand(kSmall, 6)});
  rows.push_back({"random-hand", by_hand(kAny, 6)});
  rows.push_back({"spool-hand", by_hand(kSpool, 6)});
  add_defects("defect", laser(kSpool, 81'000, 12), rows);
  add_defects("random-defect", laser(kAny, 81'000, 12), rows);
  add_defects("hand-defect", by_hand(kSmall, 6), rows);
  return rows;
}

}  // namespace spool::campaign
