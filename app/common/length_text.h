// Lengths as people read them: millimetres, or feet, inches and sixteenths. Display only.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace spool {

enum class LengthStyle { kMillimetre, kFeetInch };

// `metres` with its unit: "4.6 mm" (one decimal) or 3' 2 5/16" (rounded to the nearest
// sixteenth, 1.6 mm). What is not zero but under half a sixteenth reads <1/16", so that a small
// number is never shown as none. NaN reads "-".
[[nodiscard]] std::string length_text(double metres, LengthStyle style);

// The same with its sign always said: "+4.6 mm", "-1/16"".
[[nodiscard]] std::string signed_length_text(double metres, LengthStyle style);

// A length (m) in that style, or an angle (rad) in degrees: "0.45°", with its sign "+0.45°".
[[nodiscard]] std::string quantity_text(double value, bool is_angle, LengthStyle style,
                                        bool with_sign = false);

// A share of 0..1 in whole per cent; never 100 % for less than all, never 0 % for more than none.
[[nodiscard]] std::string percent_text(double share);

}  // namespace spool
