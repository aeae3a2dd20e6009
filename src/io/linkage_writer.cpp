#include "json_writer.hpp"
#include "linkwright/io/linkage_file.hpp"
#include "linkwright/io/problem_file.hpp"
#include "problem_writer.hpp"

namespace linkwright {
std::string write_linkage(const StoredLinkage& linkage) {
  std::string text;
  {
    JsonWriter json([&text](std::string_view piece) { text += piece; });
    json.begin_object();
    json.member("linkwright", file_version);
    json.member("title", std::string_view(linkage.title));
    json.member("length_unit", std::string_view(linkage.length_unit));
    json.key("poses");
    json.begin_list();
    for (const PrescribedPose& pose : linkage.poses) write_pose(json, pose);
    json.end_list();
    json.key("linkage");
    if (linkage.record.empty()) {
      json.begin_object();
      json.key("pivots");
      write_pivots(json, linkage.four_bar);
      json.end_object();
    } else {
      json.json(linkage.record);
    }
    json.end_object();
  }
  return text;
}

}  // namespace linkwright
