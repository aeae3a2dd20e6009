// What the numbers of a linkage file are called.
import {is_object} from "../../state/shape";
import {t, type TextKey} from "../../texts/texts.svelte";
import type {Line} from "./file";
import type {LinkageTask} from "./task";

const sides = {input: "linkage.of_input", output: "linkage.of_output"} as const;
const ends: Record<string, TextKey> = {
  center: "num.fixed_pivot",
  fixed: "num.fixed_pivot",
  circle: "num.moving_pivot",
  moving: "num.moving_pivot",
};

export function line_words({path: [form, name, , which]}: Line, {file}: LinkageTask): string {
  if (form === "lengths" || form === "angles_deg") return t(`num.${name}` as TextKey);
  if (form === "chain") return t(`six_bar.hinge_${name}` as TextKey);
  if (form === "added") {
    const link = Array.isArray(file.added) ? (file.added as unknown[])[name as number] : null,
      between = is_object(link) && typeof link.between === "string" ? link.between : "";
    return t("linkage.hinge_of", {link: (name as number) + 4, body: between.split("-")[which as number] ?? ""});
  }
  const [side, end] = String(name).split("_") as [keyof typeof sides, string];
  if (name === "point") return t("linkage.point");
  const joint = form === "axes" ? (end === "fixed" ? "spherical.fixed_axis" : "spherical.moving_axis") : ends[end];
  return joint && sides[side] ? t(sides[side], {joint: t(joint)}) : String(name);
}
