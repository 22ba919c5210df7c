// What the recorder and the plug-in's relay device say to each other across OpenNI2.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace spool::sensor {

// OpenNI2 records only streams of a device. The relay is a device without a sensor: a frame given
// to its stream by this command comes out of the stream at once, on the same thread. URI:
// "spoolrelay:ID,WIDTH,HEIGHT,HFOV_RAD,VFOV_RAD,COUNT_UM".
inline constexpr char kRelayScheme[] = "spoolrelay:";
inline constexpr char kSimulatorScheme[] = "spoolsim:";  // "spoolsim:SCENE.json"
inline constexpr int kRelayPushCommand = 0x5350;

struct RelayFrame {
  const std::uint16_t* depth;  // WIDTH * HEIGHT counts
  std::uint64_t microseconds;
  std::int32_t index;
};

}  // namespace spool::sensor
