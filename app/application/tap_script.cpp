// TAPS.json.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/application/tap_script.h"

#include <algorithm>
#include <optional>
#include <string>

#include "app/common/json_file.h"

namespace spool {

namespace {

std::optional<ui::TouchPhase> parse_phase(const std::string& text) {
  if (text == "down") return ui::TouchPhase::kDown;
  if (text == "move") return ui::TouchPhase::kMove;
  if (text == "up") return ui::TouchPhase::kUp;
  return std::nullopt;
}

std::optional<ui::TouchEvent> parse_event(const nlohmann::json& item) {
  if (!item.is_object()) return std::nullopt;
  const auto number = [&](const char* key, double low, double high) -> std::optional<double> {
    const auto found = item.find(key);
    if (found == item.end() || !found->is_number()) return std::nullopt;
    const double value = found->get<double>();
    return value >= low && value <= high ? std::optional(value) : std::nullopt;
  };
  const auto phase = item.find("phase");
  const auto t = number("t_s", 0, 1e6);
  const auto id = number("id", 0, 31);
  const auto x = number("x", 0, 1);
  const auto y = number("y", 0, 1);
  if (!t || !id || !x || !y || phase == item.end() || !phase->is_string()) return std::nullopt;
  const auto known = parse_phase(phase->get<std::string>());
  if (!known) return std::nullopt;
  return ui::TouchEvent{static_cast<int>(*id), *known, *x, *y, *t, 0};
}

}  // namespace

Result<TapScript> TapScript::read(const std::filesystem::path& path) {
  const Result<nlohmann::json> json = read_json(path);
  if (!json) return json.error();
  const auto refuse = [&](const std::string& what) {
    return Error{
        ErrorCode::kBadInput,
        path.string() + ": " + what +
            "; write {\"events\": [{\"t_s\": 1.5, \"id\": 0, \"phase\": \"down|move|up\", \"x\": "
            "0.4, \"y\": 0.6}]}"};
  };
  const auto events = json->is_object() ? json->find("events") : json->end();
  if (!json->is_object() || events == json->end() || !events->is_array()) {
    return refuse("there is no list of events");
  }
  TapScript script;
  for (const nlohmann::json& item : *events) {
    const auto event = parse_event(item);
    if (!event) return refuse("event " + std::to_string(script.events_.size()) + " cannot be used");
    script.events_.push_back(*event);
  }
  std::stable_sort(script.events_.begin(), script.events_.end(),
                   [](const ui::TouchEvent& a, const ui::TouchEvent& b) { return a.t_s < b.t_s; });
  return script;
}

std::vector<ui::TouchEvent> TapScript::until(double now_s, double width_px, double height_px) {
  std::vector<ui::TouchEvent> out;
  for (; next_ < events_.size() && events_[next_].t_s <= now_s; ++next_) {
    ui::TouchEvent event = events_[next_];
    event.x *= width_px;
    event.y *= height_px;
    out.push_back(event);
  }
  return out;
}

}  // namespace spool
