// What kinds of tasks add to the types is there.
import type {Linkage, Requirements, TaskAnswer} from "linkwright";

export const topology = (linkage: Linkage) => linkage.six_bar?.topology;
export const arc_deg = (linkage: Linkage) => linkage.spherical?.angles_deg.coupler;
export const stroke = (linkage: Linkage) => linkage.straight_line?.usable.length;
export const pairs = (task: TaskAnswer) => task.function?.pairs.length;
export const wanted: Requirements = {min_stroke: 2, max_link_angle_deg: 150};
