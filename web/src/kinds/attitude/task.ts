// As the file has it: how a body stands, and what is shown of it.
import type {Orientation, Turning} from "../../orientation/orientation";
import type {Vec3} from "../../sphere/vectors";
import type {Task} from "../../state/task";

export interface AttitudeTask extends Task {
  kind: "attitude";
  mechanism: "body";
  orientation: Orientation;
  /** Whose three turns are shown. */
  sequence: string;
  turning: Turning;
  /** Turned with the body, by one turn. */
  vector: Vec3;
  /** The first pose of the screw displacement; the second has the orientation and this place. */
  from: {orientation: Orientation; translation: Vec3};
  translation: Vec3;
  /** Of the angles of the sequence, per second. */
  rates_deg: Vec3;
}

export function is_attitude(task: Task): task is AttitudeTask {
  return task.kind === "attitude";
}
