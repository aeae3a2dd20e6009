#include "session.hpp"

#include <algorithm>
#include <cmath>

#include "linkage_reply.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/io/csv_table.hpp"
#include "linkwright/io/dxf_drawing.hpp"
#include "linkwright/io/result_file.hpp"
#include "linkwright/io/svg_drawing.hpp"
#include "linkwright/planar/improved_linkage.hpp"
#include "linkwright/planar/pose_halo.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

// Of poses and of their derivatives.
template <class Moving>
bool same(const Moving& a, const Moving& b) {
  return a.origin == b.origin && a.angle == b.angle;
}

bool same_poses(const MotionTask& a, const MotionTask& b) {
  return std::equal(a.poses.begin(), a.poses.end(), b.poses.begin(), b.poses.end(),
                    [](const PrescribedPose& p, const PrescribedPose& q) {
                      return same(p.pose, q.pose) &&
                             std::equal(p.derivatives.begin(), p.derivatives.end(), q.derivatives.begin(),
                                        q.derivatives.end(), same<PoseDerivative>);
                    });
}

constexpr std::array<double, 2> whole = {0, 1};

const Notice no_pair = {
    "no_pair",
    "No pair of side links makes a four-bar: in every pair a pivot is at infinity or a link has no length.",
    {}};

}  // namespace

bool Session::set_problem(std::string_view text) {
  if (given_ && text == text_) return true;
  auto read = read_problem(text);
  mistakes_ = read ? "[]" : mistakes_json(read.errors());
  if (!read) return false;
  text_ = text;
  const bool unchanged = given_ && same_poses(problem_.task, read->task);
  problem_ = std::move(*read);
  if (!unchanged) {
    given_ = task_curve(problem_.task);
    drawn_.reset();
    mapped_.reset();
  }
  requirements_ = problem_.requirements;
  if (!requirements_.max_length) requirements_.max_length = default_max_length * given().conditions.frame.scale;
  return true;
}

std::string Session::read(std::string_view text) {
  const auto problem = read_problem(text);
  mistakes_ = problem ? "[]" : mistakes_json(problem.errors());
  return problem ? write_problem(*problem) : "";
}

const TaskCurve& Session::given() const {
  if (!given_) std::abort();  // a problem is set before anything is asked
  return *given_;
}

const DisplayOrder& Session::order() const {
  if (!order_) std::abort();  // an axis is ordered before a map is made
  return *order_;
}

bool Session::has_dyads() const { return given().curve->coordinate_length() > 0; }

Dyad Session::dyad(double tau) const { return given().curve->dyad(tau); }

RegionAxis Session::axis(const std::vector<double>& tau) const {
  std::vector<Dyad> dyads;
  for (const double t : tau) dyads.push_back(dyad(t));
  return {std::move(dyads), given().conditions.frame.to_working(problem_.task.poses), requirements_.respect_direction};
}

const DrawnCurves& Session::drawn() {
  if (!drawn_) drawn_ = drawn_curves(problem_.task, given());
  return *drawn_;
}

void Session::order_axes(const ExploreRequest& request) {
  const WorkingFrame& frame = given().conditions.frame;
  const BurmesterCurve& curve = *given().curve;
  const Spacing spacing = problem_.options.spacing;
  const bool follow = request.order == ExploreRequest::nearest_order;
  order_ = follow && order_ ? DisplayOrder::nearest(curve, spacing, frame, *order_)
                            : DisplayOrder(curve, spacing, frame, std::max(request.order, 0));
}

void Session::compute_map(const ExploreRequest& request) {
  const MapKey wanted{request.samples, order().code(),           request.input,
                      request.output,  problem_.options.spacing, requirements_.respect_direction};
  const WorkingFrame& frame = given().conditions.frame;
  if (mapped_ != wanted) {
    const auto samples = [&](const std::array<double, 2>& part) {
      return part == whole ? order().samples(*given().curve, request.samples)
                           : order().samples(request.samples, part[0], part[1]);
    };
    input_tau_ = samples(request.input);
    output_tau_ = request.output == request.input ? input_tau_ : samples(request.output);
    const RegionAxis input = axis(input_tau_);
    if (request.output == request.input)
      map_.classify(input, input, frame.scale);
    else
      map_.classify(input, axis(output_tau_), frame.scale);
    mapped_ = wanted;
  }
  map_.judge(requirements_, frame.origin, frame.scale);
  map_.measure(request.property);
}

ExploreReply Session::explore(const ExploreRequest& request) {
  order_axes(request);
  ExploreReply reply;
  reply.curves = &drawn();
  std::string_view status = "solved";
  const Notice* reason = nullptr;
  if (const auto& degeneracy = given().degeneracy) {
    status = "degenerate";
    reason = &*degeneracy;
  } else {
    compute_map(request);
    reply.map = &map_;
    reply.census = map_.census_json();
    reply.input_tau = input_tau_;
    reply.output_tau = output_tau_;
    const RegionCounts& counts = map_.counts();
    if (counts.pairs == counts.types[static_cast<std::size_t>(LinkageType::degenerate)] && request.input == whole &&
        request.output == whole) {
      status = "no_solution";
      reason = &no_pair;
    }
  }
  reply.task = task_json(given(), *reply.curves, order(), requirements_, status, reason);
  return reply;
}

