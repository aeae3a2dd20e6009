// A small picture to each term, on a field of 96 × 64: strokes with a role that the style colours.
export type Role =
  | "input"
  | "output"
  | "body"
  | "driver" // links
  | "thin"
  | "dash"
  | "curve"
  | "arrow"
  | "ground"
  | "pivot" // what is drawn about them
  | "good"
  | "bad"
  | "good_fill"
  | "bad_fill"
  | "frame"
  | "accent";
export type Stroke = readonly [role: Role, d: string];
type Spot = readonly [x: number, y: number];

const at = ([x, y]: Spot) => `${x} ${y}`;
const line = (role: Role, ...spots: Spot[]): Stroke => [role, `M${spots.map(at).join("L")}`];
const ring = (role: Role, [x, y]: Spot, r: number): Stroke => [
  role,
  `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`,
];
const pin = (spot: Spot): Stroke => ring("pivot", spot, 2.4);
const ground = ([x, y]: Spot): Stroke => ["ground", `M${x} ${y}l-4.2 6.5h8.4z`];
const box = (role: Role, x: number, y: number, width: number, height: number): Stroke => [
  role,
  `M${x} ${y}h${width}v${height}h${-width}z`,
];
const cross = ([x, y]: Spot, r = 4): Stroke => [
  "bad",
  `M${x - r} ${y - r}l${2 * r} ${2 * r}M${x - r} ${y + r}l${2 * r} ${-2 * r}`,
];
/** Fixed pivot of the input, moving pivots, fixed pivot of the output. */
type Bars = readonly [Spot, Spot, Spot, Spot];
const links = ([a0, a, b, b0]: Bars): Stroke[] => [line("input", a0, a), line("output", b0, b), line("body", a, b)];
const four_bar = (bars: Bars, ...about: Stroke[]): Stroke[] => [
  ground(bars[0]),
  ground(bars[3]),
  ...about,
  ...links(bars),
  ...bars.map(pin),
];
/** A ball with a four-bar of arcs on it: as four pins, and the arcs between them. */
const sphere: readonly Stroke[] = [ring("thin", [48, 32], 28), ["thin", "M20 32A28 8 0 0 0 76 32"]];
const axis_ends: Bars = [
  [38, 12],
  [30, 40],
  [60, 46],
  [64, 18],
];
const spherical_four_bar = (...about: Stroke[]): Stroke[] => [
  ...sphere,
  ...about,
  ["input", "M38 12Q28 25 30 40"],
  ["output", "M64 18Q71 33 60 46"],
  ["body", "M30 40Q44 49 60 46"],
  ...axis_ends.map(pin),
];
/** A body in a position, as a small tilted plate. */
const plate = (role: Role, [x, y]: Spot, turn: number, size = 7): Stroke => {
  const c = size * Math.cos(turn),
    s = size * Math.sin(turn),
    corner = (u: number, v: number): Spot => [
      Math.round(10 * (x + u * c - v * s)) / 10,
      Math.round(10 * (y + u * s + v * c)) / 10,
    ];
  return [role, `M${[corner(-1, -0.6), corner(1, -0.6), corner(1, 0.6), corner(-1, 0.6)].map(at).join("L")}Z`];
};

const crank_rocker: Bars = [
  [32.7, 37.6],
  [38.3, 22.2],
  [79.7, 6],
  [79.5, 37.6],
];
const usual: Bars = [
  [24, 50],
  [18, 22],
  [62, 12],
  [72, 50],
];
const locked: Bars = [
  [16, 50],
  [38, 34],
  [78, 18],
  [66, 50],
]; // coupler and output in one line
const dead: Bars = [
  [14, 50],
  [24, 26],
  [52, 38],
  [80, 50],
];
const odd = "M4 52C20 50 26 14 44 14S58 46 92 10",
  oval = "M60 40c0-9 8-14 16-14s14 6 14 13s-6 13-14 13s-16-4-16-12z";

