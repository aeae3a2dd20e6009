#include "five_point_four_bars.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"

namespace linkwright {
namespace {

constexpr std::size_t size = FivePointSystem::size;
using Task = FivePointSystem::Task;
using Unknowns = ComplexVector<size>;

/// Numbers of a task at a t and how they change.
struct Moving {
  Point now, change;

  Moving(Point from, Point to, double t) : now(from + t * (to - from)), change(to - from) {}
};

/// |d + xT − a|² = |x − a|² as P (T − 1) + Q (1/T − 1) + R = 0, for a link with the fixed pivot a and the moving pivot
/// x; capitals: conjugates.
struct LinkRow {
  Point p, q, r, p_change, q_change, r_change;
  Point p_by_x, q_by_conjugate, r_by_x, r_by_conjugate;

  LinkRow(Point x, Point x_conjugate, const Moving& a, const Moving& a_conjugate, const Moving& d,
          const Moving& d_conjugate) {
    p_by_x = a_conjugate.now - d_conjugate.now;
    q_by_conjugate = a.now - d.now;
    r_by_x = -d_conjugate.now;
    r_by_conjugate = -d.now;
    p = p_by_x * x;
    q = q_by_conjugate * x_conjugate;
    r = d.now * (a_conjugate.now - x_conjugate) + d_conjugate.now * (a.now - x) - d.now * d_conjugate.now;
    p_change = (a_conjugate.change - d_conjugate.change) * x;
    q_change = (a.change - d.change) * x_conjugate;
    r_change = d.change * (a_conjugate.now - x_conjugate - d_conjugate.now) + d.now * a_conjugate.change +
               d_conjugate.change * (a.now - x - d.now) + d_conjugate.now * a.change;
  }
};

}  // namespace

// T is eliminated from both links' rows by Cramer's rule: (N + Δ)(M + Δ) = Δ².
SystemAt<size> FivePointSystem::operator()(const Unknowns& z, double t) const {
  const Moving a(from.input, to.input, t), a_conjugate(from.input_conjugate, to.input_conjugate, t);
  const Moving b(from.output, to.output, t), b_conjugate(from.output_conjugate, to.output_conjugate, t);
  SystemAt<size> at;
  for (std::size_t j = 0; j < size; ++j) {
    const Moving d(from.place[j], to.place[j], t), d_conjugate(from.place_conjugate[j], to.place_conjugate[j], t);
    const LinkRow e(z[0], z[1], a, a_conjugate, d, d_conjugate), f(z[2], z[3], b, b_conjugate, d, d_conjugate);
    const Point delta = e.p * f.q - e.q * f.p, n = e.q * f.r - e.r * f.q, m = e.r * f.p - e.p * f.r;
    const Point alpha = m + delta, beta = n + delta, kappa = n + m;
    at.value[j] = n * m + kappa * delta;
    const Point by_ep = kappa * f.q - beta * f.r, by_eq = alpha * f.r - kappa * f.p, by_er = beta * f.p - alpha * f.q;
    const Point by_fp = beta * e.r - kappa * e.q, by_fq = kappa * e.p - alpha * e.r, by_fr = alpha * e.q - beta * e.p;
    at.by_unknown[j] = {by_ep * e.p_by_x + by_er * e.r_by_x, by_eq * e.q_by_conjugate + by_er * e.r_by_conjugate,
                        by_fp * f.p_by_x + by_fr * f.r_by_x, by_fq * f.q_by_conjugate + by_fr * f.r_by_conjugate};
    at.by_t[j] = by_ep * e.p_change + by_eq * e.q_change + by_er * e.r_change + by_fp * f.p_change +
                 by_fq * f.q_change + by_fr * f.r_change;
  }
  return at;
}

namespace {

/// The task with all numbers turned and scaled by two factors, which turns and scales its solutions alike: of no
/// special kind even where the places are real.
Task turned(const Task& task, Point factor, Point of_conjugates) {
  Task turned = task;
  turned.input *= factor;
  turned.output *= factor;
  turned.input_conjugate *= of_conjugates;
  turned.output_conjugate *= of_conjugates;
  for (Point& place : turned.place) place *= factor;
  for (Point& place : turned.place_conjugate) place *= of_conjugates;
  return turned;
}

Task real_task(const std::array<Point, 5>& places, Point input, Point output, double unit) {
  Task task;
  task.input = (input - places[0]) / unit;
  task.output = (output - places[0]) / unit;
  task.input_conjugate = std::conj(task.input);
  task.output_conjugate = std::conj(task.output);
  for (std::size_t j = 0; j < size; ++j) {
    task.place[j] = (places[j + 1] - places[0]) / unit;
    task.place_conjugate[j] = std::conj(task.place[j]);
  }
  return task;
}

double size_of(const std::array<Point, 5>& places, Point input, Point output) {
  double squares = std::norm(input - places[0]) + std::norm(output - places[0]);
  for (const Point place : places) squares += std::norm(place - places[0]);
  return std::sqrt(squares / 6);
}

constexpr double same_solution = 1e-6;

bool are_same(const Unknowns& a, const Unknowns& b) {
  Unknowns difference = a;
  for (std::size_t i = 0; i < size; ++i) difference[i] -= b[i];
  return relative_step(difference, a) < same_solution;
}

/// The system vanishes also where both links are one, or one of them, or the coupler, has no length.
bool is_four_bar(const Unknowns& z, const Task& task) {
  constexpr double least = 1e-8;
  const std::array<Point, 10> lengths = {z[0],
                                         z[1],
                                         z[2],
                                         z[3],
                                         z[0] - z[2],
                                         z[1] - z[3],
                                         z[0] - task.input,
                                         z[1] - task.input_conjugate,
                                         z[2] - task.output,
                                         z[3] - task.output_conjugate};
  return std::all_of(lengths.begin(), lengths.end(), [](Point length) { return std::abs(length) > least; });
}

/// Ends of all paths by one way, those that are not there yet.
void add_ends(const Task& task, double way, const TrackLimits& limits, std::vector<Unknowns>& ends) {
  const Point factor = direction(way), of_conjugates = direction(2.3 * way + 1);
  const FivePointStart& start = five_point_start();
  const FivePointSystem system{start.task, turned(task, factor, of_conjugates)}, straight{task, task};
  std::vector<std::optional<Unknowns>> reached(start.solutions.size());
  parallel_for(reached.size(), 0, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) reached[i] = followed(start.solutions[i], system, limits);
  });
  for (std::optional<Unknowns>& end : reached) {
    if (!end) continue;
    for (std::size_t i = 0; i < size; ++i) (*end)[i] /= i % 2 == 0 ? factor : of_conjugates;
    if (polish(*end, straight, 1) > same_solution || !is_four_bar(*end, task)) continue;
    if (std::none_of(ends.begin(), ends.end(), [&](const Unknowns& known) { return are_same(known, *end); }))
      ends.push_back(*end);
  }
}

