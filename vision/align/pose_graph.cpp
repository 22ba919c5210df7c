// A pose graph: keyframes' poses, what was measured between them, and how sure they are by it.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "vision/align/pose_graph.h"

#include <cassert>
#include <optional>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace spool {
namespace {

using Columns = Eigen::Matrix<double, Eigen::Dynamic, 6>;
using Sparse = Eigen::SparseMatrix<double>;

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Matrix6d inverse_of(const Matrix6d& symmetric) {
  const Matrix6d inverse = symmetric.ldlt().solve(Matrix6d::Identity());
  return 0.5 * (inverse + inverse.transpose());
}

Matrix6d symmetric(const Matrix6d& m) { return 0.5 * (m + m.transpose()); }

// Two views that share at least half of what they see, of a sensor that sees a radian at a metre.
bool are_one_place(const Pose& a, const Pose& b) {
  constexpr double kPlaceM = 0.5, kPlaceRad = 0.5;
  const PoseSize apart = pose_size(a.inverse() * b);
  return apart.translation_m < kPlaceM && apart.rotation_rad < kPlaceRad;
}

}  // namespace

Vector6d small_between(const Pose& a, const Pose& b) {
  const Pose apart = a.inverse() * b;
  Vector6d small;
  small << apart.translation(), rotation_vector(apart.linear());
  return small;
}

Matrix6d small_seen_from(const Pose& T_camera_there) {
  // Small(x) T = T Small(y): y.rotation = R^T w, y.translation = R^T (v + w x t).
  const Eigen::Matrix3d back = T_camera_there.linear().transpose();
  Matrix6d seen = Matrix6d::Zero();
  seen.topLeftCorner<3, 3>() = seen.bottomRightCorner<3, 3>() = back;
  seen.topRightCorner<3, 3>() = -back * cross_matrix(T_camera_there.translation());
  return seen;
}

struct PoseGraph::Impl {
  struct Keyframe {
    Pose T_map_keyframe = Pose::Identity();
    std::size_t parent = 0;
    Matrix6d step = Matrix6d::Zero();  // covariance of what was added to its parent's
  };
  struct Edge : PoseEdge {
    static constexpr std::size_t kOdometry = static_cast<std::size_t>(-1);
    std::size_t group = kOdometry;  // of loops
  };
  std::vector<Keyframe> keyframes;
  std::vector<Edge> edges;
  std::vector<std::size_t> group_sizes;
  Pose T_map_first = Pose::Identity();  // as measured
  Matrix6d first_information;
  // What follows from them: worked out when it is asked for.
  std::vector<std::optional<Matrix6d>> covariances;
  Eigen::SimplicialLDLT<Sparse> factor;
  bool is_factored = false;

  [[nodiscard]] std::size_t group_of(const PoseEdge& loop) const;
  // How many edges this one is one of, that count as one.
  [[nodiscard]] double shared_by(const Edge& edge) const {
    return edge.group == Edge::kOdometry ? 1 : static_cast<double>(group_sizes[edge.group]);
  }
  Eigen::VectorXd linearise(Sparse& information, double& squared);
  void factorise();
  [[nodiscard]] Columns columns_of(std::size_t i);
  const Matrix6d& covariance(std::size_t i);
  [[nodiscard]] Vector6d residual(const PoseEdge& edge) const {
    return small_between(edge.T_from_to, keyframes[edge.from].T_map_keyframe.inverse() *
                                             keyframes[edge.to].T_map_keyframe);
  }
  void forget() {
    covariances.assign(keyframes.size(), std::nullopt);
    is_factored = false;
  }
};

PoseGraph::PoseGraph(const Pose& T_map_first, const Matrix6d& covariance)
    : impl_(std::make_unique<Impl>()) {
  impl_->keyframes.push_back({T_map_first, 0, covariance});
  impl_->T_map_first = T_map_first;
  impl_->first_information = inverse_of(covariance);
  impl_->covariances.emplace_back(covariance);
}
PoseGraph::~PoseGraph() = default;
PoseGraph::PoseGraph(PoseGraph&&) noexcept = default;
PoseGraph& PoseGraph::operator=(PoseGraph&&) noexcept = default;

std::size_t PoseGraph::size() const { return impl_->keyframes.size(); }
std::size_t PoseGraph::edge_count() const { return impl_->edges.size(); }
const Pose& PoseGraph::T_map_keyframe(std::size_t i) const {
  return impl_->keyframes[i].T_map_keyframe;
}
std::size_t PoseGraph::parent(std::size_t i) const { return impl_->keyframes[i].parent; }
const Matrix6d& PoseGraph::step_covariance(std::size_t i) const { return impl_->keyframes[i].step; }
const Matrix6d& PoseGraph::covariance(std::size_t i) const { return impl_->covariance(i); }

