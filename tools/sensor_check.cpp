// spoolsight-inspect --sensor-check: a view of a flat floor or wall in, sensor.json out.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "tools/sensor_check.h"

#include <filesystem>
#include <iostream>
#include <optional>

#include "app/common/json_file.h"
#include "app/evidence/sensor_check_files.h"
#include "vision/core/file_io.h"

namespace spool::tools {

Result<int> run_sensor_check(const InspectOptions& options, const std::string& created) {
  std::optional<Calibration> known;
  if (!options.calibration.empty()) {
    const auto read = read_calibration(options.calibration);
    if (!read) return read.error();
    known = *read;
  }
  const auto record = evidence::check_sensor(options.sensor_check, known, created);
  if (!record) return record.error();
  const std::filesystem::path folder = options.out;
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  if (code)
    return Error{ErrorCode::kIo, options.out + ": cannot be made (" + code.message() +
                                     "); name a folder that can be written"};
  if (const Status status =
          write_file_whole(folder / "sensor.json", evidence::sensor_json(*record));
      !status)
    return status.error();
  std::cout << evidence::sensor_text(*record) << "written to " << (folder / "sensor.json").string()
            << "; --calibration takes it\n";
  return 0;
}

}  // namespace spool::tools