/// e^{iθ} of the coupler from the first place to another.
Point turn_at(const Unknowns& z, const Task& task, std::size_t j) {
  const auto still = [](Point p) { return Moving(p, p, 0); };
  const Moving d = still(task.place[j]), d_conjugate = still(task.place_conjugate[j]);
  const LinkRow e(z[0], z[1], still(task.input), still(task.input_conjugate), d, d_conjugate);
  const LinkRow f(z[2], z[3], still(task.output), still(task.output_conjugate), d, d_conjugate);
  const Point turn = 1.0 + (e.q * f.r - e.r * f.q) / (e.p * f.q - e.q * f.p);
  return turn / std::abs(turn);
}

/// The solution in which conjugates are what they are called; nothing where it is another.
std::optional<Unknowns> real_one(Unknowns z, const Task& task) {
  const Unknowns mirrored = {std::conj(z[1]), std::conj(z[0]), std::conj(z[3]), std::conj(z[2])};
  if (!are_same(z, mirrored)) return std::nullopt;
  for (std::size_t i = 0; i < size; ++i) z[i] = 0.5 * (z[i] + mirrored[i]);
  const FivePointSystem straight{task, task};
  polish(z, straight, 1);
  return z;
}

}  // namespace

FivePointFourBars five_point_four_bars(const std::array<Point, 5>& places, Point input, Point output) {
  const double unit = size_of(places, input, output);
  const Task task = real_task(places, input, output, unit);
  std::vector<Unknowns> ends;
  TrackLimits limits;
  for (const double way : {0.7, 2.9, 4.4}) {
    add_ends(task, way, limits, ends);
    if (ends.size() >= FivePointSystem::solutions) break;
    limits.predicted /= 10;
    limits.shortest_step /= 1e3;
  }
  FivePointFourBars found;
  found.ends = static_cast<int>(ends.size());
  for (const Unknowns& end : ends) {
    const auto z = real_one(end, task);
    if (!z) continue;
    FivePointFourBar one{{input, places[0] + unit * (*z)[0], output, places[0] + unit * (*z)[2]}, {}};
    one.input_moving[0] = one.bars.input_moving;
    for (std::size_t j = 0; j < size; ++j)
      one.input_moving[j + 1] = places[j + 1] + unit * turn_at(*z, task, j) * (*z)[0];
    found.real.push_back(one);
  }
  std::sort(found.real.begin(), found.real.end(), [](const FivePointFourBar& a, const FivePointFourBar& b) {
    return std::pair(a.bars.input_moving.real(), a.bars.input_moving.imag()) <
           std::pair(b.bars.input_moving.real(), b.bars.input_moving.imag());
  });
  return found;
}

}  // namespace linkwright