std::size_t PoseGraph::add(std::size_t from, const Pose& T_from_to, const Matrix6d& covariance) {
  assert(from < size() && "a keyframe that is there");
  Impl& self = *impl_;
  const Matrix6d carried = small_seen_from(T_from_to);
  // One edge alone changes nothing for the others.
  const Matrix6d own = carried * self.covariance(from) * carried.transpose() + covariance;
  const std::size_t index = size();
  self.edges.push_back({{from, index, T_from_to, covariance}});
  self.keyframes.push_back({T_map_keyframe(from) * T_from_to, from, covariance});
  self.covariances.emplace_back(symmetric(own));
  self.is_factored = false;
  return index;
}

// The normal equations about the poses as they are: their information, and the gradient.
Eigen::VectorXd PoseGraph::Impl::linearise(Sparse& information, double& squared) {
  const auto n = static_cast<Eigen::Index>(6 * keyframes.size());
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(36 * (4 * edges.size() + 1));
  const auto add_block = [&](std::size_t row, std::size_t column, const Matrix6d& block) {
    for (int r = 0; r < 6; ++r)
      for (int c = 0; c < 6; ++c)
        entries.emplace_back(static_cast<int>(6 * row) + r, static_cast<int>(6 * column) + c,
                             block(r, c));
  };
  const auto part = [&](std::size_t i) {
    return gradient.segment<6>(static_cast<Eigen::Index>(6 * i));
  };
  const Vector6d first = small_between(T_map_first, keyframes[0].T_map_keyframe);
  squared = first.dot(first_information * first);
  add_block(0, 0, first_information);
  part(0) -= first_information * first;
  for (const Edge& edge : edges) {
    const Vector6d off = residual(edge);
    const Matrix6d weight = inverse_of(edge.covariance) / shared_by(edge);
    // To first order in what is left over, which the odometry keeps small.
    const Matrix6d by_from = -small_seen_from(keyframes[edge.from].T_map_keyframe.inverse() *
                                              keyframes[edge.to].T_map_keyframe);
    const Matrix6d across = by_from.transpose() * weight;
    squared += off.dot(weight * off);
    add_block(edge.from, edge.from, across * by_from);
    add_block(edge.from, edge.to, across);
    add_block(edge.to, edge.from, across.transpose());
    add_block(edge.to, edge.to, weight);
    part(edge.from) -= across * off;
    part(edge.to) -= weight * off;
  }
  information.resize(n, n);
  information.setFromTriplets(entries.begin(), entries.end());
  return gradient;
}

void PoseGraph::Impl::factorise() {
  if (is_factored) return;
  Sparse information;
  double squared = 0;
  (void)linearise(information, squared);
  factor.compute(information);
  is_factored = true;
}

// Covariance of all keyframes with keyframe i.
Columns PoseGraph::Impl::columns_of(std::size_t i) {
  factorise();
  Columns unit = Columns::Zero(static_cast<Eigen::Index>(6 * keyframes.size()), 6);
  unit.middleRows<6>(static_cast<Eigen::Index>(6 * i)).setIdentity();
  return factor.solve(unit);
}

const Matrix6d& PoseGraph::Impl::covariance(std::size_t i) {
  if (!covariances[i])
    covariances[i] = symmetric(columns_of(i).middleRows<6>(static_cast<Eigen::Index>(6 * i)));
  return *covariances[i];
}

std::vector<Matrix6d> PoseGraph::covariances_from(std::size_t from,
                                                  std::span<const std::size_t> others) const {
  Impl& self = *impl_;
  const Columns with_from = self.columns_of(from);
  const Matrix6d own = with_from.middleRows<6>(static_cast<Eigen::Index>(6 * from));
  std::vector<Matrix6d> seen;
  seen.reserve(others.size());
  for (const std::size_t other : others) {
    const Matrix6d carried =
        small_seen_from(T_map_keyframe(from).inverse() * T_map_keyframe(other));
    const Matrix6d cross = with_from.middleRows<6>(static_cast<Eigen::Index>(6 * other));
    const Matrix6d mixed = cross * carried.transpose();
    seen.push_back(symmetric(self.covariance(other) - mixed - mixed.transpose() +
                             carried * own * carried.transpose()));
  }
  return seen;
}

double PoseGraph::chi_square(const PoseEdge& edge) const {
  const std::size_t to[] = {edge.to};
  const Vector6d off = impl_->residual(edge);
  const Matrix6d both = covariances_from(edge.from, to).front() + edge.covariance;
  return off.dot(both.ldlt().solve(off));
}

