#include "sheet.hpp"

#include "linkwright/files/label.hpp"
#include "linkwright/files/task_label.hpp"
#include "palette.hpp"

namespace linkwright {

SvgCanvas solution_sheet::begin(const Problem& problem, std::string_view subtitle) {
  SvgCanvas svg(width, height, problem.title.empty() ? "Linkwright solution" : problem.title);
  svg.rectangle({0, 0}, width, height, fill(palette::page));
  const std::string title = problem.title.empty() ? sentence_case(short_task_label(problem.task)) : problem.title;
  svg.text({border, 42}, fit_text(title, 24, 0.92 * (width - 2 * border)), {.size = 24, .weight = 650});
  svg.text({border, 66}, fit_text(std::string(subtitle), 14, 1.04 * (width - 2 * border)),
           {.size = 14, .color = palette::ink2});
  return svg;
}

SvgCanvas linkage_sheet::begin(const std::string& title, std::string_view kind) {
  SvgCanvas svg(width, height, title);
  svg.rectangle({0, 0}, width, height, fill(palette::page));
  svg.text({border, 42}, fit_text(title, 22, 600), {.size = 22, .weight = 650});
  svg.text({width - border, 42}, kind, {.size = 15, .color = palette::ink2, .anchor = "end"});
  return svg;
}

}  // namespace linkwright
