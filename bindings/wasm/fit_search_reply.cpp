#include "files/fields/result_forms.hpp"
#include "files/problem_fields.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/fit_search.hpp"
#include "replies.hpp"
#include "reply_fields.hpp"
#include "reply_forms.hpp"

namespace linkwright::wasm {

std::string fit_search_reply(std::string_view text, const Progress& progress) {
  const auto problem = read_problem(text);
  if (!problem) return R"({"mistakes": )" + mistakes_json(problem.errors()) + "}";
  const auto usual = search_fits(*problem, problem->options.fit.effort);
  const auto deep = search_fits(*problem, FitEffort::deep, progress);
  if (!usual || !deep) return text_of(FitSearchReply{});
  return text_of(FitSearchReply{usual->rms, *deep});
}

void fields(FieldVisitor& v, const FitSearchReply& of) {
  const Object described = {"fit_search_reply", "What a longer search shows beside the usual one."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown(Field("usual_rms", "Error of the best by the usual search; null: it found none."), of.usual_rms,
             forms::not_negative);
    to.shown(Field("rms", "The same by this one."), of.search.rms, forms::not_negative);
    to.shown("starts", static_cast<std::int64_t>(of.search.starts), forms::count);
    to.shown(Field("minima", "To how many different linkages they led."), static_cast<std::int64_t>(of.search.minima),
             forms::count);
    to.shown(Field("linkages", "The best first: `options.fit.starts` of a problem."), of.search.linkages,
             List{.what = ""});
  });
}

}  // namespace linkwright::wasm