bool PoseGraph::close(const PoseEdge& edge) {
  assert(edge.from < size() && edge.to < size() && edge.from != edge.to && "two keyframes");
  const double chi_square_of = chi_square(edge);
  if (!(chi_square_of <= kChiSquare6At999)) return false;
  const std::size_t group = impl_->group_of(edge);
  if (group == impl_->group_sizes.size()) impl_->group_sizes.push_back(0);
  ++impl_->group_sizes[group];
  impl_->edges.push_back({edge, group});
  impl_->forget();
  return true;
}

// The group whose first edge joins the same two places; a new one where none does.
std::size_t PoseGraph::Impl::group_of(const PoseEdge& loop) const {
  const Pose& from = keyframes[loop.from].T_map_keyframe;
  const Pose& to = keyframes[loop.to].T_map_keyframe;
  std::vector<bool> looked_at(group_sizes.size(), false);
  for (const Edge& edge : edges) {
    if (edge.group == Edge::kOdometry || looked_at[edge.group]) continue;
    looked_at[edge.group] = true;  // by its first edge: no chain from place to place
    const Pose& a = keyframes[edge.from].T_map_keyframe;
    const Pose& b = keyframes[edge.to].T_map_keyframe;
    if ((are_one_place(a, from) && are_one_place(b, to)) ||
        (are_one_place(a, to) && are_one_place(b, from)))
      return edge.group;
  }
  return group_sizes.size();
}

double PoseGraph::solve() {
  Impl& self = *impl_;
  constexpr int kMostSteps = 10;
  double squared = 0;
  for (int i = 0; i < kMostSteps; ++i) {
    Sparse information;
    const Eigen::VectorXd gradient = self.linearise(information, squared);
    self.factor.compute(information);
    const Eigen::VectorXd step = self.factor.solve(gradient);
    for (std::size_t k = 0; k < size(); ++k) {
      Pose& T = self.keyframes[k].T_map_keyframe;
      T = T * pose_from_small(step.segment<6>(static_cast<Eigen::Index>(6 * k)));
      T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
    }
    if (step.cwiseAbs().maxCoeff() < 1e-7) break;  // m and rad: a thousandth of what counts
  }
  self.forget();
  return squared;
}

std::size_t PoseGraph::take_out(std::size_t i) {
  assert(i > 0 && i < size() && "a keyframe that is there, but the first");
  Impl& self = *impl_;
  std::size_t heir = self.keyframes[i].parent;
  const Matrix6d step = self.keyframes[i].step;
  const Pose T_heir_i = T_map_keyframe(heir).inverse() * T_map_keyframe(i);
  std::vector<Impl::Edge> kept;
  kept.reserve(self.edges.size());
  for (const Impl::Edge& edge : self.edges) {
    if (edge.from != i && edge.to != i) {
      kept.push_back(edge);
      continue;
    }
    const std::size_t other = edge.from == i ? edge.to : edge.from;
    if (other == heir) {
      if (edge.group != Impl::Edge::kOdometry) --self.group_sizes[edge.group];
      continue;
    }
    // As seen from the one that goes: turned round where it was the far end.
    const Pose T_i_other = edge.from == i ? edge.T_from_to : edge.T_from_to.inverse();
    Matrix6d covariance = edge.covariance;
    if (edge.to == i) {
      const Matrix6d turned = small_seen_from(T_i_other);
      covariance = turned * covariance * turned.transpose();
    }
    const Matrix6d carried = small_seen_from(T_i_other);
    kept.push_back({{heir, other, T_heir_i * T_i_other,
                     symmetric(carried * step * carried.transpose() + covariance)},
                    edge.group});
  }
  self.edges = std::move(kept);
  for (std::size_t k = 0; k < size(); ++k) {
    Impl::Keyframe& child = self.keyframes[k];
    if (k == i || child.parent != i) continue;
    child.parent = heir;
    const Matrix6d carried = small_seen_from(T_map_keyframe(i).inverse() * child.T_map_keyframe);
    child.step = symmetric(carried * step * carried.transpose() + child.step);
  }
  const std::size_t last = size() - 1;
  self.keyframes[i] = self.keyframes[last];
  self.keyframes.pop_back();
  for (Impl::Edge& edge : self.edges) {
    if (edge.from == last) edge.from = i;
    if (edge.to == last) edge.to = i;
  }
  for (Impl::Keyframe& each : self.keyframes)
    if (each.parent == last) each.parent = i;
  if (heir == last) heir = i;
  self.forget();
  return heir;
}

}  // namespace spool
