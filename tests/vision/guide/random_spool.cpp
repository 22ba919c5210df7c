// Spools written as piping files by a random walk: for drawings that nobody laid out by hand.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/guide/random_spool.h"

#include <cmath>
#include <cstdio>
#include <random>

#include <Eigen/Geometry>

namespace spool::test {
namespace {

using Eigen::Vector3d;

// B16.9 and B16.5 class 150, NPS 4 (NPS 1 weldolet), mm.
constexpr double kElbow90 = 152, kElbow45 = 64, kTee = 105, kFlange = 76.2;
constexpr double kOutside = 114.3, kOlet = 27;

class Walk {
 public:
  explicit Walk(const RandomSpool& spool) : spool_(spool), random_(spool.seed) {}

  std::string write() {
    text_ = "UNITS-BORE INCH\nUNITS-CO-ORDS " + std::string(spool_.inches ? "INCH" : "MM") +
            "\nPIPELINE-REFERENCE 4-PL-1\n";
    Vector3d at(1000, 2000, 500), along = Vector3d::UnitX();
    flange(at, along, true);
    at += kFlange * along;
    pipe(at, along, length());
    while (parts_ + 4 < spool_.parts) {
      switch (pick(5)) {
        case 0:
        case 1:
          elbow(at, along, turn(along), kElbow90);
          break;
        case 2: {
          const Vector3d side = turn(along), back = along;
          elbow(at, along, (along + side).normalized(), kElbow45);
          pipe(at, along, length());
          elbow(at, along, back, kElbow45);
          break;
        }
        case 3:
          tee(at, along, turn(along));
          break;
        default:
          pipe_with_olet(at, along, turn(along));
          elbow(at, along, turn(along), kElbow90);
      }
      pipe(at, along, length());
    }
    while (parts_ + 1 < spool_.parts) pipe(at, along, length());
    if (parts_ < spool_.parts) {
      weld(at);
      flange(at, along, false);
    }
    return std::move(text_);
  }

 private:
  int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  double length() { return 200 + 50 * pick(27); }
  // Square to a direction, along an axis.
  Vector3d turn(const Vector3d& along) {
    while (true) {
      Vector3d axis = Vector3d::Zero();
      axis[pick(3)] = pick(2) == 0 ? 1 : -1;
      if (std::abs(axis.dot(along)) < 0.5) return axis;
    }
  }

  void point(const char* key, const Vector3d& at, const char* nps, const char* end) {
    const Vector3d shown = at / (spool_.inches ? 25.4 : 1.0);
    char line[160];
    std::snprintf(line, sizeof line, "    %s %.5f %.5f %.5f %s %s\n", key, shown.x(), shown.y(),
                  shown.z(), nps, end);
    text_ += line;
  }
  void identify() { text_ += "    SPOOL-IDENTIFIER " + spool_.name + "\n"; }
  void begin(const char* keyword) {
    text_ += keyword;
    text_ += "\n";
    ++parts_;
  }
  void weld(const Vector3d& at) {
    ++welds_;
    text_ += "WELD\n";
    point("END-POINT", at, "4", "");
    point("END-POINT", at, "4", "");
    text_ += std::string("    SKEY ") + (welds_ % 8 == 0 ? "WS" : "WW") +
             "\n    WELD-ATTRIBUTE1 W" + std::to_string(welds_) + "\n";
    identify();
  }
  void flange(const Vector3d& at, const Vector3d& along, bool face_first) {
    begin("FLANGE");
    point("END-POINT", at, "4", face_first ? "FL" : "BW");
    point("END-POINT", at + kFlange * along, "4", face_first ? "BW" : "FL");
    text_ += "    SKEY FLWN\n";
    identify();
  }
  void pipe(Vector3d& at, const Vector3d& along, double length) {
    weld(at);
    begin("PIPE");
    point("END-POINT", at, "4", "");
    at += length * along;
    point("END-POINT", at, "4", "");
    identify();
  }
  void elbow(Vector3d& at, Vector3d& along, const Vector3d& next, double to_centre) {
    weld(at);
    begin("ELBOW");
    point("END-POINT", at, "4", "BW");
    const Vector3d centre = at + to_centre * along;
    at = centre + to_centre * next;
    along = next;
    point("END-POINT", at, "4", "BW");
    point("CENTRE-POINT", centre, "", "");
    text_ += "    SKEY ELBW\n";
    identify();
  }
  void tee(Vector3d& at, const Vector3d& along, const Vector3d& side) {
    weld(at);
    begin("TEE");
    const Vector3d centre = at + kTee * along;
    point("END-POINT", at, "4", "BW");
    at = centre + kTee * along;
    point("END-POINT", at, "4", "BW");
    point("CENTRE-POINT", centre, "", "");
    Vector3d branch = centre + kTee * side;
    point("BRANCH1-POINT", branch, "4", "BW");
    text_ += "    SKEY TEBW\n";
    identify();
    pipe(branch, side, 150);
    weld(branch);
    begin("CAP");
    point("END-POINT", branch, "4", "BW");
    text_ += "    SKEY KABW\n";
    identify();
  }
  void pipe_with_olet(Vector3d& at, const Vector3d& along, const Vector3d& side) {
    const Vector3d foot = at + 200 * along;
    pipe(at, along, 400);
    begin("OLET");
    point("CENTRE-POINT", foot, "4", "");
    point("BRANCH1-POINT", foot + (kOutside / 2 + kOlet) * side, "1", "BW");
    text_ += "    SKEY WTBW\n";
    identify();
  }

  const RandomSpool& spool_;
  std::mt19937 random_;
  std::string text_;
  int parts_ = 0, welds_ = 0;
};

}  // namespace

std::string random_spool_pcf(const RandomSpool& spool) { return Walk(spool).write(); }

}  // namespace spool::test