export const pictures = {
  solution_region: [
    box("frame", 20, 6, 52, 52),
    ["good_fill", "M24 34c6-14 18-22 26-16s2 18-8 22s-20 8-18-6z"],
    ["good_fill", "M56 42c4-6 12-8 13-2s-6 12-11 10s-5-4-2-8z"],
    ring("accent", [44, 28], 3.4),
    line("dash", [20, 28], [72, 28]),
    line("dash", [44, 6], [44, 58]),
  ],
  branch_infinity: [["curve", odd], line("arrow", [4, 52], [0, 53]), line("arrow", [92, 10], [96, 6]), ["thin", oval]],
  branch_closed: [
    ["thin", odd],
    ["curve", oval],
  ],
  dead_point: four_bar(dead, ["dash", "M24 26L80 50"], ring("bad", [52, 38], 6)),
  change_point: [
    ground([14, 36]),
    ground([74, 36]),
    line("input", [14, 36], [38, 36]),
    line("body", [38, 33.5], [86, 33.5]),
    line("output", [74, 38.5], [86, 36]),
    ["thin", "M38 36L52 16M38 36L52 56"],
    ...(
      [
        [14, 36],
        [38, 36],
        [86, 35],
        [74, 37],
      ] as Spot[]
    ).map(pin),
  ],
  // Chebyshev's linkage, and Hoecken's that traces the same path.
  cognates: [
    ...[20, 48, 76].map((x) => ground([x, 54])),
    line("thin", [48, 54], [27, 30], [6, 54], [20, 54]),
    line("thin", [27, 30], [48, 6]),
    ...links([
      [20, 54],
      [62, 6],
      [34, 6],
      [76, 54],
    ]),
    ring("accent", [48, 6], 3.4),
    ...(
      [
        [20, 54],
        [62, 6],
        [34, 6],
        [76, 54],
        [48, 54],
        [27, 30],
        [6, 54],
      ] as Spot[]
    ).map(pin),
  ],
  transmission_angle: four_bar(usual, ["accent", "M50.3 14.6A12 12 0 0 0 64.9 23.7"]),
  link_ratio: [
    line("input", [12, 24], [84, 24]),
    line("output", [12, 42], [30, 42]),
    ...(
      [
        [12, 24],
        [84, 24],
        [12, 42],
        [30, 42],
      ] as Spot[]
    ).map(pin),
  ],
  driver_sweep: four_bar(crank_rocker, ["accent", "M38.3 22.2A16.4 16.4 0 0 0 18 30"], ["dash", "M32.7 37.6L18 30"]),
  center_curve: [["curve", odd], ground([44, 14]), line("input", [44, 14], [64, 40]), pin([44, 14]), pin([64, 40])],
  circle_curve: [["dash", odd], ground([66, 52]), line("input", [66, 52], [44, 14]), pin([66, 52]), pin([44, 14])],
  pole: [
    plate("thin", [22, 20], 0.1),
    plate("body", [74, 26], 1.2),
    ["dash", "M22 20L46 52L74 26"],
    ring("accent", [46, 52], 3),
  ],
  node: [["curve", "M6 58C40 46 62 40 62 24S46 8 42 22S70 50 92 52"], ring("accent", [51.5, 40.5], 4)],
  slider: [
    line("thin", [10, 14], [86, 40]),
    ["frame", "M40.8 19.5l11.4 4l-2.6 7.6l-11.4-4z"],
    line("body", [46, 26], [58, 52]),
    pin([46, 26]),
    pin([58, 52]),
  ],
  fixed_pivot: four_bar(usual, ring("accent", [24, 50], 6), ring("accent", [72, 50], 6)),
  moving_pivot: four_bar(usual, ring("accent", [18, 22], 6), ring("accent", [62, 12], 6)),
  coupler_curve: four_bar(
    [
      [20, 54],
      [14, 34],
      [58, 30],
      [70, 54],
    ],
    ["dash", "M16 20C26 2 70 0 74 14S40 26 16 20z"],
    ["thin", "M14 34L36 12L58 30"],
    ring("accent", [36, 12], 3),
  ),
  input_link: four_bar(usual, ["arrow", "M12 38A14 14 0 0 1 14 30"], ring("accent", [21, 36], 9)),
  mirror: four_bar(usual, ["arrow", "M82 44A14 14 0 0 0 80 32"], ring("accent", [67, 31], 9)),
  error: [plate("thin", [44, 34], 0.3, 16), plate("body", [47, 32], 0.34, 16), line("accent", [58, 50], [66, 56])],
  checked: [...four_bar(usual, plate("thin", [30, 8], 0), plate("thin", [50, 8], 0.3)), ["good", "M76 12l5 6l9-12"]],
  halo: [box("good_fill", 24, 12, 44, 40), plate("body", [46, 32], 0.3), ["arrow", "M46 32L62 22"]],
  order_defect: [
    ["dash", "M10 48C24 8 70 8 86 48"],
    plate("thin", [14, 40], -0.9),
    plate("thin", [36, 20], -0.3),
    plate("bad", [60, 20], 0.3),
    plate("thin", [82, 40], 0.9),
    ["bad", "M60 8C52 2 44 2 38 8"],
  ],
  branch_defect: four_bar(locked, cross([78, 18], 5), ["dash", "M78 18C88 28 86 40 80 46"]),
  circuit_defect: four_bar(
    [
      [24, 34],
      [30, 14],
      [66, 10],
      [72, 34],
    ],
    ["dash", "M30 14L62 56L72 34"],
    ["bad", "M44 30l8 6M44 36l8-6"],
  ),
  no_defects: [
    ["curve", "M10 48C24 8 70 8 86 48"],
    plate("good", [14, 40], -0.9),
    plate("good", [36, 20], -0.3),
    plate("good", [60, 20], 0.3),
    plate("good", [82, 40], 0.9),
  ],
  crank_rocker: four_bar(crank_rocker, ring("dash", [32.7, 37.6], 16.4), ["accent", "M81.5 24.8A13 13 0 0 0 69 30"]),
  rocker_crank: four_bar(
    [
      [17.7, 37.6],
      [14.9, 6],
      [55.9, 23.7],
      [64.6, 37.6],
    ],
    ["accent", "M28.2 30A13 13 0 0 0 15.7 24.8"],
    ring("dash", [64.6, 37.6], 16.4),
  ),
  double_crank: four_bar(
    [
      [41.6, 32],
      [47.4, 10.3],
      [67.5, 13],
      [52.9, 32],
    ],
    ring("dash", [41.6, 32], 22.5),
    ring("dash", [52.9, 32], 24),
  ),
  double_rocker: four_bar(
    [
      [23, 48.7],
      [33, 11.3],
      [50.3, 14.3],
      [73, 48.7],
    ],
    ["accent", "M34.5 42.6A13 13 0 0 0 25 35.9"],
    ["accent", "M69.6 36.1A13 13 0 0 0 61.2 43.2"],
    ring("dash", [42, 13], 9),
  ),
  triple_rocker: spherical_four_bar(
    ["accent", "M24 34A10 10 0 0 0 33 50"],
    ["accent", "M54 51A10 10 0 0 0 68 40"],
    ["dash", "M38 12Q52 8 64 18"],
  ),
  spherical_four_bar: spherical_four_bar(
    ["dash", "M38 12L48 32L64 18"],
    ["dash", "M30 40L48 32L60 46"],
    ring("accent", [48, 32], 2.4),
  ),
  fixed_axis: spherical_four_bar(["accent", "M33 2L63 62"], ["accent", "M76 7.5L20 56.5"]),
  moving_axis: spherical_four_bar(["accent", "M16 46.2L80 17.8"], ["accent", "M65 52L31 18"]),
  link_angle: spherical_four_bar(["dash", "M38 12L48 32L30 40"], ["accent", "M44.4 24.8A8 8 0 0 0 40.7 35.2"]),
  triple_rocker_ground: [
    line("bad", [18, 42.8], [78, 42.8]),
    ...four_bar([
      [18, 42.8],
      [35.2, 18.3],
      [60.2, 17.2],
      [78, 42.8],
    ]),
  ],
  triple_rocker_input: [
    ...four_bar([
      [33.1, 54],
      [33.1, 6],
      [51.2, 26.7],
      [62.9, 54],
    ]),
    line("bad", [30, 54], [30, 6]),
  ],
  triple_rocker_coupler: [
    ...four_bar([
      [43.7, 47.6],
      [19.8, 27.5],
      [73.7, 16.4],
      [76.2, 47.6],
    ]),
    line("bad", [19, 24.5], [73, 13.4]),
  ],
  triple_rocker_output: [
    ...four_bar([
      [35.1, 54],
      [29.9, 24.6],
      [51.7, 6],
      [66.1, 54],
    ]),
    line("bad", [54.8, 5], [69.2, 53]),
  ],
  structural_error: [
    ["curve", "M8 54C30 50 60 34 88 8"],
    ["dash", "M8 52C24 54 40 40 50 36S76 22 88 10"],
    line("accent", [34, 43.4], [34, 47.4]),
  ],
  precision_points: [
    ["curve", "M8 54C30 50 60 34 88 8"],
    ...(
      [
        [18, 52.3],
        [39, 44.4],
        [62, 30.6],
        [81, 14.4],
      ] as Spot[]
    ).map((spot) => ring("accent", spot, 2.8)),
  ],
  watt_1: [
    ground([16, 50]),
    ground([46, 52]),
    ["body", "M16 50L20 24L34 34Z"],
    ["body", "M20 24L52 12L48 28Z"],
    line("input", [46, 52], [48, 28]),
    line("output", [34, 34], [62, 40]),
    line("driver", [52, 12], [80, 20]),
    line("thin", [80, 20], [62, 40]),
    ...(
      [
        [16, 50],
        [46, 52],
        [20, 24],
        [34, 34],
        [52, 12],
        [48, 28],
        [62, 40],
        [80, 20],
      ] as Spot[]
    ).map(pin),
  ],
  stephenson: [
    ground([12, 48]),
    ground([50, 52]),
    ground([86, 48]),
    line("input", [12, 48], [20, 20]),
    ["body", "M20 20L56 26L44 8Z"],
    line("output", [56, 26], [50, 52]),
    line("driver", [44, 8], [78, 18]),
    line("thin", [78, 18], [86, 48]),
    ...(
      [
        [12, 48],
        [20, 20],
        [56, 26],
        [44, 8],
        [50, 52],
        [78, 18],
        [86, 48],
      ] as Spot[]
    ).map(pin),
  ],
  elbow: [
    ground([20, 52]),
    line("driver", [20, 52], [34, 16]),
    line("body", [34, 16], [76, 34]),
    ["dash", "M20 52L62 58L76 34M20 52L76 34"],
    pin([20, 52]),
    pin([34, 16]),
    pin([76, 34]),
  ],
  pattern: [
    plate("body", [16, 44], -0.6),
    plate("body", [40, 22], -0.2),
    ["arrow", "M40 22L58 16"],
    plate("body", [78, 40], 0.7),
  ],
  tolerance: [
    line("body", [20, 32], [70, 32]),
    pin([20, 32]),
    pin([70, 32]),
    ["dash", "M62 14L62 50M78 14L78 50"],
    ["arrow", "M70 48L78 48"],
    ["arrow", "M70 48L62 48"],
  ],
  tolerance_error: [
    plate("thin", [40, 32], 0.16, 14),
    plate("thin", [50, 30], 0.36, 14),
    plate("thin", [44, 36], 0.24, 14),
    plate("body", [45, 32], 0.26, 14),
    ring("accent", [45, 32], 9),
  ],
  yield: [
    ["curve", "M10 54C30 54 34 10 48 10S66 54 86 54"],
    ["dash", "M30 8L30 56M66 8L66 56"],
    ["good", "M43 36l4 5l8-10"],
    cross([78, 40], 4),
  ],
  clearance: [ring("body", [48, 32], 22), ring("pivot", [53, 32], 14), ["arrow", "M48 32L53 32"]],
  missed_pose: [plate("thin", [40, 34], 0.2, 14), plate("bad", [52, 28], 0.4, 14), ["arrow", "M40 34L52 28"]],
  tolerance_share: [
    ["accent", "M14 14h66"],
    ["accent", "M14 26h40"],
    ["thin", "M14 38h14"],
    ["thin", "M14 50h4"],
    ["thin", "M14 8v48"],
  ],
  worst_case: [
    ["thin", "M8 56h80"],
    ["curve", "M10 56Q20 52 28 34Q36 14 44 14Q52 14 60 34Q66 50 72 55"],
    ["bad", "M82 48V60"],
    ["arrow", "M72 55L81 55"],
  ],
  pareto_front: [
    ["thin", "M12 6V58H90"],
    ["accent", "M20 50Q50 48 66 34Q80 22 82 10"],
    ring("thin", [34, 36], 2),
    ring("thin", [44, 26], 2),
    ring("thin", [28, 24], 2),
    ring("thin", [58, 18], 2),
    ring("good_fill", [66, 34], 3),
  ],
  loads: [plate("body", [40, 24], -0.3), ["arrow", "M48 22L48 48"], ["accent", "M22 56L36 30"], ground([22, 56])],
  hand_force: [
    ground([18, 52]),
    line("body", [18, 50], [76, 26]),
    pin([18, 50]),
    ["arrow", "M76 26L68 6"],
    ["dash", "M78 42Q74 18 60 4"],
  ],
  hold_open: [
    ground([20, 54]),
    line("body", [20, 52], [34, 8]),
    pin([20, 52]),
    ["arrow", "M34 8L20 6"],
    ["dash", "M34 8Q74 14 78 50"],
  ],
  gas_spring: [
    box("body", 10, 26, 44, 12),
    line("body", [54, 32], [84, 32]),
    pin([8, 32]),
    pin([86, 32]),
    ["arrow", "M60 48L84 48"],
  ],
} as const satisfies Record<string, readonly Stroke[]>;

export type TermName = keyof typeof pictures;
