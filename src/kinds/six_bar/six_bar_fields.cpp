#include <fmt/format.h>
#include <string>

#include "files/fields/forms.hpp"
#include "files/problem_fields.hpp"
#include "linkwright/files/nearest_name.hpp"
#include "six_bar_kind.hpp"

namespace linkwright {

static void fields(FieldVisitor& v, BodyPair& pair) {
  std::string written = text(pair);
  v.text(written);
  if (const auto named = body_pair_from(written))
    pair = *named;
  else
    v.mistake("unknown_bodies", fmt::format("{} names no two bodies; write them as in \"0-2\"", in_quotes(written)),
              {{"given", in_quotes(written)}});
}

void fields(FieldVisitor& v, ThreeLinkChain& chain) {
  const List signs = {.what = {"signs", "a list of four signs"},
                      .least = 4,
                      .most = 4,
                      .length_code = "elbow_count",
                      .length_sentence = "{count} signs are given; one to each of the four poses belongs here"};
  v.object({"chain", "Hinges of the chain 0-1-2-3 in position 1, fixed frame."}, [&](FieldVisitor& to) {
    to.required("a", chain.a, forms::point);
    to.required("b", chain.b, forms::point);
    to.required("d", chain.d, forms::point);
    to.optional(
        Field("elbow",
              "By pose, the side of the line from a to d on which b lies: 1 left, -1 right, 0 as in position 1."),
        chain.assembly_mode, signs, Whole{-1, 1});
  });
}

void fields(FieldVisitor& v, SixBarTask& task) {
  const List two = {.what = {"bodies", "two pairs of bodies"},
                    .least = 2,
                    .most = 2,
                    .length_code = "added_count",
                    .length_sentence = "{count} added links are given; a six-bar has two beside the chain"};
  const Object described = {"six_bar_task",
                            "Motion generation by a six-bar: a chain of three links that guides the body through four "
                            "poses, and two links added to it. Without a chain one is searched for in options.box.",
                            true};
  v.object(described, [&](FieldVisitor& to) {
    to.constant("kind", "motion");
    to.constant("mechanism", "six_bar");
    pose_fields(to, task.poses, task.points);
    to.optional("chain", task.chain);
    to.required(Field("added",
                      "Bodies joined by the first and by the second added link: 0 the ground, 1 … 3 the chain, 3 the "
                      "guided body, 4 the first added link.")
                    .missing("\"added\": [\"0-2\", \"0-3\"]"),
                task.added, two);
  });
}

}  // namespace linkwright
