// The thread that looks for the design in a picture.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/find_worker.h"

#include <utility>

namespace spool {

namespace {
// Of the bar: preparing the design, where that comes first, and of the rest the search itself.
constexpr double kPrepareShare = 0.6, kFindShare = 0.9;
}  // namespace

FindWorker::FindWorker(std::shared_ptr<const PreparedDesign> design, const Camera& camera,
                       const NoiseModel& noise)
    : design_(std::move(design)), camera_(camera), noise_(noise) {}

FindWorker::~FindWorker() {
  closing_.request_stop();
  cancel();
}

void FindWorker::start(VisionStatePtr picture) {
  cancel();
  stop_ = std::stop_source();
  wanted_ = ++searches_;
  thread_.run([this, number = wanted_, picture = std::move(picture), stop = stop_.get_token()] {
    search(number, *picture, stop);
  });
}

void FindWorker::warm_up() {
  if (is_warm_) return;
  is_warm_ = true;
  thread_.run([this, stop = closing_.get_token()] {
    static_cast<void>(ready_finder(Watch{stop, {}}));
  });
}

void FindWorker::cancel() {
  stop_.request_stop();
  wanted_ = 0;
}

std::optional<FindProgress> FindWorker::progress() {
  auto newest = progress_.try_take();
  if (!newest || newest->search != wanted_) return std::nullopt;
  return std::move(newest->value);
}

std::optional<FindAnswer> FindWorker::take() {
  while (auto answer = answers_.try_pop()) {
    if (answer->search != wanted_) continue;  // it was done just before it was cancelled
    wanted_ = 0;
    return std::move(answer->value);
  }
  return std::nullopt;
}

const FinderModel* FindWorker::ready_finder(const Watch& watch) {
  if (design_->finder) return design_->finder.get();
  if (finder_) return finder_.get();
  auto prepared = std::make_unique<FinderModel>(
      FinderModel::prepare(design_->exterior, *design_->surface, design_->samples, 1, watch));
  if (watch.cancelled()) return nullptr;
  finder_ = std::move(prepared);
  return finder_.get();
}

void FindWorker::search(std::uint64_t number, const VisionState& picture,
                        const std::stop_token& stop) {
  const double prepared = design_->finder || finder_ ? 0.0 : kPrepareShare;
  const auto whole = [&](std::string_view stage, double share) {
    if (stage == "prepare") return prepared * share;
    return prepared + (1 - prepared) * (stage == "find" ? kFindShare * share : kFindShare);
  };
  const Watch watch{stop, [&](std::string_view stage, double share) {
                      progress_.put({number, {std::string(stage), whole(stage, share)}});
                    }};
  if (stop.stop_requested()) return;
  const FinderModel* finder = ready_finder(watch);
  if (finder == nullptr) return;
  FindAnswer answer = find_in_picture(design_, *finder, picture, camera_, noise_, watch);
  if (!stop.stop_requested()) static_cast<void>(answers_.push({number, std::move(answer)}));
}

}  // namespace spool
