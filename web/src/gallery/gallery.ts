// The tasks that are shown to choose from: the examples of the project, then some that show a property of the curves.
import airtight_hatch from "../../../examples/airtight_hatch.json?raw";
import ankle_orthosis from "../../../examples/ankle_orthosis.json?raw";
import antenna_pointing from "../../../examples/antenna_pointing.json?raw";
import bean_stirrer from "../../../examples/bean_stirrer.json?raw";
import corner_drawer from "../../../examples/corner_drawer.json?raw";
import counterbalanced_lid from "../../../examples/counterbalanced_lid.json?raw";
import cylinder_bucket from "../../../examples/cylinder_bucket.json?raw";
import dump_bucket from "../../../examples/dump_bucket.json?raw";
import drawer_hinge from "../../../examples/drawer_hinge.json?raw";
import dough_mixer from "../../../examples/dough_mixer.json?raw";
import film_advance from "../../../examples/film_advance.json?raw";
import film_claw from "../../../examples/film_claw.json?raw";
import flow_meter_as_made from "../../../examples/flow_meter_as_made.json?raw";
import folding_table from "../../../examples/folding_table.json?raw";
import folding_wing from "../../../examples/folding_wing.json?raw";
import footrest from "../../../examples/footrest.json?raw";
import garage_door_point from "../../../examples/garage_door_point.json?raw";
import hood_hinge from "../../../examples/hood_hinge.json?raw";
import hood_strut from "../../../examples/hood_strut.json?raw";
import landing_gear from "../../../examples/landing_gear.json?raw";
import latch from "../../../examples/latch.json?raw";
import lift_platform from "../../../examples/lift_platform.json?raw";
import log_generator from "../../../examples/log_generator.json?raw";
import nose_gear from "../../../examples/nose_gear.json?raw";
import packaging_feeder from "../../../examples/packaging_feeder.json?raw";
import sine_generator from "../../../examples/sine_generator.json?raw";
import straight_indicator from "../../../examples/straight_indicator.json?raw";
import straight_luffing_crane from "../../../examples/straight_luffing_crane.json?raw";
import straight_scraper_as_made from "../../../examples/straight_scraper_as_made.json?raw";
import straight_search from "../../../examples/straight_search.json?raw";
import straight_stage from "../../../examples/straight_stage.json?raw";
import straight_walking_leg from "../../../examples/straight_walking_leg.json?raw";
import straight_watt_suspension from "../../../examples/straight_watt_suspension.json?raw";
import tailgate from "../../../examples/tailgate.json?raw";
import tailgate_as_made from "../../../examples/tailgate_as_made.json?raw";
import tailgate_struts from "../../../examples/tailgate_struts.json?raw";
import thread_take_up from "../../../examples/thread_take_up.json?raw";
import transfer_arm from "../../../examples/transfer_arm.json?raw";
import universal_joint_like from "../../../examples/universal_joint_like.json?raw";
import walking_foot from "../../../examples/walking_foot.json?raw";
import walking_leg_path from "../../../examples/walking_leg_path.json?raw";
import windscreen_wiper from "../../../examples/windscreen_wiper.json?raw";
import wrist_orthosis from "../../../examples/wrist_orthosis.json?raw";
import type {Problem} from "../state/problem";
import type {TextKey} from "../texts/texts.svelte";
import almost_symmetric from "./almost_symmetric.json?raw";
import part_transfer from "./attitude/part_transfer.json?raw";
import five_hatch from "./five_hatch.json?raw";
import hatchback_lid from "./hatchback_lid.json?raw";
import wheel_loader from "./wheel_loader.json?raw";
import mirror_symmetric from "./mirror_symmetric.json?raw";
import parallel_moves from "./parallel_moves.json?raw";
import three_parallel from "./three_parallel.json?raw";

const files = {
  tailgate,
  tailgate_as_made,
  tailgate_struts,
  drawer_hinge,
  dump_bucket,
  cylinder_bucket,
  landing_gear,
  folding_table,
  folding_wing,
  lift_platform,
  counterbalanced_lid,
  hood_hinge,
  hood_strut,
  latch,
  airtight_hatch,
  footrest,
  corner_drawer,
  nose_gear,
  transfer_arm,
  film_claw,
  thread_take_up,
  dough_mixer,
  windscreen_wiper,
  walking_leg_path,
  packaging_feeder,
  garage_door_point,
  bean_stirrer,
  walking_foot,
  film_advance,
  sine_generator,
  log_generator,
  flow_meter_as_made,
  straight_luffing_crane,
  straight_indicator,
  straight_walking_leg,
  straight_watt_suspension,
  straight_stage,
  straight_search,
  straight_scraper_as_made,
  wrist_orthosis,
  antenna_pointing,
  ankle_orthosis,
  universal_joint_like,
  part_transfer,
  five_hatch,
  wheel_loader,
  hatchback_lid,
  almost_symmetric,
  mirror_symmetric,
  three_parallel,
  parallel_moves,
};
export type ExampleName = keyof typeof files;
export interface Example {
  name: ExampleName;
  problem: Problem;
  title: TextKey;
  story: TextKey;
}

/** Files of ours: their comments stand on lines of their own. */
function read(text: string): Problem {
  return JSON.parse(text.replace(/^\s*\/\/.*$/gm, "")) as Problem;
}

export const examples: readonly Example[] = (Object.keys(files) as ExampleName[]).map((name) => ({
  name,
  problem: read(files[name]),
  title: `example.${name}`,
  story: `example.${name}_story`,
}));
export const first_example = examples[0]!; // files is no empty list

/** The name by which an example goes in both languages; nothing for a title of the user's. */
export function example_title(title: string | undefined): TextKey | null {
  return examples.find((example) => example.problem.title === title)?.title ?? null;
}
