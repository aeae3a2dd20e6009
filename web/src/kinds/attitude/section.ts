import type {AttitudeDesk} from "./desk.svelte";
import type {AttitudeReply} from "./reply";
import type {AttitudeTask} from "./task";

/** What every section is given. */
export interface SectionProperties {
  task: AttitudeTask;
  reply: AttitudeReply;
  desk: AttitudeDesk;
}
