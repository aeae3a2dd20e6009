// What the engine can say of guided bodies, beside what it says of every map.
declare module "../../contract/messages" {
  interface Properties {
    pose_miss: number; // by how much the freed pose is missed, user's unit; in cells that meet everything
  }
}

export {};
