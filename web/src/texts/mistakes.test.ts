import {execFileSync} from "node:child_process";
import {existsSync, readdirSync, readFileSync} from "node:fs";
import {fileURLToPath} from "node:url";
import {afterEach, beforeAll, describe, expect, it} from "vitest";
import {load_module} from "../engine/node";
import type {Mistake, PlateSizes} from "../contract/messages";
import {preferences} from "../state/preferences.svelte";
import en from "./en.json";
import {mistake_text, mistakes_text} from "./mistakes";

const root = fileURLToPath(new URL("../../../", import.meta.url));
const folder = `${root}data/bad_problems/`;
const program = `${root}build/release/bin/linkwright`;

let read: (text: string) => Mistake[];
/** Of the plates of a linkage, which are asked for beside a file. */
let of_plates: (asked: PlatesAsked) => Mistake[];
/** Of a drawing of another program. */
let of_drawing: (asked: object) => Mistake[];
beforeAll(async () => {
  const module = await load_module(),
    session = new module.Session();
  of_drawing = (asked) => {
    const text = JSON.stringify({length_unit: "mm", size: 1, ...asked});
    return (JSON.parse(module.report("outlines", text)) as {mistakes?: Mistake[]}).mistakes ?? [];
  };
  read = (text) => (session.read(text) ? [] : (JSON.parse(session.mistakes()) as Mistake[]));
  of_plates = ({example, at, sizes, format}) => {
    session.set_problem(readFileSync(`${root}examples/${example}.json`, "utf8"));
    const tau = at ?? (JSON.parse(session.best(1)) as {linkages: {tau: [number, number]}[]}).linkages[0]!.tau;
    return JSON.parse(session.machine_file(...tau, format, {...not_given, ...sizes}).mistakes) as Mistake[];
  };
});
afterEach(() => void (preferences.language = "en"));

interface PlatesAsked {
  example: string;
  at?: [number, number];
  sizes: Partial<PlateSizes>;
  format: string;
}
const not_given: PlateSizes = {width: 0, thickness: 0, gap: 0, pin: 0, clearance: -1, radius: 0};
const asked_of_plates: PlatesAsked[] = [
  {example: "tailgate", sizes: {width: -1, thickness: 1e10}, format: "stl"},
  {example: "tailgate", sizes: {width: 20, pin: 30}, format: "stl"},
  {example: "tailgate", sizes: {width: 300, pin: 200}, format: "3mf"},
  {example: "folding_wing", sizes: {thickness: 40}, format: "stl"},
  {example: "folding_wing", sizes: {}, format: "plates"},
];

const dxf = (text: string) => ({format: "dxf", text}),
  svg = (...elements: [number, string, object][]) => ({format: "svg", elements});
const drawings = [
  dxf("AutoCAD Binary DXF\r\n\x1a\0"),
  dxf("nonsense"),
  dxf("0\nSECTION\n2\nENTITIES\nx\n"),
  dxf("0\nSECTION\n2\nENTITIES\n"),
  svg(),
  svg([-1, "html", {}]),
  svg([-1, "svg", {}], [0, "text", {}]),
  svg([-1, "svg", {}], [0, "g", {id: "a"}], [1, "use", {href: "#a"}], [1, "use", {"xlink:href": "#a"}]),
];

/** Files that are text: others are refused before the engine sees them. */
const files = readdirSync(folder)
  .filter((name) => name !== "expected.json")
  .flatMap((name) => {
    try {
      return [
        {name, text: new TextDecoder("utf-8", {fatal: true, ignoreBOM: true}).decode(readFileSync(folder + name))},
      ];
    } catch {
      return [];
    }
  });

/** What those files leave out: what a task says more, and texts that are no file at all. */
const motion = (members: string) =>
  `{"linkwright": 1, "task": {"kind": "motion", "mechanism": "four_bar", "poses": [${members}}}`;
const pose = (x: number) => `{"x": ${x}, "y": 0, "theta_deg": ${x * x}}`;
const poses = (count: number) => Array.from({length: count}, (_, i) => pose(i)).join(", ");
const directed = '{"x": 0, "y": 0, "theta_deg": 0, "derivatives": [{"x": 1, "y": 0, "theta": 0}]}';
const chain = (d: string) =>
  `{"linkwright": 1, "task": {"kind": "motion", "mechanism": "six_bar", "added": ["0-2", "0-3"],
    "poses": [${poses(4)}], "chain": {"a": [0, 0], "b": [1, 5], "d": ${d}}}}`;
