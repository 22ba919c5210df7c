// JSON from files of strangers: size and depth bounded, every error a sentence with the file's
// name.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/common/json_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vision/core/file_io.h"

namespace spool {
namespace {

constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20;

// The deepest nesting of brackets outside strings; what is not JSON may give any number.
int nesting_depth(std::string_view text) {
  int depth = 0;
  int deepest = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      deepest = std::max(deepest, ++depth);
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return deepest;
}

std::string bad(const std::string& name, const std::string& what) { return name + ": " + what; }

}  // namespace

Result<nlohmann::json> parse_json(std::string_view text, const std::string& name) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    return Error{ErrorCode::kBadInput, bad(name, "is empty; a JSON file is needed")};
  if (nesting_depth(text) > kJsonMaxDepth)
    return Error{ErrorCode::kBadInput,
                 bad(name, "is nested deeper than " + std::to_string(kJsonMaxDepth) +
                               " levels; this is not a file made for this program")};
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    const auto line = 1 + std::count(text.begin(), end, '\n');
    return Error{ErrorCode::kBadInput,
                 bad(name, "is not valid JSON at line " + std::to_string(line) +
                               "; it may be cut short or of another kind")};
  } catch (const nlohmann::json::exception&) {  // a number beyond double, such as 1e999
    return Error{ErrorCode::kBadInput, bad(name, "holds a number that is out of range")};
  }
}

Result<nlohmann::json> read_json(const std::filesystem::path& path) {
  const auto bytes = read_file(path, kMaxBytes);
  if (!bytes) return bytes.error();
  return parse_json(*bytes, path.string());
}

std::string json_text(const nlohmann::json& json) {
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

JsonObject::JsonObject(const nlohmann::json& json, std::string file, std::string where)
    : json_(json), file_(std::move(file)), where_(std::move(where)) {
  if (!json_.is_object()) fail("", "has to be an object in braces");
}

void JsonObject::fail(const std::string& key, const std::string& what) {
  if (error_) return;
  std::string place = where_;
  if (!key.empty()) place += place.empty() ? key : "." + key;
  error_ = Error{
      ErrorCode::kBadInput,
      file_ + ": " + (place.empty() ? std::string("the file") : "\"" + place + "\"") + " " + what};
}

bool JsonObject::has(const std::string& key) const {
  return json_.is_object() && json_.contains(key);
}

const nlohmann::json* JsonObject::member(const std::string& key) {
  if (error_) return nullptr;
  const auto found = json_.find(key);
  if (found != json_.end()) return &*found;
  fail(key, "is missing");
  return nullptr;
}

double JsonObject::number(const std::string& key) {
  const auto* value = member(key);
  if (value == nullptr) return 0;
  if (!value->is_number() || !std::isfinite(value->get<double>())) {
    fail(key, "has to be a number");
    return 0;
  }
  return value->get<double>();
}

double JsonObject::number_or(const std::string& key, double other) {
  return has(key) ? number(key) : other;
}

int JsonObject::integer(const std::string& key) {
  const double value = number(key);
  if (error_) return 0;
  if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max()) {
    fail(key, "has to be a whole number");
    return 0;
  }
  return static_cast<int>(value);
}

std::string JsonObject::text_or(const std::string& key, const std::string& other) {
  if (!has(key)) return other;
  const auto* value = member(key);
  if (value == nullptr) return other;
  if (!value->is_string()) {
    fail(key, "has to be a text in quotes");
    return other;
  }
  return value->get<std::string>();
}

const nlohmann::json& JsonObject::array(const std::string& key) {
  static const nlohmann::json kEmpty = nlohmann::json::array();
  const auto* value = member(key);
  if (value == nullptr) return kEmpty;
  if (!value->is_array()) {
    fail(key, "has to be a list in square brackets");
    return kEmpty;
  }
  return *value;
}

std::vector<double> JsonObject::numbers(const std::string& key, std::size_t count) {
  std::vector<double> values(count, 0.0);
  const auto& list = array(key);
  if (error_) return values;
  const auto finite = [](const nlohmann::json& value) {
    return value.is_number() && std::isfinite(value.get<double>());
  };
  if (list.size() != count || !std::all_of(list.begin(), list.end(), finite)) {
    fail(key, "has to be a list of " + std::to_string(count) + " numbers");
    return values;
  }
  std::transform(list.begin(), list.end(), values.begin(),
                 [](const nlohmann::json& value) { return value.get<double>(); });
  return values;
}

}  // namespace spool
