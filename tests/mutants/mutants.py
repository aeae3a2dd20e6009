#!/usr/bin/env python3
"""Mutation test of what is dense with signs: classifiers, straight lines, sensitivities, fits. Every wrong sign must be caught.

Builds a check with copies of a source in which one thing is wrong. The right source must agree everywhere with what the
check knows of it, driving or the series of a motion; each mutant must not.

usage: mutants.py SOURCE_DIR SCRATCH_DIR LIBRARY CXX [FLAG...]   (linker flags among them)

With LINKWRIGHT_ALL_TESTS=1 in the environment every mutant is tried, else one of each subject: which one, the text of the
source decides, so that it is another after a change.

Units whose texts were compiled before come from ccache, where it is installed.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import zlib
from concurrent.futures import ThreadPoolExecutor

PLANAR = [
    ("joint sign at the output", "(driver.arm_y[j] - d.frame_y)", "(driver.arm_y[j] + d.frame_y)"),
    ("joint sign at the input's moving pivot", "(arm_x(j) + d.frame_x)", "(arm_x(j) - d.frame_x)"),
    ("joint sign at the input's fixed pivot", "return d.frame_x * driver.arm_y[j] -", "return d.frame_x * driver.arm_y[j] +"),
    ("first excess", "t1 = gh - ab", "t1 = ab - gh"),
    ("second excess", "t2 = (g + b) - (a + h)", "t2 = (a + h) - (g + b)"),
    ("third excess", "t3 = (h + b) - (g + a)", "t3 = (g + a) - (h + b)"),
    ("types exchanged by their lowest bit", "(s.n2 & s.n3)))", "(s.n2 & s.p3)))"),
    ("types exchanged by their second bit", "(s.n2 & s.p3))", "(s.n2 & s.n3))"),
    ("triple rockers taken for Grashof's", "~(s.p1 ^ s.p2 ^ s.p3)", "(s.p1 ^ s.p2 ^ s.p3)"),
    ("circuit of a crank not looked at", "circuit = s.input_is_crank() & output_changes", "circuit = s.n3 & output_changes"),
    ("circuit of a rocker-crank not looked at", "circuit |= lanes & changes_sign<Width, Poses>([&](int j) { return pairs.at_input_moving(j); });", ";"),
    ("circuit of a double rocker not looked at", "circuit |= lanes & changes_sign<Width, Poses>([&](int j) { return pairs.at_input_fixed(j); });", ";"),
    ("sector test loose", "? in | out : in & out;", "? in | out : in | out;"),
    ("sector test turned", "in_negative = less<Width>(turn_in, Real{})", "in_negative = less<Width>(Real{}, turn_in)"),
    ("passing along the frame always possible", "(passes_0 & ~limits.can_pass_0) |", ""),
    ("passing opposite to the frame always possible", "| (passes_pi & ~limits.can_pass_pi)", ""),
    ("last pose left out of the angle", "std::min(angle_at(0), angle_at(last))", "angle_at(0)"),
    ("angle along the frame and opposite exchanged", "passes_0 ? angle_at(std::abs(l.ground - l.input))",
     "passes_0 ? angle_at(l.ground + l.input)"),
    ("what the driver passes exchanged", "verdict.passes_0 = way.best.passes_0;", "verdict.passes_0 = way.best.passes_pi;"),
    ("sense of the drive exchanged", "is_half(ccw_bit)", "is_half(cw_bit)"),
]

SPHERICAL = [
    ("first excess", "t1 = a + b", "t1 = a - b"),
    ("second excess", "t2 = a - b", "t2 = a + b"),
    ("third excess", "t3 = c - d", "t3 = d - c"),
    ("fourth excess", "t4 = c + d", "t4 = c - d"),
    ("ground and input exchanged in the frame's difference", "frame.sine_difference * rest.cosine_difference",
     "frame.cosine_difference * rest.cosine_difference"),
    ("passing along the frame", "~(n1 ^ n2) & ~flat_0", "(n1 ^ n2) & ~flat_0"),
    ("passing opposite to the frame", "~(n3 ^ n4) & ~flat_pi", "(n3 ^ n4) & ~flat_pi"),
    ("triple rockers taken for Grashof's", "regular() & ~(n1 ^ n2 ^ n3 ^ n4)", "regular() & (n1 ^ n2 ^ n3 ^ n4)"),
    ("output's crank", "grashof() & (n1 ^ n3)", "grashof() & ~(n1 ^ n3)"),
    ("types exchanged by their lowest bit", "bit_0 = (grashof & ~crank)", "bit_0 = (grashof & crank)"),
    ("types exchanged by their second bit", "(crank ^ s.output_is_crank())) | triple", "(crank & s.output_is_crank())) | triple"),
    ("circuit of a crank not looked at", "circuit = s.input_is_crank() & output_changes", "circuit = 0"),
    ("circuit of a rocker-crank not looked at", "circuit |= lanes & changes_sign<Width, Poses>([&](int j) { return pairs.at_input_moving(j); });", ";"),
    ("circuit of a double rocker not looked at", "circuit |= lanes & changes_sign<Width, Poses>([&](int j) { return pairs.at_input_fixed(j); });", ";"),
    ("side of the frame turned", "-pairs.at_input_fixed(0),", "pairs.at_input_fixed(0),"),
    ("last orientation left out of the angle", "angle_at(0), angle_at(orientations.size() - 1),", "angle_at(0),"),
    ("angle along the frame and opposite exchanged", "passes_0 ? angle_at(std::abs(l.ground - l.input))", "passes_0 ? angle_at(shorter_arc(far))"),
    ("what the driver passes exchanged", "verdict.passes_0 = way.best.passes_0;", "verdict.passes_0 = way.best.passes_pi;"),
    ("a supplement taken for a link of its own", "cs = a.cosine * b.sine, ss", "cs = a.cosine * b.cosine, ss"),
]

LINE_CASES = [
    ("side of the pole", "pole(line.point + c * line.left())", "pole(line.point - c * line.left())"),
    ("bend of the inflection circle", "m0 = m - bend", "m0 = m + bend"),
    ("cubic's two numbers exchanged", "moving = n == 0 ? m : m * c + n * s", "moving = n == 0 ? m : m * s + n * c"),
    ("second layer's pole tangent", "Point{-tangent.imag(), tangent.real()}", "Point{-tangent.imag(), -tangent.real()}"),
    ("Bobillier's angle", "cross(second, to_point) / a", "cross(second, to_point) / b"),
    ("cubic through the point", "m = ray.imag() * (1 / given.pole_distance - n / ray.real())",
     "m = ray.imag() * (1 / given.pole_distance + n / ray.real())"),
    ("Ball's point on a link", "moving = fixed * pole_height / (fixed + pole_height)", "moving = fixed * pole_height / (fixed - pole_height)"),
    ("trapezoid's link", "f * f + pole_height * pole_height", "f * f - pole_height * pole_height"),
    ("third ray of five points", "+ 2 * s * a.real() * b.real()", "+ s * a.real() * b.real()"),
    ("third link at the inflection pole", "b.real() + 3 * sines)", "b.real() + 2 * sines)"),
    ("sum of the tangents of six points", "tc * (e2 - 3) / 2 - ta", "tc * (e2 - 3) / 2 + ta"),
    ("distance of Watt's point", "across = -(input + output)", "across = (input + output)"),
    ("sine of the pole at a pivot", "double sine = 2 * a / c", "double sine = a / c"),
]

CONTACTS = [
    ("side of the dyad", "Point{0.5 * product.c[k], 0.5 * dyad.area.c[k]}", "Point{0.5 * product.c[k], -0.5 * dyad.area.c[k]}"),
    ("lengths of the dyad", "(crank - arm) * (crank + arm)", "(arm - crank) * (crank + arm)"),
    ("angle of the coupler", "turn_.imag() * dyad.area.c[k]", "-turn_.imag() * dyad.area.c[k]"),
    ("first condition left in the second", "right(0) - right_", "right(0) + right_"),
    ("second solution", "discriminant = h.real() * h.real() - 4 * sine * last", "discriminant = h.real() * h.real() + 4 * sine * last"),
]

INSTANT = [
    ("pole", "by_turn->path.c[0] + i_times(by_turn->path.c[1])", "by_turn->path.c[0] - i_times(by_turn->path.c[1])"),
    ("pole tangent", "tangent = -i_times(normal) / diameter", "tangent = i_times(normal) / diameter"),
    ("turn of the arm", "for (std::size_t i = 0; i < k; ++i)", "for (std::size_t i = 1; i < k; ++i)"),
    ("invariants exchanged", "diameter, third.real(), third.imag()", "diameter, third.imag(), third.real()"),
]

SENSITIVITIES = [
    ("output link", "-output, 1, left_turn,", "output, 1, left_turn,"),
    ("output's fixed pivot", "-1,    -left_turn, 0,", "1,    -left_turn, 0,"),
    ("the point left behind by the input", "carries = {input, 0,", "carries = {0, 0,"),
    ("sense of the arm's turn", "turns = left_turn *", "turns = -left_turn *"),
    ("sense of the coupler's turn", "-dot(opens[i], output) /", "dot(opens[i], output) /"),
    ("output measured by the coupler", "(lengths.output * sine)", "(lengths.coupler * sine)"),
    ("coupler on the sphere", "-dot(opens[i], arcs[2]) / joint", "dot(opens[i], arcs[2]) / joint"),
    ("ground's arc", "cross(g2, g1)}", "cross(g1, g2)}"),
    ("driver on the sphere", "opens[at_parameter(SphericalParameter::driver)] = g1", "opens[at_parameter(SphericalParameter::driver)] = g2"),
    ("best line's slope", "value + product / square", "value - product / square"),
]

ARMS = [
    ("sum and difference exchanged", "(sum - difference) / 2, (sum + difference) / 2", "(sum + difference) / 2, (sum - difference) / 2"),
    ("elbow on the other half of the line", "0.5 * (1 - sum * difference / square)", "0.5 * (1 + sum * difference / square)"),
    ("elbows exchanged", "side == 0 ? across : -across", "side == 0 ? -across : across"),
    ("order of the first two left out", "next.ccw = ccw && next.sweep > sweep;", "next.ccw = ccw;"),
    ("clockwise is not falling", "(point == 1 || next.sweep < sweep)", "(point == 1 || next.sweep > sweep)"),
    ("half a turn in the other sense", "senses_of(sweep >= 2, sweep > 0 && sweep <= 2)", "senses_of(sweep <= 2, sweep >= 2)"),
    ("left half of the plane upside down", "v.real() < 0 ? 2 - share : share", "v.real() < 0 ? 2 + share : share"),
]

ARM_MOTIONS = [
    ("body's angle taken for the link's", "motion.link[j] = reached - direction(path[j].angles.front()) * placed.at_zero;",
     "motion.link[j] = direction(path[j].angles.front()) * placed.at_zero;"),
    ("body turned the other way", "cross(arm[0], arm[j]) * of_square", "cross(arm[j], arm[0]) * of_square"),
    ("rates of link and body exchanged", "return {known, rates_of_rest(place.jet, arm, link, known)};",
     "return {rates_of_rest(place.jet, arm, link, known), known};"),
    ("what is known of a derivative left in", "rest[k] = jet[k] - rest[k];", "rest[k] = jet[k] + rest[k];"),
    ("rate of the link by the link", "cross(rest, i * arm) / size", "cross(rest, i * link) / size"),
    ("square of the bend left out", "turned_arm(arm, 0, rates.body).back();", "Point{};"),
    ("condition conjugated", "-std::numbers::sqrt2 * q.imag()", "std::numbers::sqrt2 * q.imag()"),
    ("elbow of the wrong point", "elbow(elbows, pattern, plain++)", "elbow(elbows, pattern, plain)"),
]

STATICS = [
    ("twist of the input", "input = cross(beta, h), coupler = cross(alpha, beta)", "input = cross(h, beta), coupler = cross(alpha, beta)"),
    ("twist of the output", "output = cross(alpha, h);", "output = cross(h, alpha);"),
    ("the coupler's pivot stands still", "turning + quarter_turn * (twist.input * arm(bars, Link::input)) : turning", "turning : turning"),
    ("force on the coupler does no work by its pivot", "         dot(force[1], of_coupler);", "         0 * dot(force[1], of_coupler);"),
    ("a spring pushes both ways alike", "to.add(place, spring.from, -spring.count * force * along);", "to.add(place, spring.from, spring.count * force * along);"),
    ("torsion spring of the wrong sense", "spring.joint, spring.moment - spring.rate * turned);", "spring.joint, spring.moment + spring.rate * turned);"),
    ("torsion spring between input and coupler", "return of(Link::coupler) - of(Link::input);", "return of(Link::coupler) + of(Link::input);"),
    ("joint's other link left alone", "all.add_moment(links.other, -moment);", ";"),
    ("acceleration towards the outside", "arm_of_point * Point{-first * first, second}", "arm_of_point * Point{first * first, second}"),
    ("acceleration of the coupler's pivot", "by_square -= arm(place.bars, Link::input)", "by_square += arm(place.bars, Link::input)"),
    ("second rate of the coupler", "dot(r, beta) / dot(quarter_turn * h, beta), -dot", "-dot(r, beta) / dot(quarter_turn * h, beta), -dot"),
    ("inertia about the centre", "-mass.inertia * turning", "mass.inertia * turning"),
    ("body turned the other way", "direction(body_.angle) * point.at - first_.input_moving)", "direction(-body_.angle) * point.at - first_.input_moving)"),
    ("moment of the coupler at the input's pivot", "Row{arm(place.bars, Link::coupler), -all.moment[1]}", "Row{arm(place.bars, Link::coupler), all.moment[1]}"),
    ("force of the coupler on the input", "-cross(alpha, all.force[1]) - all.moment[0]}", "cross(alpha, all.force[1]) - all.moment[0]}"),
    ("pin at the ground", "*at_output - all.force[2]}", "*at_output + all.force[2]}"),
    ("friction of pins helps", "-std::copysign(friction_circle_", "std::copysign(friction_circle_"),
    ("friction circle", "mu / std::sqrt(1 + mu * mu)", "mu / std::sqrt(1 - mu * mu)"),
]

CARRIED = [
    ("rod's centre at its end", "Point{length / 2, 0}", "Point{length, 0}"),
    ("mass by metre without the length", "*link.kg_per_m * length * metres : link.mass", "*link.kg_per_m * metres : link.mass"),
    ("slope up where it goes down", "loads.gravity->direction - of.slope", "loads.gravity->direction + of.slope"),
    ("weight of the output on the input", "mass_of(LoadedBody::output,", "mass_of(LoadedBody::input,"),
]

TIMED_FIT = [
    ("coupler on the other side", "-branch * std::sqrt(across)", "branch * std::sqrt(across)"),
    ("law of cosines", "(l.b * l.b - l.h * l.h - square)", "(l.h * l.h - l.b * l.b - square)"),
    ("sense of the coupler's turn", "-closure[i] / loop.f_u", "closure[i] / loop.f_u"),
    ("loop by its output", "dot(g, at.u), -l.b,", "dot(g, at.u), l.b,"),
    ("datum turns the point the other way", "l.a * quarter_turn(at.e)};", "-l.a * quarter_turn(at.e)};"),
    ("arm turned the other way", "quarter_turn(at.u),\n", "-quarter_turn(at.u),\n"),
    ("coupler does not carry the point", "rows[i] += state.coupler_row[i] * by_u", "rows[i] -= state.coupler_row[i] * by_u"),
    ("crank against its sense", "product(start_.datum, direction_of_turn(by[datum_at]))",
     "product(start_.datum, std::conj(direction_of_turn(by[datum_at])))"),
    ("one coordinate left out", "TimedRow{y, off.imag()}", "TimedRow{y, off.real()}"),
]

CURVE_FIT = [
    # scan
    ("driving dyad on the other side", "return {product(along, {at_pivot, up}), product(along, {at_point, R{} - a / r * up})};",
     "return {product(along, {at_pivot, R{} - up}), product(along, {at_point, a / r * up})};"),
    ("Freudenstein's equation", "return {dot(e, u), DyadReal<Width>{} - cross(e, u),", "return {dot(e, u), cross(e, u),"),
    ("eigenvectors exchanged", "R{} - scale * q, v, scale * p, w", "scale * q, v, scale * p, w"),
    ("law of cosines in lanes", "excess = (a - r) * (a + r)", "excess = (r - a) * (a + r)"),
    ("sides at the farthest and the nearest point", "add({far[0], near[0]}, sum, difference);", ";"),
    ("sum and difference of the first dyad", "add({(s - d) / 2, (s + d) / 2, side, group_})", "add({(s - d) / 2, (s - d) / 2, side, group_})"),
    ("side begins anew", "right ^= ~std::uint32_t{0} << first", "right |= std::uint32_t{1} << first"),
    # second dyad
    ("condition of a dyad", "triple_product(g.gamma, z.zeta, o.omega).imag()", "triple_product(g.gamma, z.zeta, o.omega).real()"),
    ("pivot of the second dyad", "center = -v.gamma / (scale * input)", "center = v.gamma / (scale * input)"),
    ("arm of the point", "return CouplerLinkage{pivot, pivot + center, input, h, 0, arm / h * std::conj(z)};",
     "return CouplerLinkage{pivot, pivot + center, input, h, 0, arm / h * z};"),
    ("second dyad at a place", "const Row row = {q.real(), -q.imag(), 1,", "const Row row = {q.real(), q.imag(), 1,"),
    ("rating's driver", "(cross(one(j), other(j)) > 0) != side", "(cross(one(0), other(j)) > 0) != side"),
    ("rating's sides", "((right >> j & 1) != 0 ? -1 : 1)", "((right >> j & 1) != 0 ? 1 : -1)"),
    # least squares
    ("residual slides away", "along = slide.slide, closure", "along = -slide.slide, closure"),
    ("state slides back", "across * e - along * u, across * u + along * e", "across * e + along * u, across * u - along * e"),
    ("loop by its output", "dot(g, at.e), dot(g, at.u), -linkage.b,", "dot(g, at.e), dot(g, at.u), linkage.b,"),
    ("closure left out of the point's row", "point_rows[i] -= closure_row[i] * closure;", ";"),
    ("point carried the other way", "iu = quarter_turn(at.u);", "iu = -quarter_turn(at.u);"),
    # hinges
    ("Grashof's excess", "std::array<double, 4> factors = {-1, -1, -1, -1};", "std::array<double, 4> factors = {1, 1, 1, 1};"),
    ("link ratio", "factors[shortest] -= limits.max_link_ratio;", "factors[shortest] += limits.max_link_ratio;"),
    ("ground link by its pivots", "{{-unit.real(), -unit.imag(), unit.real(), unit.imag()}, length}",
     "{{unit.real(), unit.imag(), unit.real(), unit.imag()}, length}"),
    ("turn of an input that is longer than the ground", "const double sign = g < a ? -1 : 1;", "const double sign = 1;"),
    ("transmission by the closure", "- by_closure * slide.closure_row[i] +", "+ by_closure * slide.closure_row[i] +"),
    ("branch left to the other side", "{-branch_weight * branch}", "{branch_weight * branch}"),
    ("window's far side", "row.residual = pivot_weight * (place[i] - clamped);", "row.residual = pivot_weight * (clamped - place[i]);"),
]

CURVE_DRIVE = [
    # realisations
    ("third pivot", "all.push_back(from.cognate());", "all.push_back(from);"),
    ("swapped realisation keeps its driver", "Realisation other{linkwright::swapped(linkage), {}, output, input};",
     "Realisation other{linkwright::swapped(linkage), {}, input, output};"),
    ("coupler of the cognate", "3 - static_cast<int>(input) - static_cast<int>(output)", "static_cast<int>(input)"),
    ("largest distance", "if (weight == 0 || distance <= error.max) continue;", "if (weight == 0 || distance >= error.max) continue;"),
    # driving
    ("dead points of the coupler taken for the input's", "return {at.u, output};", "return {at.e, output};"),
    ("a turn that is not full", "- 6.283185307179586) < 1e-3", "- 6.283185307179586) < 10"),
    ("circuit's tangent", "Point{-loop.f_u / length, loop.f_e / length}", "Point{loop.f_u / length, loop.f_e / length}"),
    ("any state on the circuit", "> reach * reach) return -1;", "> 1e9 * reach) return -1;"),
    ("going back always noise", "is_noise = back < forward && path_between(to, front) <= noise_", "is_noise = back < forward"),
    ("excursion", "std::max(drive.excursion, off)", "std::min(drive.excursion, off)"),
    ("length of a closed path", "if (closed) return whole;", "if (closed) return 2 * whole;"),
    ("turns between sparse states", "turn + two_pi * std::round((about - turn) / two_pi)", "turn"),
    ("input's and output's verdicts exchanged", "drive.of(input).no_dead_point, drive.of(output).no_dead_point",
     "drive.of(output).no_dead_point, drive.of(input).no_dead_point"),
]

POSE_FIT = [
    # field
    ("place of a body point", "{d.imag(), r.imag(), r.real()}", "{d.imag(), -r.imag(), r.real()}"),
    ("square of a place", "{std::norm(d), 2 * turned.real(), -2 * turned.imag()}", "{std::norm(d), 2 * turned.real(), 2 * turned.imag()}"),
    ("centre of the best circle", "0.5 * (s.yy * s.qx - s.xy * s.qy) / two", "0.5 * (s.yy * s.qx + s.xy * s.qy) / two"),
    ("radius of the best circle", "mean_q - 2 * linkwright::dot(center, mean) +", "mean_q + 2 * linkwright::dot(center, mean) +"),
    ("determinant of three", "qx * (qx * yy - xy * qy) + qy * (qx * xy - xx * qy)", "qx * (qx * yy - xy * qy) - qy * (qx * xy - xx * qy)"),
    ("error over the radius", "std::sqrt(std::max(s.three() / two, 0.0)) / (2 * radius)", "std::sqrt(std::max(s.three() / two, 0.0)) / radius"),
    ("weights of the scatter", "share = weights[j] / sum", "share = 1.0 / static_cast<double>(poses.size())"),
    ("minima climbed", "const bool lower = now < value;", "const bool lower = now > value;"),
    ("valleys from the top", "[](const auto& a, const auto& b) { return a.value < b.value; });\n  std::vector<Point> chosen;",
     "[](const auto& a, const auto& b) { return a.value > b.value; });\n  std::vector<Point> chosen;"),
    ("valleys apart", "if (std::none_of(chosen.begin(), chosen.end(), is_near)) chosen.push_back(place.z);", "chosen.push_back(place.z);"),
    # pairs
    ("error of a pair, mixed", "- 2 * mixed * one.error * other.error", "+ 2 * mixed * one.error * other.error"),
    ("squares of a pair exchanged", "const double moved = other.square * one.error * one.error", "const double moved = one.square * one.error * one.error"),
    ("turn of a dyad", "gradient{unit, cross(arm, unit) / turning_length}", "gradient{unit, cross(arm, unit) * turning_length}"),
    # least squares
    ("pivot in the body", "product(std::conj(axis), unit);\n  return", "product(axis, unit);\n  return"),
    ("length of a link", "-0.5 * (1 + std::norm(unit))", "0.5 * (1 + std::norm(unit))"),
    ("slide against its sense", "slide(-dot(along, off))", "slide(dot(along, off))"),
    ("normal equations, mixed", "mixed = hold.share * two", "mixed = -hold.share * two"),
    ("gradient of the first dyad", "ga = weight * (mixed * residual[1] - one * residual[0])", "ga = weight * (mixed * residual[1] + one * residual[0])"),
    ("sine by the turn of the coupler", "-by_turn.real(),\n", "by_turn.real(),\n"),
    ("sine by the output's length", "-sine / linkage.b,", "sine / linkage.b,"),
    ("hinge of the coupler's length", "-by_h * unit.real(),", "by_h * unit.real(),"),
    ("branch left to the other side", "entry *= -branch_weight * branch", "entry *= branch_weight * branch"),
    # exact poses
    ("exact poses weigh little more", "std::vector<double>{1e4, 1e7, 1e10, 1e13}", "std::vector<double>{}"),
    ("exact poses weigh nothing", "for (const std::size_t j : exact) all[j] = factor;", ";"),
    ("inexact answers listed", "if (!(fit.error.exact_residual <= most)) continue;", "if (fit.error.exact_residual <= most) continue;"),
    ("exact poses compared as others", "target.is_exact(pose) ? exact : target.weight(pose)", "target.is_exact(pose) ? 0 : target.weight(pose)"),
    # what is told
    ("exact poses among the near ones", "error.exact_residual = std::max(error.exact_residual, std::sqrt(square));\n      continue;",
     "error.exact_residual = std::max(error.exact_residual, std::sqrt(square));"),
    ("turns do not count", "position_error + by_turn * by_turn", "position_error + by_turn"),
    ("angle of a state", "pose.angle + turn}", "pose.angle - turn}"),
    ("largest error", "if (square <= largest) continue;", "if (square > largest && largest >= 0) continue;"),
    ("defective linkages listed", "if (!fit.drive.no_defects(false)) {", "if (fit.drive.no_defects(false)) {"),
    ("driven by the output", "verdict(drive, CurveDriver::e, CurveDriver::g)", "verdict(drive, CurveDriver::g, CurveDriver::e)"),
]

STRAIGHT_LINE_CHECK = ["tests/mutants/straight_line_check.cpp", "tests/support/straight_line_tasks.cpp",
                       "tests/support/random_task.cpp"]

# The unit that is built, the headers it is built with, the check, what the check shares, and what is wrong in turn.
SUBJECTS = {
    "planar": ("src/mechanism/defects.cpp", ["src/mechanism/pair_verdict.hpp", "src/mechanism/driver_travel.hpp"],
               ["tests/mutants/planar_check.cpp", "tests/support/random_four_bar.cpp"], PLANAR),
    "spherical": ("src/mechanism/spherical_defects.cpp", ["src/mechanism/spherical_verdict.hpp"],
                  ["tests/mutants/spherical_check.cpp"], SPHERICAL),
    "arms": ("src/planar/arm_reach.cpp", [], ["tests/mutants/arm_check.cpp"], ARMS),
    "motions of arms": ("src/planar/arm_motion.cpp", [], ["tests/mutants/arm_motion_check.cpp"], ARM_MOTIONS),
    "cases of straight lines": ("src/straight_line/line_cases.cpp", [], STRAIGHT_LINE_CHECK, LINE_CASES),
    "contacts at places": ("src/straight_line/mixed_contacts.cpp", [], STRAIGHT_LINE_CHECK, CONTACTS),
    "sensitivities": ("src/robust/sensitivity.cpp", [],
                      ["tests/mutants/tolerance_check.cpp", "tests/support/random_four_bar.cpp"], SENSITIVITIES),
    "carried": ("src/loads/carried.cpp", ["src/loads/carried.hpp"],
                ["tests/mutants/statics_check.cpp", "tests/support/random_four_bar.cpp"], CARRIED),
    "statics": ("src/loads/statics.cpp", ["src/loads/statics.hpp"], ["tests/mutants/statics_check.cpp", "tests/support/random_four_bar.cpp"], STATICS),
    "curve fit": ("tests/mutants/curve_fit_units.cpp",
                  [f"src/approximate/{name}" for name in
                   ("curve_least_squares.cpp", "driving_dyads.cpp", "dyad_scan.cpp", "dyad_scan_lanes.hpp", "fit_hinges.cpp",
                    "loop_slide.hpp", "pair_rating.cpp", "second_dyad_at.cpp")],
                  ["tests/mutants/curve_fit_check.cpp", "tests/support/random_four_bar.cpp"], CURVE_FIT),
    "curve drive": ("tests/mutants/curve_drive_units.cpp",
                    [f"src/approximate/{name}" for name in
                     ("circuit_drive.cpp", "coupler_circuit.cpp", "drive_verdict.cpp", "fit_result.cpp")],
                    ["tests/mutants/curve_drive_check.cpp", "tests/support/random_four_bar.cpp"], CURVE_DRIVE),
    "pose fit": ("tests/mutants/pose_fit_units.cpp",
                 [f"src/approximate/{name}" for name in
                  ("pose_field.cpp", "pose_field.hpp", "pose_fit.cpp", "pose_least_squares.cpp", "pose_pairs.cpp", "pose_result.cpp",
                   "pose_search.cpp", "pose_target.cpp")],
                 ["tests/mutants/pose_fit_check.cpp", "tests/support/random_four_bar.cpp"], POSE_FIT),
    "timed fit": ("src/approximate/timed_least_squares.cpp", [],
                  ["tests/mutants/fit_check.cpp", "tests/support/random_four_bar.cpp"], TIMED_FIT),
    "instant": ("src/infinitesimal/instant.cpp", [], STRAIGHT_LINE_CHECK, INSTANT),
}


class Workshop:
    """Compiles what every mutant of a subject shares once; a mutant is one unit and a link."""

    def __init__(self, source_dir, library, compiler, flags, scratch, shared):
        self.source_dir, self.library, self.compiler, self.flags, self.scratch = source_dir, library, compiler, flags, scratch
        self.launcher = ["ccache"] if shutil.which("ccache") else []
        scratch.mkdir(parents=True)
        self.shared = [scratch / (pathlib.Path(path).stem + ".o") for path in shared]
        for path, target in zip(shared, self.shared):
            self.compile(source_dir / path, target, [])

    def compile(self, source, target, before):
        command = [*self.launcher, self.compiler, "-std=c++20", "-O1", "-w", *before, f"-I{self.source_dir}/include", f"-I{self.source_dir}/src",
                   f"-I{self.source_dir}/tests", "-c", str(source), "-o", str(target)]
        subprocess.run(command, check=True)

    def run(self, name, unit, texts):
        """The check's result with these texts, by path, in place of the library's."""
        folder = self.scratch / name
        for path, text in texts.items():
            place = folder / path.removeprefix("src/")
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(text)
        target = folder / "unit.o"
        self.compile(folder / unit.removeprefix("src/"), target, [f"-I{folder}"])
        program = folder / "check"
        # The library may have the unit in one object with its neighbours: the first definition counts.
        subprocess.run([self.compiler, "-Wl,--allow-multiple-definition", *map(str, self.shared), str(target), self.library,
                        "-o", str(program), *self.flags], check=True)
        return subprocess.run([str(program)], capture_output=True, text=True, check=False)


def mutants_of(subject, texts, failures):
    unit, _, _, wrong = SUBJECTS[subject]
    for name, before, after in wrong:
        found = sum(text.count(before) for text in texts.values())
        if found == 1:
            yield name, {path: text.replace(before, after) for path, text in texts.items()}
        else:
            failures.append(f"'{before}' stands {found} times in {unit}: mend this list")


def chosen(mutants, texts):
    """All of them, or the one whose turn it is."""
    if os.environ.get("LINKWRIGHT_ALL_TESTS") == "1" or not mutants:
        return mutants
    return [mutants[zlib.crc32("".join(texts.values()).encode()) % len(mutants)]]


def main():
    source_dir, scratch, library, compiler, *flags = sys.argv[1:]
    source_dir = pathlib.Path(source_dir)
    shutil.rmtree(scratch, ignore_errors=True)
    failures = []
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for subject, (unit, headers, shared, _) in SUBJECTS.items():
            texts = {path: (source_dir / path).read_text() for path in [unit, *headers]}
            workshop = Workshop(source_dir, library, compiler, flags, pathlib.Path(scratch) / subject.replace(" ", "_"), shared)
            right = pool.submit(workshop.run, "right", unit, texts)
            results = [(name, pool.submit(workshop.run, str(number), unit, wrong))
                       for number, (name, wrong) in enumerate(chosen(list(mutants_of(subject, texts, failures)), texts))]
            print(f"{subject} as it is:", right.result().stdout.strip())
            if right.result().returncode != 0:
                failures.append(f"{subject}: disagrees as it is")
            for name, result in results:
                print(f"{subject}, {name}: {result.result().stdout.strip()}")
                if result.result().returncode == 0:
                    failures.append(f"not caught: {subject}, {name}")
    for failure in failures:
        print("FAILED:", failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