const lengths = (members: string) => `${motion(`${poses(4)}]`).slice(0, -1)}, "requirements": {${members}}}`;
const line = (of: string, members: string, rest = "") =>
  `{"linkwright": 1, "task": {"kind": "straight_line", "mechanism": "four_bar", "case": "${of}",
    "line": {"point": [0, 0], "direction_deg": 0}, ${members}}${rest}}`;
const contacts = (list: string) => line("mixed", `"input_pivot": [-1, -1], "contacts": [${list}]`);
const pivots = (output: string) => `"ground_pivots": {"input": [0, -1], "output": ${output}}`;
const made = (tolerances: string, rest = "") =>
  `${motion(`${poses(4)}]`).slice(0, -1)}, "tolerances": {${tolerances}}${rest}}`;
const front = (objectives: string, of = motion(`${poses(4)}]`)) =>
  `${of.slice(0, -1)}, "options": {"pareto": [${objectives}]}}`;
const linkage = (file: string) => `{"linkwright": 1, "task": {"kind": "linkage", "file": {${file}}}}`;
const pins = (input: string) =>
  `"pivots": {"input_center": [0, 0], "input_circle": ${input}, "output_center": [4, 0], "output_circle": [5, 3]}`;
const six_bar = (point: string, between: string, rest = "") =>
  linkage(`"mechanism": "six_bar", "chain": {"a": [0, 0], "b": [1, 0], "d": [2, 1]}, "added": [
    {"between": "0-2", "points": [[3, 0], [1, 1]]}, {"between": "${between}", "points": [[4, 0]${point}]}]${rest}`);
const arcs = (ground: number, others: number, rest = "") =>
  linkage(`"mechanism": "spherical_four_bar",
    "angles_deg": {"ground": ${ground}, "input": ${others}, "coupler": ${others}, "output": ${others}}${rest}`);
const path = (points: string, pivots: string | null = null) =>
  `{"linkwright": 1, "task": {"kind": "path", "mechanism": "four_bar", "points": [${points}]
    ${pivots === null ? "" : `, "given": {"ground_pivots": {${pivots}}}`}}}`;
const passed = (count: number, last = "") =>
  [...Array.from({length: count}, (_, i) => `{"x": ${i}, "y": ${i * i}}`), ...(last ? [last] : [])].join(", ");
/** First some with an angle, then some without. */
const angled = (of: "input" | "theta", count: number, plain: number) =>
  Array.from(
    {length: count + plain},
    (_, i) => `{"x": ${i}, "y": ${i * i}${i < count ? `, "${of}_deg": ${9 * i}` : ""}}`,
  ).join(", ");
