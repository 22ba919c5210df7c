// The words of a Piping Component File: which open a record, what kind of component they are, and
// what a symbol key adds to that.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "vision/piping/pipework.h"

namespace spool::piping {

// What a keyword is by itself.
enum class KeywordRole {
  kHeader,     // UNITS-..., ISOGEN-FILES
  kPipeline,   // PIPELINE-REFERENCE
  kMaterials,  // MATERIALS
  kComponent,  // PIPE, ELBOW ...
  kEnd,        // END-CONNECTION-..., END-POSITION-...
  kNotice,     // MESSAGE, FLOW-ARROW ...: says something, is no geometry
  kAttribute,  // END-POINT, SKEY ...: never opens a record, indented or not
  kUnknown
};
[[nodiscard]] KeywordRole role_of(std::string_view keyword);

// One spelling of what writers spell in several ways: CENTER-POINT, COORDS, UCI.
[[nodiscard]] std::string_view canonical(std::string_view keyword);

// The kind of a component keyword; kLink for what is known but has no shape of its own; nothing for
// an unknown keyword.
[[nodiscard]] std::optional<ComponentKind> kind_of_keyword(std::string_view keyword);

// The kind that a symbol key says (its first two letters); nothing where it is not known.
[[nodiscard]] std::optional<ComponentKind> kind_of_skey(std::string_view skey);

// BW, SW, SC, FL, PL ... as the last two of four letters of a symbol key; "" where it says none.
[[nodiscard]] std::string_view end_type_of_skey(std::string_view skey);

// How a flange sits on its pipe, by its symbol key; weld neck where it does not say.
[[nodiscard]] std::optional<FlangeForm> flange_form_of_skey(std::string_view skey);

// Shop or site by a weld's symbol key: WW, WM shop; WS, WF, WO, XX site. Nothing for others.
[[nodiscard]] std::optional<WeldPlace> weld_place_of_skey(std::string_view skey);

// The same by a text such as a category or a weld's attribute; a yard assembly weld has no key of
// its own and is told by the word only.
[[nodiscard]] std::optional<WeldPlace> weld_place_of_text(std::string_view text);

}  // namespace spool::piping
