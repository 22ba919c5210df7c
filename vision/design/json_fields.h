// Fields of an object in a glTF's extras: a value of the right type, or a warning that names the
// field.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tiny_gltf.h>

#include <Eigen/Core>

namespace spool {

// Reads one object. `where` names it in warnings, "node 'tee_1' ports[2]". Absent and null fields
// are silent, fields of the wrong type warn and count as absent.
class JsonFields {
 public:
  JsonFields(const tinygltf::Value& object, std::string where, std::vector<std::string>& warnings)
      : object_(&object), where_(std::move(where)), warnings_(&warnings) {
    if (!object.IsObject()) warn("is not an object");
  }

  [[nodiscard]] const std::string& where() const { return where_; }
  void warn(const std::string& what) const { warnings_->push_back(where_ + " " + what); }

  [[nodiscard]] std::optional<double> number(const std::string& key) const {
    const tinygltf::Value* value = find(key);
    if (value == nullptr) return std::nullopt;
    if (!value->IsNumber() || !std::isfinite(value->GetNumberAsDouble())) {
      warn("has '" + key + "' that is not a number; it is left out");
      return std::nullopt;
    }
    return value->GetNumberAsDouble();
  }

  // A number of at least zero: sizes.
  [[nodiscard]] std::optional<double> size(const std::string& key) const {
    const std::optional<double> value = number(key);
    if (value && *value < 0) {
      warn("has '" + key + "' below zero; it is left out");
      return std::nullopt;
    }
    return value;
  }

  [[nodiscard]] std::optional<int> integer(const std::string& key) const {
    const std::optional<double> value = number(key);
    if (value && (*value != std::floor(*value) || std::abs(*value) > 1e9)) {
      warn("has '" + key + "' that is not a whole number; it is left out");
      return std::nullopt;
    }
    return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
  }

  // Text; whole numbers are spelled out where `or_number` (a schedule of 40, a rating of 150).
  [[nodiscard]] std::optional<std::string> text(const std::string& key,
                                                bool or_number = false) const {
    const tinygltf::Value* value = find(key);
    if (value == nullptr) return std::nullopt;
    if (value->IsString()) return value->Get<std::string>();
    if (or_number && value->IsNumber()) {
      const double number = value->GetNumberAsDouble();
      std::string spelled = std::to_string(number);
      spelled.erase(spelled.find_last_not_of('0') + 1);
      if (spelled.back() == '.' || spelled.back() == ',') spelled.pop_back();
      return spelled;
    }
    warn("has '" + key + "' that is not text; it is left out");
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Eigen::Vector3d> vector(const std::string& key) const {
    const tinygltf::Value* value = find(key);
    if (value == nullptr) return std::nullopt;
    Eigen::Vector3d out;
    bool good = value->IsArray() && value->ArrayLen() == 3;
    for (int i = 0; good && i < 3; ++i) {
      good = value->Get(i).IsNumber();
      if (good) out[i] = value->Get(i).GetNumberAsDouble();
    }
    if (!good || !out.allFinite()) {
      warn("has '" + key + "' that is not three numbers; it is left out");
      return std::nullopt;
    }
    return out;
  }

  // The elements of an array.
  [[nodiscard]] std::vector<const tinygltf::Value*> list(const std::string& key) const {
    std::vector<const tinygltf::Value*> elements;
    const tinygltf::Value* value = find(key);
    if (value == nullptr) return elements;
    if (!value->IsArray()) {
      warn("has '" + key + "' that is not a list; it is left out");
      return elements;
    }
    for (std::size_t i = 0; i < value->ArrayLen(); ++i) {
      elements.push_back(&value->Get(static_cast<int>(i)));
    }
    return elements;
  }

  // An object within, with its own place in warnings.
  [[nodiscard]] std::optional<JsonFields> object(const std::string& key) const {
    const tinygltf::Value* value = find(key);
    if (value == nullptr) return std::nullopt;
    if (!value->IsObject()) {
      warn("has '" + key + "' that is not an object; it is left out");
      return std::nullopt;
    }
    return JsonFields(*value, where_ + " " + key, *warnings_);
  }

  [[nodiscard]] JsonFields element(const tinygltf::Value& value, const std::string& key,
                                   std::size_t index) const {
    return {value, where_ + " " + key + "[" + std::to_string(index) + "]", *warnings_};
  }

 private:
  [[nodiscard]] const tinygltf::Value* find(const std::string& key) const {
    if (!object_->IsObject() || !object_->Has(key)) return nullptr;
    const tinygltf::Value& value = object_->Get(key);
    return value.Type() == tinygltf::NULL_TYPE ? nullptr : &value;
  }

  const tinygltf::Value* object_;
  std::string where_;
  std::vector<std::string>* warnings_;
};

}  // namespace spool
