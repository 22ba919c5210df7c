// The report as BCF 2.1, which model checkers open: one topic with its viewpoints and pictures.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/ncr/fill_form.h"
#include "app/ncr/zip_bytes.h"
#include "vision/core/result.h"

namespace spool::ncr {

// The GUID of something by name: of the same name always the same (SHA-256, version 8 of RFC 9562),
// in small letters.
[[nodiscard]] std::string guid_of(std::string_view name);

// bcf.version, project.bcfp, and in the topic's folder markup.bcf and of each picture that says
// from where it is seen a viewpoint (metres, z up: bcf_viewpoint.h) with its snapshot. Without one
// there is a viewpoint from (+x +y +z) and no snapshot. No component is selected: designs carry no
// IFC GUIDs. Source: buildingSMART BCF-XML 2.1.
[[nodiscard]] std::vector<ZipEntry> bcf_entries(const NcrDocument& document);

// The bytes of NUMBER.bcfzip.
[[nodiscard]] Result<std::string> ncr_bcf(const NcrDocument& document);

}  // namespace spool::ncr
