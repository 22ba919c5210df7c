// What every campaign is asked for on its command line: which rows, which seeds, how much is said.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "app/common/cli.h"

namespace spool::campaign {

struct CampaignOptions {
  std::string filter;  // rows whose name holds it
  int seeds = 3, first = 1;
  bool each = false;  // a line for each scene, or frame

  [[nodiscard]] bool wants(const std::string& row) const {
    return row.find(filter) != std::string::npos;
  }
  [[nodiscard]] int past_last() const { return first + seeds; }
};

// --rows, --seeds, --first and --each, whose defaults are what `options` holds. `each_of`: what
// --each gives a line for.
inline void add_campaign_options(CLI::App& app, const std::string& each_of,
                                 CampaignOptions& options) {
  app.add_option("--rows", options.filter, "Only rows whose name holds this text")
      ->type_name("TEXT");
  app.add_option("--seeds", options.seeds, "Seeds of each row")
      ->capture_default_str()
      ->type_name("N");
  app.add_option("--first", options.first, "First seed")->capture_default_str()->type_name("N");
  app.add_flag("--each", options.each, "A line for each " + each_of);
}

// The main() of a campaign that is asked for no more than that.
template <class Campaign>
int campaign_main(int argc, char** argv, const char* program, const char* about,
                  const std::string& each_of, const Campaign& campaign,
                  CampaignOptions wanted = {}) {
  CLI::App app{about};
  add_common_options(app, program);
  add_campaign_options(app, each_of, wanted);
  return run_program(app, argc, argv, [&] { return campaign(wanted); });
}

}  // namespace spool::campaign