const pivot = '"input": [1, 5]';
const further = {
  "a list without a comma": "[1 2]",
  "a list without a first value": "[, 1]",
  "an object with a comma too many": '{"linkwright": 1,}',
  "half of a pair of escapes": '{"title": "\\ud800"}',
  "a short escape": '{"title": "\\u12"}',
  "17 MiB of blanks": " ".repeat(17 << 20),
  "a hundred unknown keys": `{${Array.from({length: 103}, (_, i) => `"key ${i}": 0`).join(", ")}}`,
  "a freed pose that is not there": motion(`${poses(5)}], "freed_pose": 6`),
  "a freed pose of four": motion(`${poses(4)}], "freed_pose": 1`),
  "one pose with a direction": motion(`${directed}]`),
  "one pair with rates": `{"linkwright": 1, "task": {"kind": "function", "mechanism": "four_bar",
    "pairs": [{"input_deg": 0, "output_deg": 0, "derivatives": [{"input": 1, "output": 1}]}]}}`,
  "a chain that is too far away": chain("[1e10, 0]"),
  "a chain with unlike links": chain("[1.1, 5.2]").replace('"x": 3, "y": 0', '"x": 0, "y": -3'),
  "a chain without a second link": chain("[1, 5]"),
  "a length below zero": lengths('"min_length": -1'),
  "link angles out of range": lengths('"min_link_angle_deg": 90, "max_link_angle_deg": 0'),
  "a cone of nothing": lengths('"fixed_axes_within": {"axis": [0, 0, 0], "half_angle_deg": 0}'),
  "a cone about two numbers": lengths('"fixed_axes_within": {"axis": [0, 1], "half_angle_deg": 9}'),
  "a cone about a number": lengths('"fixed_axes_within": {"axis": 1, "half_angle_deg": 9}'),
  "a cone about a vector without end": lengths('"fixed_axes_within": {"axis": [0, 0, 1e13], "half_angle_deg": 9}'),
  "a type and a requirement of the sphere": lengths('"types": ["triple_rocker"], "min_link_angle_deg": 9'),
  "an objective of the sphere": `${motion(`${poses(4)}]`).slice(0, -1)}, "options": {"objective": "link_angle"}}`,
  "a case without its pivots": line("four_point_pivots", '"pole_distance": 1'),
  "a case without contacts": line("mixed", '"input_pivot": [0, 1]'),
  "a line without a case": line("mixed", "").replace('"case": "mixed",', "").replace(", }", "}"),
  "the same pivot twice": line("four_point_pivots", pivots("[0, -1]")),
  "a pole on the line": line("pole_at_fixed_pivot", `${pivots("[1, 0]")}, "output_arm": 1`),
  "an output link without length": line("pole_at_fixed_pivot", '"pole_distance": 1, "output_arm": 0'),
  "a pole at the point": line("five_point", '"pole_distance": 0, "point_ray_deg": 90'),
  "a cubic of no size": line("four_point_cubic", '"pole_distance": 1, "point_ray_deg": 60, "cubic_n": 0'),
  "a pivot at the point": line("ball_point_on_side_link", '"input_pivot": [0, 0]'),
  "a frame without length": line("isosceles_trapezoid", '"half_frame": 0'),
  "a coupler without length": line("parallel_side_links", '"input_offset": 1, "output_offset": 1'),
  "contacts that are none": contacts('{"s": 1, "multiplicity": 5, "side": 2}, {"s": 0, "multiplicity": 1}'),
  "a hundred and one contacts": contacts(Array.from({length: 101}, (_, i) => `{"s": ${i}}`).join(", ")),
  "a lambda without a stroke": line("symmetric_lambda", '"stroke": 0, "crank_range_deg": 300'),
  "a strip as wide as it is long": line("search", '"stroke": 1, "deviation": 1'),
  "limits of a line below zero": line(
    "six_point",
    '"pole_distance": 1',
    ', "requirements": {"min_stroke": -1, "max_deviation": 0}',
  ),
  "a strip without width": line("six_point", '"pole_distance": 1', ', "options": {"deviation": 0}'),
  "a strip beside no line": `${motion(`${poses(4)}]`).slice(0, -1)}, "options": {"deviation": 1}}`,
  "tolerances below zero": made('"length": {"input": -1}, "clearance": -1, "driver_deg": 91'),
  "tolerances of no sample": made('"length": 1, "samples": 10, "seed": -1'),
  "tolerances of nothing": made('"length": 0, "turning_length": -1, "cost": {"exponent": 0}'),
  "tolerances of arcs in the plane": made('"link_angle_deg": 1, "limit": {"deviation": 1}'),
  "tolerances of lengths on a sphere": `{"linkwright": 1, "tolerances": {"length": 1}, "task": {"kind": "motion",
    "mechanism": "spherical_four_bar", "orientations": [${[0, 10, 25, 45].map((x) => `{"euler_deg": [${x}, ${x}, 0], "sequence": "zyx"}`).join(", ")}]}}`,
  "limits that are none": made('"length": 1, "limit": {"position": 0}'),
  "a limit of half a turn and more": made('"length": 1, "limit": {"angle_deg": 181}'),
  "a limit of no deviation": made('"length": 1, "limit": {"deviation": 0}'),
  "two limits": made('"length": 1, "limit": {"position": 1, "angle_deg": 1}'),
  "requirements of tolerances out of range": made(
    '"length": 1, "limit": {"position": 1}',
    ', "requirements": {"max_tolerance_error": 0, "min_yield": 2}',
  ),
  "requirements without tolerances": lengths('"max_tolerance_error": 1'),
  "a yield without a limit": made('"length": 1', ', "requirements": {"min_yield": 0.5}'),
  "tolerances of a search": line(
    "search",
    '"stroke": 100, "deviation": 1',
    ', "tolerances": {"length": 1}, "options": {"objective": "tolerance_error"}',
  ),
  "a front of one": front('"size"'),
  "a front of the same twice": front('"size", "size"'),
  "a front of structural errors": front('"size", "structural_error"'),
  "a front of a search": front('"size", "link_ratio"', chain("[2, -5]").replace(/, "chain": .*$/, "}}")).replace(
    '"pareto"',
    '"box": {"x": [-9, 9], "y": [-9, 9]}, "pareto"',
  ),
  "a linkage of nothing": linkage(""),
  "a linkage of another mechanism": linkage('"mechanism": "cam", "lengths": {}'),
  "a linkage that does not close": linkage('"lengths": {"ground": 9, "input": 1, "coupler": 1, "output": 1}'),
  "a linkage with a length below zero": linkage('"lengths": {"ground": -9, "input": 1, "coupler": 1, "output": 1}'),
  "a linkage with two pivots in one": linkage(pins("[0, 0]")),
  "a linkage with a pivot far away": linkage(pins("[0, 1e15]")),
  "a linkage with six poses": linkage(`${pins("[0, 1]")}, "poses": [${poses(6)}]`),
  "a linkage with a slider": linkage(`"input": {"center_point": [0, 0], "circle_point": null},
    "output": {"center_point": [4, 0], "circle_point": [5, 3]}`),
  "a six-bar with a link of one hinge": six_bar("", "0-3"),
  "a six-bar with a hinge far away": six_bar(", [0, 1e15]", "0-3"),
  "a six-bar with two hinges in one": six_bar(", [4, 0]", "0-3"),
  "a six-bar of other links": six_bar(", [2, 2]", "0-1"),
  "a six-bar with a point": six_bar(", [2, 2]", "0-3", ', "point": [0, 0]'),
  "a spherical linkage of nothing": linkage('"mechanism": "spherical_four_bar"'),
  "a spherical linkage that does not close": arcs(100, 30),
  "a spherical linkage of more than a turn": arcs(30, 150),
  "a spherical linkage with a link of half a turn": arcs(180, 80),
  "a spherical linkage with two axes in one": linkage(`"mechanism": "spherical_four_bar", "axes": {
    "input_fixed": [0, 0, 1], "input_moving": [0, 0, 1], "output_moving": [1, 1, 1], "output_fixed": [1, 0, 0]}`),
  "a spherical linkage with a point": arcs(80, 60, ', "point": [0, 0]'),
  "a spherical linkage with six orientations": arcs(
    80,
    60,
    `, "orientations": [${[0, 1, 2, 3, 4, 5].map((x) => `{"euler_deg": [${x}, 0, 0], "sequence": "zyx"}`).join(", ")}]`,
  ),
  "a path of points alone": path(passed(5)),
  "a path of four points about a pivot": path(passed(4), pivot),
  "a path of four points about two pivots": path(passed(4), `${pivot}, "output": [9, 5]`),
  "a path of six points about a pivot": path(passed(6), pivot),
  "a path of six points about two pivots": path(passed(6), `${pivot}, "output": [9, 5]`),
  "a path of two points about two pivots": path(passed(2), `${pivot}, "output": [9, 5]`),
  "a path through a point three times": path(
    [
      [0, 0],
      [3, 1],
      [0, 0],
      [7, 2],
      [0, 0],
    ]
      .map(([x, y]) => `{"x": ${x}, "y": ${y}}`)
      .join(", "),
    pivot,
  ),
  "a path about a pivot that is not there": path(passed(5), ""),
  "a path through a pivot": path(passed(5), '"input": [2, 4]'),
  "a path about two pivots in one": path(passed(3), `${pivot}, "output": [1, 5]`),
  "a path with pivots and angles": path(angled("input", 3, 2), pivot),
  "a path of five timed points about a pivot": path(angled("input", 5, 0), pivot),
  "a path of three angles and a point": path(angled("theta", 3, 1)),
  "a path of poses alone": path(angled("theta", 4, 0)),
  "a path with both angles at a point": path(
    `${angled("theta", 3, 2)}, {"x": 9, "y": 1, "input_deg": 1, "theta_deg": 2}`,
  ),
  "a path with angles of both links": path(`${angled("theta", 3, 2)}, {"x": 9, "y": 1, "input_deg": 1}`),
  "a path with a pose twice": path(`{"x": 0, "y": 0, "theta_deg": 360}, ${angled("theta", 2, 2)}`),
  "a path with a pose's direction without its rate": path(
    `{"x": 9, "y": 9, "theta_deg": 5, "derivatives": [{"x": 1, "y": 0}]}, ${angled("theta", 1, 2)}`,
  ),
  "a path with the coupler's rate and no angle": path(
    `{"x": 9, "y": 9, "derivatives": [{"x": 1, "y": 0, "theta": 1}]}, ${angled("theta", 3, 0)}`,
  ),
  "a path with a direction between two pivots": path(
    passed(3, '{"x": 9, "y": 9, "derivatives": [{"x": 1, "y": 0}]}'),
    `${pivot}, "output": [9, 5]`,
  ),
  "a path through a point twice between two pivots": path(passed(4, '{"x": 1, "y": 1}'), `${pivot}, "output": [9, 5]`),
  "a path with the crank's rate and no angle": path(
    passed(3, '{"x": 9, "y": 9, "derivatives": [{"x": 1, "y": 0, "input": 1}]}'),
    pivot,
  ),
  "a path on which the point rests": path(passed(3, '{"x": 9, "y": 9, "derivatives": [{"x": 0, "y": 0}]}'), pivot),
  "a path through a point twice at once": path(passed(4, '{"x": 3, "y": 9}'), pivot),
  "a shortest link longer than the longest": lengths('"min_length": 5, "max_length": 4'),
};
const texts = [...files, ...Object.entries(further).map(([name, text]) => ({name, text}))];

