// What is told of four-bars with a point of their coupler, beside what is told of any.
import type {Linkage, Point} from "../contract/messages";
import type {CarriedPoint} from "../figure/tracing";
import type {Pin} from "../state/problem";
import {t} from "../texts/texts.svelte";
import type {NamedJoint, NamedLength, TaskKind} from "./kind";

type Told = Required<Pick<TaskKind, "lengths" | "joints" | "kept_pivots">>;

export function told_with_point(carried: (linkage: Linkage) => CarriedPoint | null): Told {
  return {
    lengths(linkage): NamedLength[] | null {
      const {lengths: links} = linkage,
        of = carried(linkage);
      if (!of || !links) return null;
      return [
        {key: "ground", name: t("num.ground"), length: links.ground, color: null, term: "fixed_pivot"},
        {key: "input", name: t("num.input"), length: links.input, color: "input"},
        {key: "coupler", name: t("num.coupler"), length: links.coupler, color: "body"},
        {key: "output", name: t("num.output"), length: links.output, color: "output"},
        {key: "point_to_input", name: t("carried.point_to_input"), length: of.point_to_input, color: "body"},
        {key: "point_to_output", name: t("carried.point_to_output"), length: of.point_to_output, color: "body"},
      ];
    },
    joints(linkage): NamedJoint[] | null {
      const {input, output} = linkage,
        of = carried(linkage);
      if (!of || !input.center || !input.circle || !output.center || !output.circle) return null;
      const joint = (key: string, name: string, at: Point, on_ground: boolean, color: string): NamedJoint => ({
        key,
        name,
        at,
        on_ground,
        color,
      });
      return [
        joint("input_center", t("carried.input_fixed"), input.center, true, "input"),
        joint("input_circle", t("carried.input_moving"), input.circle, false, "input"),
        joint("output_center", t("carried.output_fixed"), output.center, true, "output"),
        joint("output_circle", t("carried.output_moving"), output.circle, false, "output"),
        joint("point", t("carried.point"), of.point, false, "accent"),
      ];
    },
    kept_pivots(linkage): Pin["pivots"] {
      const {input, output} = linkage,
        of = carried(linkage);
      return {
        input_center: input.center,
        input_circle: input.circle,
        output_center: output.center,
        output_circle: output.circle,
        ...(of ? {point: of.point} : {}),
      };
    },
  };
}
