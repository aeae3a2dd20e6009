// Uses the installed library from the outside: a value of a header, and the solver with all that it links to.

#include <iostream>

#include "linkwright/linkwright.hpp"

int main() {
  const auto type =
      linkwright::linkage_type(linkwright::LinkLengths{.ground = 4, .input = 1, .coupler = 3, .output = 3});
  const auto nothing = linkwright::solve({linkwright::MotionTask{}});
  std::cout << linkwright::name(type) << '\n';
  return type == linkwright::LinkageType::crank_rocker && !nothing.ok() ? 0 : 1;
}