LinkageReply Session::linkage(double input_tau, double output_tau) {
  LinkageReply reply;
  if (!has_dyads()) return reply;
  const WorkingFrame& frame = given().conditions.frame;
  const Dyad input = dyad(input_tau), output = dyad(output_tau);
  PickedLinkage picked = picked_linkage(problem_.task, given(), input, output, requirements_.respect_direction);
  // By the map's own kernel, so that the card and the cell agree to the last bit.
  cell_.recompute(axis({input_tau}), axis({output_tau}), frame.scale);
  picked.fails = RequirementFilter(cell_, requirements_, frame.origin, frame.scale).failures(0, 0);
  reply.linkage = linkage_json(picked, frame);
  append_states(picked, reply.states);
  return reply;
}

LiveReply Session::live(double input_tau, double output_tau) {
  LiveReply reply;
  if (!has_dyads()) return reply;
  const WorkingFrame& frame = given().conditions.frame;
  const RegionAxis sliding = axis(drawn().tau);
  const auto fails = [&](const RegionAxis& input, const RegionAxis& output) {
    strip_.recompute(input, output, frame.scale);
    std::vector<std::uint8_t> found(strip_.rows() * strip_.columns());
    RequirementFilter(strip_, requirements_, frame.origin, frame.scale).failures_of_all(found);
    return found;
  };
  reply.input = fails(sliding, axis({output_tau}));
  reply.output = fails(axis({input_tau}), sliding);
  return reply;
}

std::vector<std::uint32_t> Session::halo(const HaloRequest& request) const {
  const PoseHalo halo(problem_.task, problem_.requirements, problem_.options.spacing, request.samples);
  const auto pose = static_cast<std::size_t>(request.pose);
  return request.turn ? halo.turned(pose, request.reach, request.steps)
                      : halo.moved(pose, request.reach, request.steps);
}

std::string Session::best(int most) const {
  SynthesisOptions options = problem_.options;
  options.region_samples = 400;
  options.window.reset();
  options.best = most;
  const auto solution = solve_motion(problem_.task, problem_.requirements, options);
  return json_of([&](JsonWriter& json) {
    json.begin_list();
    for (const FourBarSolution& found : solution ? solution->linkages : std::vector<FourBarSolution>{}) {
      json.begin_object(JsonWriter::Layout::one_line);
      json.key("tau");
      write_numbers(json, std::array{found.input.coordinate, found.output.coordinate});
      json.member("type", name(found.report.type));
      json.member("min_transmission_angle_deg", degrees(std::acos(found.report.worst_transmission_cosine)));
      json.member("link_ratio", found.lengths.longest() / found.lengths.shortest());
      json.member("longest", found.lengths.longest());
      json.end_object();
    }
    json.end_list();
  });
}

std::string Session::improve(double input_tau, double output_tau) {
  std::optional<RegionPlace> better;
  if (!given().degeneracy)
    better =
        improved_linkage(problem_.task, given(), requirements_, problem_.options.objective, {input_tau, output_tau});
  return json_of([&](JsonWriter& json) {
    json.begin_object();
    json.key("tau");
    write_numbers(json, better ? std::array{better->input, better->output} : std::array{input_tau, output_tau});
    json.member("improved", better.has_value());
    json.end_object();
  });
}

std::string Session::verify(double input_tau, double output_tau) {
  std::optional<FourBarSolution> driven;
  constexpr bool by_driving = true;
  const WorkingFrame& frame = given().conditions.frame;
  if (has_dyads())
    driven = make_four_bar(problem_.task, frame, frame.to_user(dyad(input_tau)), frame.to_user(dyad(output_tau)),
                           requirements_.respect_direction, by_driving);
  return json_of([&](JsonWriter& json) {
    json.begin_object();
    json.member("verified", driven && driven->verified_by_driving);
    json.member("residual", driven ? std::max(driven->input_residual * driven->lengths.input,
                                              driven->output_residual * driven->lengths.output)
                                   : 0.0);
    json.end_object();
  });
}

std::vector<double> Session::trace(double input_tau, double output_tau, Point traced) {
  std::vector<double> path;
  if (!has_dyads()) return path;
  const PickedLinkage picked =
      picked_linkage(problem_.task, given(), dyad(input_tau), dyad(output_tau), requirements_.respect_direction);
  const Pose& first = problem_.task.poses.front().pose;
  for (const DriveState& state : picked.drive.states) {
    const Point p = displaced(traced, first, state.body);
    path.insert(path.end(), {p.real(), p.imag()});
  }
  return path;
}

std::string Session::exported(double input_tau, double output_tau, std::string_view format) {
  const WorkingFrame& frame = given().conditions.frame;
  if (!has_dyads()) return "";
  constexpr bool verify = true;
  auto found = make_four_bar(problem_.task, frame, frame.to_user(dyad(input_tau)), frame.to_user(dyad(output_tau)),
                             requirements_.respect_direction, verify);
  if (!found) return "";
  MotionSolution solution;
  solution.reason = {"picked", "One linkage, picked on the map.", {}};
  solution.pattern = given().pattern;
  solution.conditions = given().conditions;
  solution.warnings = given().warnings;
  solution.curve = given().curve;
  solution.requirements = requirements_;
  solution.options = problem_.options;
  solution.linkages = {*found};
  std::string result = write_result(problem_, solution, false);
  if (format == "result") return result;
  const auto linkages = read_result_linkages(result);
  if (!linkages || linkages->empty()) return "";
  const StoredLinkage& linkage = linkages->front();
  if (format == "svg") return draw_linkage(linkage);
  if (format == "dxf") return draw_dxf(linkage);
  if (format == "csv") return motion_table(tabulated_motion(linkage.four_bar, traced_point(linkage)));
  return write_linkage(linkage);
}

}  // namespace linkwright::wasm
