import {readFileSync} from "node:fs";
import {describe, expect, it} from "vitest";
import {default_max_length, defaults} from "./defaults";

interface Described {
  properties: Record<string, {default?: unknown}>;
}

describe("what a file means where it is silent", () => {
  const {$defs} = JSON.parse(readFileSync("../schema/problem.schema.json", "utf8"));
  const described: Record<keyof typeof defaults, Described[]> = {
    given: [$defs.given_side_angle, $defs.given_instant_center],
    function: [$defs.function],
    output_scale: [$defs.free_scale],
    requirements: [$defs.requirements],
    options: [$defs.options],
  };
  it.each(Object.keys(defaults) as (keyof typeof defaults)[])("is what the schema says: %s", (name) => {
    const properties = Object.assign({}, ...described[name].map((one) => one.properties)) as Described["properties"];
    for (const [key, value] of Object.entries(defaults[name]))
      expect([key, properties[key]?.default]).toEqual([key, value]);
  });
  it("is what the schema says: max_length", () => {
    const {description} = $defs.requirements.properties.max_length;
    expect(description).toContain(`default ${default_max_length} times the task's characteristic length`);
  });
});
