// Pages to files: one PDF, or a picture a page.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "app/isometric/page_canvas.h"
#include "vision/core/file_io.h"

namespace spool::isometric {

Result<std::vector<std::string>> write_pages(const Pages& pages, const std::string& title,
                                             const std::string& path) {
  constexpr double kPngDpi = 200;
  const std::filesystem::path file(path);
  std::vector<std::string> written;
  if (file.extension() == ".pdf") {
    const Result<std::string> bytes = draw_pdf(pages, title);
    if (!bytes) return bytes.error();
    if (Status status = write_file_whole(file, *bytes); !status) return status.error();
    written.push_back(path);
    return written;
  }
  if (file.extension() != ".png")
    return Error{ErrorCode::kUsage, path + ": pages are written as .pdf or .png"};
  int number = 0;
  for (const auto& page : pages) {
    const Result<render::Image> image = draw_page(page, kPngDpi);
    if (!image) return image.error();
    std::filesystem::path own = file;
    own.replace_filename(file.stem().string() + "-" + std::to_string(++number) + ".png");
    if (Status status = render::write_png(own, *image); !status) return status.error();
    written.push_back(own.string());
  }
  return written;
}

}  // namespace spool::isometric
