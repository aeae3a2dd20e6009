// The kinds of tasks there are: a folder and a line to each.
import {attitude} from "./attitude/index";
import {function_generation} from "./function/index";
import {linkage_modules} from "./given_linkage/index";
import {motion} from "./motion/index";
import {path} from "./path/index";
import {six_bar} from "./six_bar/index";
import {spherical} from "./spherical/index";
import {spherical_function} from "./spherical_function/index";
import {straight_line} from "./straight_line/index";

export const task_modules = [
  motion,
  function_generation,
  path,
  six_bar,
  straight_line,
  spherical,
  spherical_function,
  attitude,
  linkage_modules.four_bar,
  linkage_modules.six_bar,
  linkage_modules.spherical,
] as const;
