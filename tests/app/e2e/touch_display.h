// A display of its own with a touch screen: real X events of fingers that a test moves.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "tests/app/application/robot_fitter.h"
#include "tests/app/e2e/running_program.h"
#include "vision/core/result.h"

namespace spool::test {

// Xorg with its dummy screen and its input test driver: neither hardware nor a virtual terminal.
class TouchDisplay {
 public:
  static constexpr int kWidth = 1280, kHeight = 800;  // px

  // Its files go into `folder`. kNoDevice with the reason where the server, a driver or the
  // protocol that the test was built with is absent.
  [[nodiscard]] static Result<std::unique_ptr<TouchDisplay>> start(
      const std::filesystem::path& folder);
  TouchDisplay(const TouchDisplay&) = delete;
  TouchDisplay& operator=(const TouchDisplay&) = delete;
  ~TouchDisplay();

  [[nodiscard]] const std::string& name() const { return name_; }  // ":1", for DISPLAY

  // A finger by a number of the caller's; px of the screen. False where the server went away.
  [[nodiscard]] bool down(std::uint32_t finger, const Spot& spot) const;
  [[nodiscard]] bool move(std::uint32_t finger, const Spot& spot) const;
  [[nodiscard]] bool up(std::uint32_t finger, const Spot& spot) const;
  [[nodiscard]] bool tap(const Spot& spot) const;

 private:
  TouchDisplay(std::unique_ptr<RunningProgram> server, std::string name)
      : server_(std::move(server)), name_(std::move(name)) {}
  [[nodiscard]] Status connect(const std::filesystem::path& socket);

  std::unique_ptr<RunningProgram> server_;
  std::string name_;
  int socket_ = -1;
};

}  // namespace spool::test
