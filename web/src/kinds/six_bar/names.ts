// What bodies and hinges of a six-bar are called, and their colours. Files keep the short names: "c4", "2:b-d".
import type {SixBar} from "./replies";
import {t, type TextKey} from "../../texts/texts.svelte";
import type {Role} from "../../figure/figure";
import {role_of_body, role_of_joint} from "./roles";

/** "driver", "added link" */
export function body_name(body: number): string {
  return t(`six_bar.body_${body}` as TextKey);
}
/** As it stands on the drawing: "c₄". */
export function joint_mark(name: string): string {
  return name.replace("4", "₄").replace("5", "₅");
}
/** "c₄ · ground – added link 4" */
export function joint_words({joints, bodies}: Pick<SixBar, "joints" | "bodies">, joint: number): string {
  const joined = bodies.flatMap((list, body) => (list.includes(joint) ? [body_name(body)] : []));
  return `${joint_mark(joints[joint]!.name)} · ${joined.join(" – ")}`;
}
/** "2:b-d" → "middle link b–d" */
export function length_words(name: string): string {
  const [body, ends] = name.split(":");
  return `${body_name(Number(body))} ${ends!.split("-").map(joint_mark).join("–")}`;
}

function color(role: Role): string {
  return role === "driver" ? "accent" : role === "coupler" ? "body" : role;
}
export function body_color(body: number): string {
  return color(role_of_body(body));
}
export function joint_color(joint: number): string {
  return color(role_of_joint(joint));
}
