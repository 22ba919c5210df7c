// The report as BCF 2.1, which model checkers open: one topic with its viewpoints and pictures.
// SPDX-FileCopyrightText: SpoolSight contributors
// SPDX-License-Identifier: Apache-2.0
#include "app/ncr/ncr_bcf.h"

#include <filesystem>

#include <fmt/format.h>

#include "app/evidence/html_parts.h"
#include "app/ncr/bcf_viewpoint.h"
#include "vision/core/file_digest.h"

namespace spool::ncr {
namespace {

constexpr std::string_view kHead = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

// Text of an element; line ends stay.
std::string xml(const std::string& text) {
  std::string all;
  std::size_t at = 0;
  for (auto end = text.find('\n'); end != std::string::npos; end = text.find('\n', at)) {
    all += evidence::escaped(text.substr(at, end - at)) + "\n";
    at = end + 1;
  }
  return all + evidence::escaped(text.substr(at));
}

std::string element(const char* name, const std::string& text) {
  return fmt::format("<{0}>{1}</{0}>", name, xml(text));
}

std::string vector(const char* name, const Eigen::Vector3d& value) {
  return fmt::format("<{0}><X>{1:.9g}</X><Y>{2:.9g}</Y><Z>{3:.9g}</Z></{0}>", name, value.x(),
                     value.y(), value.z());
}

std::string viewpoint(const std::string& guid, const BcfCamera& camera) {
  return std::string(kHead) + "<VisualizationInfo Guid=\"" + guid + "\"><PerspectiveCamera>" +
         vector("CameraViewPoint", camera.view_point) +
         vector("CameraDirection", camera.direction) + vector("CameraUpVector", camera.up) +
         fmt::format("<FieldOfView>{:g}</FieldOfView>", kFieldOfView_deg) +
         "</PerspectiveCamera></VisualizationInfo>\n";
}

struct View {
  std::string guid, file, snapshot, caption;
};

std::string markup(const NcrDocument& document, const std::string& topic,
                   const std::vector<View>& views) {
  const std::string author = document.operator_name.empty() ? "not named" : document.operator_name;
  const FormField* description = field(document.form, "description.text");
  std::string text =
      std::string(kHead) + "<Markup><Header><File isExternal=\"true\">" +
      element("Filename",
              std::filesystem::path(document.evidence.design_file).filename().string()) +
      "</File></Header><Topic Guid=\"" + topic +
      "\" TopicType=\"Non-conformance\" TopicStatus=\"Open\">";
  std::string title = document.number;
  if (!document.spool.empty()) title += ", spool " + document.spool;
  text += element("Title", title) + element("CreationDate", document.created) +
          element("CreationAuthor", author);
  if (description != nullptr && !description->value.empty())
    text += element("Description", description->value);
  text += "</Topic>";
  for (const View& each : views) {
    std::string words = document.number + ": " + document.evidence.status_reason;
    if (!each.caption.empty()) words += "\nPicture " + each.caption + ".";
    text += "<Comment Guid=\"" + guid_of(document.number + "/comment/" + each.file) + "\">" +
            element("Date", document.created) + element("Author", author) +
            element("Comment", words) + "<Viewpoint Guid=\"" + each.guid + "\"/></Comment>";
  }
  int index = 0;
  for (const View& each : views) {
    text += "<Viewpoints Guid=\"" + each.guid + "\">" + element("Viewpoint", each.file);
    if (!each.snapshot.empty()) text += element("Snapshot", each.snapshot);
    text += fmt::format("<Index>{}</Index></Viewpoints>", index++);
  }
  return text + "</Markup>\n";
}

}  // namespace

std::string guid_of(std::string_view name) {
  std::string hash = sha256_hex(std::string("spoolsight/") + std::string(name)).substr(0, 32);
  hash[12] = '8';                                               // version
  hash[16] = "89ab"[static_cast<unsigned char>(hash[16]) % 4];  // variant
  return hash.substr(0, 8) + "-" + hash.substr(8, 4) + "-" + hash.substr(12, 4) + "-" +
         hash.substr(16, 4) + "-" + hash.substr(20);
}

std::vector<ZipEntry> bcf_entries(const NcrDocument& document) {
  const std::string topic = guid_of(document.number);
  std::vector<ZipEntry> entries;
  const FormField* job = field(document.form, "head.job_no");
  const std::string project = job == nullptr ? "" : job->value;
  entries.push_back({"bcf.version", std::string(kHead) +
                                        "<Version VersionId=\"2.1\"><DetailedVersion>2.1"
                                        "</DetailedVersion></Version>\n"});
  entries.push_back(
      {"project.bcfp", std::string(kHead) + "<ProjectExtension><Project ProjectId=\"" +
                           guid_of("project/" + project) + "\">" + element("Name", project) +
                           "</Project><ExtensionSchema></ExtensionSchema>"
                           "</ProjectExtension>\n"});
  std::vector<View> views;
  std::vector<ZipEntry> files;
  const auto add = [&](const Eigen::Vector3d& side, const std::string& caption,
                       const std::string* png) {
    const std::string end = views.empty() ? "" : "_" + std::to_string(views.size() + 1);
    View view{guid_of(document.number + "/viewpoint" + end), "viewpoint" + end + ".bcfv",
              png == nullptr ? "" : "snapshot" + end + ".png", caption};
    files.push_back(
        {topic + "/" + view.file, viewpoint(view.guid, camera_at(document.bounds, side))});
    if (png != nullptr) files.push_back({topic + "/" + view.snapshot, *png});
    views.push_back(std::move(view));
  };
  for (const Picture& each : document.evidence.pictures)
    if (const auto side = eye_side(each.caption)) add(*side, each.caption, &each.png);
  if (views.empty()) add(Eigen::Vector3d(1, 1, 1).normalized(), "", nullptr);
  entries.push_back({topic + "/markup.bcf", markup(document, topic, views)});
  entries.insert(entries.end(), files.begin(), files.end());
  return entries;
}

Result<std::string> ncr_bcf(const NcrDocument& document) {
  return zip_bytes(bcf_entries(document));
}

}  // namespace spool::ncr
