// What a spool's dimensions truly are: from where its parts stand, by lines and planes of its
// ports.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/campaign/assembly.h"

namespace spool::campaign {

// Of one assembly, drawn or built. Names are those of reports: "flange_1/face", "elbow_1/centre",
// "pipe_2/axis". Nothing where a name is of something else, or no pipe holds an axis there.
class BuiltTruth {
 public:
  explicit BuiltTruth(const Assembly& assembly) : assembly_(assembly), poses_(poses_of(assembly)) {}

  // m, along the pipes between: faces count where the pipe's centreline meets them, centres where
  // it passes nearest to the centreline of another pipe at that fitting.
  [[nodiscard]] std::optional<double> length(const std::string& from, const std::string& to) const;
  // rad, between two pipes, each seen away from where they meet.
  [[nodiscard]] std::optional<double> angle(const std::string& from, const std::string& to) const;
  // rad, of a face against a pipe.
  [[nodiscard]] std::optional<double> lean(const std::string& pipe, const std::string& face) const;
  // rad, right-handed about the flange's own z: how far `flange` stands turned from where `drawn`
  // has it, seen from the flange `datum` (the middle of its face, the pipe on it) and turned about
  // that pipe by `from`: "flange_1/holes" of the datum, or a face or centre aside of it. Of holes
  // nobody knows which is the first: the least of all turns by a pitch.
  [[nodiscard]] std::optional<double> turn(const BuiltTruth& drawn, const std::string& datum,
                                           const std::string& from,
                                           const std::string& flange) const;

 private:
  struct Line {
    Eigen::Vector3d point, along, middle;
  };
  [[nodiscard]] int member(const std::string& name) const;
  [[nodiscard]] Line line(int pipe) const;
  [[nodiscard]] std::vector<int> path(int from, int to) const;
  // Where the node of `part` is on the line of `pipe`.
  [[nodiscard]] std::optional<Eigen::Vector3d> node(int part, int pipe) const;
  [[nodiscard]] std::vector<int> pipes_at(int part) const;
  // The datum's frame: z along its pipe, away from its face; x towards `from`.
  [[nodiscard]] std::optional<Pose> frame(int datum, const std::string& from) const;

  const Assembly& assembly_;
  std::vector<Pose> poses_;
};

}  // namespace spool::campaign
