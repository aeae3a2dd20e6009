// What bodies and hinges of a six-bar are called. Files keep the short names: "c4", "2:b-d".
import type {SixBar} from "../../engine/protocol";
import {t, type TextKey} from "../../texts/texts.svelte";

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
  return `${joint_mark(joints[joint].name)} · ${joined.join(" – ")}`;
}
/** "2:b-d" → "middle link b–d" */
export function length_words(name: string): string {
  const [body, ends] = name.split(":");
  return `${body_name(Number(body))} ${ends.split("-").map(joint_mark).join("–")}`;
}