/** Sentences that no text provokes: what JSON cannot say or a reader catches, and what the page finds itself. */
const unprovoked = [
  "too_many_near_points",
  "too_many_near_poses",
  "too_many_path_points",
  "motion_pose_count",
  "pose_count",
  "not_available",
  "limits_finite",
  "axis_finite",
  "force_range",
  "no_dyads",
  "no_four_bar",
  "not_utf8",
];

/** The codes in the sources of what reads and checks problem files: those before a place, and those of a value read. */
function codes_of_sources(): string[] {
  const sources = readdirSync(`${root}src`, {recursive: true, encoding: "utf8"}).filter(
    (name) =>
      name.endsWith(".cpp") &&
      !/^sweep\/|attitude|files\/(linkage|text|stored_linkage)|kinds\/(six_bar\/six_bar_(reader|solve)|spherical\/spherical_reader)|synthesis\/(solve|picked_place)/.test(
        name,
      ),
  );
  const made =
    /\b(?:mistake|mistakes_?(?:\.|->)add)\(\s*"(\w+)"|(?:[{(]\s*|"(\w+)" : )"(\w+)",\s+(?:place|here|where|asked\.place|"tolerances|"--(?:pin|thickness)"|fmt::format\("--|"task\.|"options\.|"requirements\.|"linkwright"|fmt::format\("task\.)/g;
  return sources.flatMap((name) =>
    [...readFileSync(`${root}src/${name}`, "utf8").matchAll(made)].flatMap((found) => found.slice(1).filter(Boolean)),
  );
}

/** Numbers at three digits, as the page tells them. */
const shortened = (text: string) =>
  text.replace(/\d+(\.\d+)?(e[+-]\d+)?/g, (number) => String(Number(Number(number).toPrecision(3))));
const without_place = (mistake: Mistake) => mistake_text({...mistake, place: ""});

describe("the engine's sentences about files", () => {
  it("are the program's in English", () => {
    expect(existsSync(program), "build/release is built first").toBe(true);
    for (const name of ["missing_angle.json", "trailing_comma.json", "three_poses.json"]) {
      let said = "";
      try {
        execFileSync(program, ["solve", folder + name, "-o", "-"], {encoding: "utf8", stdio: "pipe"});
      } catch (error) {
        said = (error as {stderr: string}).stderr;
      }
      for (const mistake of read(readFileSync(folder + name, "utf8"))) expect(said).toContain(mistake_text(mistake));
    }
  });
  it.each(texts)("are their texts with their values: $name", ({text}) => {
    const mistakes = read(text);
    expect(mistakes.length).toBeGreaterThan(0);
    for (const mistake of mistakes) {
      expect(en, mistake.message).toHaveProperty([`mistake.${mistake.code}`]);
      expect(shortened(without_place(mistake))).toBe(shortened(mistake.message));
    }
  });
  it.each(asked_of_plates)("are their texts where plates cannot be made: $sizes", (asked) => {
    const mistakes = of_plates(asked);
    expect(mistakes.length).toBeGreaterThan(0);
    for (const mistake of mistakes) {
      preferences.language = "en";
      expect(shortened(without_place(mistake))).toBe(shortened(mistake.message));
      preferences.language = "zh";
      expect(without_place(mistake)).toMatch(/\p{Script=Han}/u);
    }
  });
  it.each(drawings)("are their texts where a drawing cannot be read: %o", (asked) => {
    const mistakes = of_drawing(asked);
    expect(mistakes).toHaveLength(1);
    expect(without_place(mistakes[0]!)).toBe(mistakes[0]!.message);
    preferences.language = "zh";
    expect(mistake_text(mistakes[0]!)).toMatch(/^[^a-z]*\p{Script=Han}[^a-z]*(<svg>)?[^a-z]*$/u);
  });
  it("all have a text", () => {
    const codes = codes_of_sources();
    expect(codes.length).toBeGreaterThan(90);
    expect(codes.filter((code) => !(`mistake.${code}` in en))).toEqual([]);
  });
  it("are all that there are texts for", () => {
    const mistakes = [
        ...texts.flatMap(({text}) => read(text)),
        ...asked_of_plates.flatMap(of_plates),
        ...drawings.flatMap(of_drawing),
      ],
      provoked = new Set(mistakes.map(({code}) => code));
    const worded = Object.keys(en).flatMap((key) => (key.startsWith("mistake.") ? [key.slice("mistake.".length)] : []));
    expect(worded.filter((code) => !provoked.has(code)).sort()).toEqual(unprovoked.sort());
  });
  it.each(texts)("are Chinese in Chinese: $name", ({text}) => {
    preferences.language = "zh";
    const mistakes = read(text);
    expect(mistakes.length).toBeGreaterThan(0);
    for (const mistake of mistakes) {
      const said = mistake_text(mistake).slice(mistake.place.startsWith("line") ? 0 : mistake.place.length);
      expect(said).toMatch(/\p{Script=Han}/u);
      expect(
        said.replace(
          /"[^"]*"|linkwright attitude convert|JSON|UTF|NaN|Infinity|null|true|false|Linkwright|no_defects|poses|pairs|(in|out)put_deg|MiB|theta|\b[xyτ]\b|\\[nt]/g,
          "",
        ),
        mistake.message,
      ).not.toMatch(/[a-z]{3}/i);
    }
  });
  it("are told in the engine's words where there is no text", () => {
    preferences.language = "zh";
    const mistake = {code: "quite_new", place: "task", values: {}, message: "this is quite new"};
    expect(mistake_text(mistake)).toBe("task：this is quite new");
  });
  it("keep what a file says as it stands there", () => {
    preferences.language = "zh";
    const [mistake] = read(lengths('"types": ["{name}, number and input"]'));
    expect(mistake_text(mistake!)).toContain('"{name}, number and input"');
  });
  it("are counted where there are many", () => {
    const many: Mistake[] = Array.from({length: 7}, (_, i) => ({
      code: "missing_key",
      place: `task.poses[${i}].x`,
      values: {what: "number"},
      message: "this is missing; add a number",
    }));
    const told = mistakes_text(many);
    expect(told).toContain("task.poses[2].x: this is missing; add a number.");
    expect(told).not.toContain("task.poses[3]");
    expect(told).toMatch(/4 more/);
  });
});
