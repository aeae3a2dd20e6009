/** What a problem file means where it is silent: what the schema says (defaults.test.ts). */
export const defaults = {
  given: {directed: true, at_infinity: false},
  function: {interpolation: "monotone_cubic", points: 4, spacing: "chebyshev"},
  output_scale: {range: [0.5, 2]},
  requirements: {no_defects: true, max_link_ratio: 20, respect_direction: true},
  options: {spacing: "coordinate", seed: 1, effort: 200_000, best: 10},
} as const;

/** The default of max_length, in characteristic lengths of the task. */
export const default_max_length = 10;
