#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/machine/machine.hpp"
#include "linkwright/solve/halo.hpp"
#include "linkwright/solve/session.hpp"
#include "replies.hpp"
#include "reply_fields.hpp"

namespace linkwright::wasm {

/// Views are valid until the session is asked again.
struct ExploreReply {
  std::string task, census;  ///< JSON text; no census: there is no map
  const LinkPolygon* input_curves = nullptr;
  const LinkPolygon* output_curves = nullptr;  ///< none: the same
  const ColouredMap* map = nullptr;
};

/// The engine of the page: reads its problems and words the answers of a Session. Where the task of a problem is a
/// linkage (opened_linkage()) only read(), linkage(), trace(), exported() and the machine are to be asked, at any
/// place. The requests of web/src/contract/messages.ts, without the browser.
class PageSession {
 public:
  /// Reads a problem file; false where it has mistakes, and then the last good problem stays.
  bool set_problem(std::string_view text);
  /// Those of the last set_problem() or read(): JSON text of a list.
  [[nodiscard]] const std::string& mistakes() const { return mistakes_; }
  /// The normal form of a problem file, poses in numbers; empty where it has mistakes.
  [[nodiscard]] std::string read(std::string_view text);
  /// What to know of the file read last, as JSON text.
  [[nodiscard]] const std::string& notices() const { return notices_; }

  [[nodiscard]] ExploreReply explore(const MapRequest& request);
  [[nodiscard]] LinkageReply linkage(MapPoint place);
  [[nodiscard]] LiveLinks live(MapPoint place) { return opened_ ? LiveLinks{} : asked().live(place); }
  /// Cells that pass, row-major [dy][dx], or by turn.
  [[nodiscard]] std::vector<std::uint32_t> halo(const HaloRequest& request);
  /// JSON text: the objects of `best`, `improve` and `verify`.
  [[nodiscard]] std::string best(int most) { return best_reply(asked(), most); }
  [[nodiscard]] std::string improve(MapPoint place);
  [[nodiscard]] std::string verify(MapPoint place);
  /// By all samples, with histograms of so many bins and so many samples to be drawn; empty without tolerances and at a
  /// dead point.
  [[nodiscard]] ToleranceReply tolerance(MapPoint place, int bins, int drawn);
  /// JSON text: the forces in a linkage and their curves; empty without loads, and where it does not get through its
  /// positions in order.
  [[nodiscard]] std::string loads(MapPoint place);
  /// JSON text, as place_spring_reply() and stud_map_reply(); empty where loads() is.
  [[nodiscard]] std::string place_spring(MapPoint place, std::string_view boxes, std::size_t most_boxes);
  [[nodiscard]] std::string stud_map(MapPoint place, std::string_view boxes, Stud over, int columns, int rows);
  /// Samples the yields of so many more cells of the map shown last. JSON text: `{"done", "total"}`.
  [[nodiscard]] std::string sample_yields(int cells);
  /// Objectives by their names. JSON text: `{"front": [[row, column, value, value] …]}`, values as they are read.
  [[nodiscard]] std::string front(std::string_view first, std::string_view second);
  [[nodiscard]] std::vector<Point> trace(MapPoint place, Point traced);
  /// A file: svg, dxf, csv, json or result. Empty where there is no linkage to write.
  [[nodiscard]] std::string exported(MapPoint place, std::string_view format);
  /// A linkage as plates and pins, to be looked at before it is made.
  [[nodiscard]] MachineReply machine(MapPoint place, const WantedSizes& sizes);
  /// The bytes of a file to make it from: stl, 3mf or plates, or for a simulator: urdf, sdf or mjcf. Errors:
  /// `no_four_bar`, those of machine(), write_parts() and simulator_text().
  [[nodiscard]] Result<std::string> machine_file(MapPoint place, std::string_view format, const WantedSizes& sizes);

 private:
  /// Of a linkage that loads act on.
  [[nodiscard]] std::optional<LinkageLoads> loads_at(MapPoint place);
  /// False where there are any.
  template <class Read>
  bool note_mistakes(const Result<Read>& read) {
    mistakes_ = read ? "[]" : mistakes_json(read.errors());
    return read.ok();
  }
  /// A problem is set before anything is asked.
  [[nodiscard]] Session& asked() { return session_.value(); }
  [[nodiscard]] std::optional<AnyStoredLinkage> linkage_at(MapPoint place);
  [[nodiscard]] Result<Machine> machine_at(MapPoint place, const WantedSizes& sizes);

  std::string text_, mistakes_ = "[]", notices_ = "[]";
  std::optional<Session> session_;          ///< none before the first problem
  std::optional<AnyStoredLinkage> opened_;  ///< the problem's task is this linkage; then nothing is asked of session_
};

}  // namespace linkwright::wasm
