#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fields/field_visitor.hpp"
#include "files/json/json_writer.hpp"
#include "linkwright/algebra/point.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/loads/load_report.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/machine/machine.hpp"
#include "linkwright/solve/session.hpp"

// What the page gets as JSON text, told once: the replies write it, and the page's types describe it
// (tests/bindings/contract_test.cpp makes web/src/contract/replies.ts).
namespace linkwright::wasm {

/// With the numbers and words of its sentence, which the page words anew.
struct WordedNotice {
  Notice notice;
};
void fields(FieldVisitor& v, const WordedNotice& of);
[[nodiscard]] std::vector<WordedNotice> worded(const std::vector<Notice>& notices);
/// A mistake of the caller's, and where it is.
struct WordedMistake {
  Error mistake;
};
void fields(FieldVisitor& v, const WordedMistake& of);
/// A list of them.
[[nodiscard]] std::string mistakes_json(const std::vector<Error>& mistakes);
/// {"mistakes": […]}: in place of a reply.
[[nodiscard]] std::string refusal_json(const std::vector<Error>& mistakes);

// ---- the task -----------------------------------------------------------------------------------------------------

/// Points and directions of the asymptotes of the two curves.
struct Asymptotes {
  std::optional<std::array<Point, 2>> center, circle;
};
/// Curves of dyads, or what the dyads of the input lie along instead.
struct CurvesReply {
  std::string kind;  ///< of the circle points, or an axis quantity
  std::optional<std::string> center_kind;
  std::optional<double> kappa;
  std::optional<Asymptotes> asymptotes;
};
/// The pairs, and the named function between them; degrees.
struct FunctionReply {
  std::vector<std::array<double, 2>> pairs, curve;
};
/// After a map was asked for, without its arrays.
struct TaskReply {
  const Findings& known;
  const ShownAxes& axes;
  const LinkageClass& linkages;
  SolutionStatus status = SolutionStatus::solved;
  std::optional<WordedNotice> reason{};
  CurvesReply curves{};
  std::vector<CurveMark> marks{};
  std::optional<FunctionReply> function{};
};
void fields(FieldVisitor& v, const TaskReply& of);

struct CensusReply {
  const ColouredMap& map;
};
void fields(FieldVisitor& v, const CensusReply& of);

// ---- a linkage ----------------------------------------------------------------------------------------------------

/// How a four-bar is driven, where the object of the result file does not say it.
struct DriverReply {
  DefectReport report;
};
void fields(FieldVisitor& v, const DriverReply& of);
/// A row to each state of a drive, nothing at a dead point.
struct RatesReply {
  std::vector<std::string> bodies;
  std::vector<std::optional<std::vector<double>>> rows;
};
/// One of several linkages at a place of a map.
struct LayerReply {
  MapPoint place;  ///< in its layer
  std::string elbows;
  LinkageType type = LinkageType::degenerate;
  bool meets = false;
};
void fields(FieldVisitor& v, const LayerReply& of);
/// What only the page shows of a linkage, by its kind.
struct LinkageMore {
  /// Grounded links, where they make no linkage, too: as `dyad` or `spherical_dyad` of result files.
  std::optional<std::array<KeptVisit, 2>> links{};
  std::optional<double> miss_input_deg{};
  std::optional<std::vector<std::array<double, 2>>> pairs_deg{};
  std::optional<bool> reaches_pairs{};
  std::optional<double> min_link_angle_deg{};
  std::optional<std::vector<std::vector<int>>> bodies{};
  std::optional<DriverReply> driven{}, swapped{};
  std::optional<double> strip_middle{};
  std::optional<std::vector<std::array<std::optional<double>, 4>>> profile{};
  std::optional<RatesReply> rates{};
  std::optional<std::vector<LayerReply>> layers{};
};
/// A linkage at a place: the object of the result file (empty for none), what else the page shows, and its drive
/// without the states.
struct PlacedLinkage {
  const PickedLinkage& picked;
  std::string record{};
  LinkageMore more{};
  int state_width = 0;
};
void fields(FieldVisitor& v, const PlacedLinkage& of);

/// One of the best.
struct RankedLinkage {
  MapPoint place;
  std::string record{};
  std::optional<double> near_error{};  ///< where it is to come near: what is least of it, user's unit
  std::vector<Point> path{};           ///< of its point, all round, to be drawn small; empty: it has none
  std::optional<double> min_link_angle_deg{};
  std::optional<ThreeLinkChain> chain{};  ///< of six-bars
  // Of straight lines:
  std::optional<double> deviation{};  ///< infinite where the point does not go as far as the stroke
  std::optional<std::optional<MapWindow>> window{};
};
void fields(FieldVisitor& v, const RankedLinkage& of);
struct BestReply {
  std::vector<RankedLinkage> linkages;
  std::vector<WordedNotice> notices;
};
void fields(FieldVisitor& v, const BestReply& of);

struct ImprovedReply {
  MapPoint place;
  bool improved = false;
};
void fields(FieldVisitor& v, const ImprovedReply& of);
struct VerifiedReply {
  Verification found;
};
void fields(FieldVisitor& v, const VerifiedReply& of);

// ---- fits ---------------------------------------------------------------------------------------------------------

struct FitSearchReply {
  std::optional<double> usual_rms;  ///< by the problem's own effort
  FitSearch search;
};
void fields(FieldVisitor& v, const FitSearchReply& of);

// ---- tolerances ---------------------------------------------------------------------------------------------------

struct YieldsReply {
  SampledYields yields;
};
void fields(FieldVisitor& v, const YieldsReply& of);
struct FrontReply {
  std::vector<std::array<double, 4>> cells;  ///< row, column, and both objectives as they are read
};
void fields(FieldVisitor& v, const FrontReply& of);
struct Histograms {
  double from = 0, to = 0;
  std::vector<std::vector<std::int64_t>> counts;
};
struct ToleranceFigures {
  KeptVisit report;  ///< as `tolerance` of result files
  Histograms histograms;
  std::int64_t positions = 0;
};
void fields(FieldVisitor& v, const ToleranceFigures& of);

// ---- loads --------------------------------------------------------------------------------------------------------

/// The curves of one case, a value a station.
struct LoadCurve {
  std::string name;
  const std::vector<LoadStation>* stations = nullptr;
};
struct LoadFigures {
  KeptVisit report;  ///< as `loads` of result files
  std::vector<LoadCurve> curves;
  Loads loads;
};
void fields(FieldVisitor& v, const LoadFigures& of);
struct StudMapReply {
  int columns = 0, rows = 0;
  std::vector<std::optional<double>> force;
};
void fields(FieldVisitor& v, const StudMapReply& of);

// ---- plates -------------------------------------------------------------------------------------------------------

/// What runs into what, at driver angles from position 1, positive as the positions are met.
struct CrossingReply {
  std::string body;
  std::optional<std::string> pin{}, other{};
  double from_deg = 0, to_deg = 0;
};
struct PlateLayer {
  std::string body;
  int layer = 0;
};
struct PartReply {
  std::string name, body;
  int triangles = 0;
};
struct MachinePlan {
  PlateSizes sizes{};
  std::vector<PlateLayer> layers{};
  PlateLayers::Over over = PlateLayers::Over::travel;
  std::vector<CrossingReply> crossings{};
  std::string guided{};
  double at_deg = 0;
  std::vector<PartReply> parts{};
};
void fields(FieldVisitor& v, const MachinePlan& of);

// ---- drawings of other programs -----------------------------------------------------------------------------------

struct OutlineShape {
  std::vector<Point> outline{};
  bool closed = false, frame = false;
  double width = 0, height = 0;
};
struct OutlinesReply {
  std::vector<OutlineShape> shapes{};
};
void fields(FieldVisitor& v, const OutlinesReply& of);

/// JSON text.
template <class Reply>
[[nodiscard]] std::string text_of(const Reply& reply) {
  return json_text_of([&](JsonWriter& json) { write_reply(json, [&](FieldVisitor& v) { fields(v, reply); }); });
}
void write_reply(JsonWriter& json, Visit reply);

}  // namespace linkwright::wasm
