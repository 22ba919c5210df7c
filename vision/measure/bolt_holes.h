// How a flange is turned about its axis by one scan: the lack of points where its bolt holes are.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vision/core/cancel.h"
#include "vision/design/design_model.h"
#include "vision/measure/drawing.h"
#include "vision/measure/part_feature.h"

namespace spool {

// Adds to `features`, of every part with holes of which the face and the axis of the pipe on it are
// known, how its holes stand (FeatureKind::kHoles), or to why_no_holes why not.
//
// Points on the face are counted by their angle about the point where the pipe's axis meets it: on
// the ring that holes are in, and on the steel inside and outside of it. The ring's share of both
// lacks the holes, and knows neither from where nor how densely the face was seen; the phase of its
// harmonic (hole_harmonic()) is the holes' clocking modulo their pitch. A hole is not said to be
// there unless they stand out by five standard errors (by chance once in 270 000 faces: exp(-25/2))
// and each by itself (are_holes()).
//
// Its standard uncertainty (rad): counting and how the counts scatter; a quarter of the points'
// spacing round the bolt circle, as hole edges fall on a sensor's grid; and the centre's, as far as
// the holes in sight do not cancel it (all round they do).
void add_bolt_holes(const DesignModel& design, const Drawing& drawing, const FeatureScan& scan,
                    PartFeatures& features, const Watch& watch = {});

}  // namespace spool
