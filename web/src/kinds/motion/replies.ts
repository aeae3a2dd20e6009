// What the engine can say of guided bodies, beside what it says of every map.
import type {NearPoses} from "../../contract/result";

declare module "../../contract/messages" {
  interface Properties {
    near_error: number; // of near poses: root mean square of the errors there, user's unit
    pose_miss: number; // by how much the freed pose is missed, user's unit; in cells that meet everything
  }
  interface Linkage {
    near?: NearPoses; // of tasks with near poses
  }
}

export {};
