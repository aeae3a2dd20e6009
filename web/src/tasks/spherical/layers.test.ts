// Shells so that no hub stands in a link's way: what collides in a state is told, and avoided where it can be.
import {describe, expect, it} from "vitest";
import {arc, identity, unit, type Vec3} from "../../sphere/vectors";
import {approaches, clashes, laid_out} from "./layers";
import {fitting_sizes, usual_sizes, type ShellOrder} from "./print";
import type {Stand} from "./space";

const stand: Stand = {
  input_fixed: [0, 0, 1],
  input_moving: unit([1, 0.2, 1]),
  output_moving: unit([0.2, 1, 0.8]),
  output_fixed: unit([-0.9, 0.4, 0.7]),
  turn: identity,
};
const order: ShellOrder = ["ground", "input", "coupler", "output"];
/** Three axes at rest; the coupler's end passes over the ground link, or not. */
const swung = (points: readonly Vec3[]): Stand[] => points.map((input_moving) => ({...stand, input_moving}));
const over_ground = swung(arc(unit([0.4, 0.9, 0]), unit([0.6, 0, 1]), -1.2));

describe("links on shells", () => {
  it("collide where a link meets a hub that comes through its shell, and are named", () => {
    // the output's fixed axis is joined from the innermost to the outermost shell: past input and coupler
    const states = swung([stand.input_moving, stand.output_fixed]),
      found = clashes(order, approaches(states), usual_sizes, [0, 1]);
    expect(found).toContainEqual({links: ["input", "ground"], state: 1});
    expect(found.filter(({state}) => state === 0)).toEqual([]);
    expect(clashes(order, approaches(states), usual_sizes, [0, 0])).toEqual([]);
  });
  it("do not collide where the hub stays below or begins above", () => {
    const states = swung([stand.output_fixed]),
      inside_out: ShellOrder = ["ground", "output", "input", "coupler"]; // joined before the input's shell
    expect(clashes(inside_out, approaches(states), usual_sizes, [0, 0]).map(({links}) => links[0])).not.toContain(
      "input",
    );
  });
  it("have less room on a smaller shell", () => {
    const states = swung(over_ground.map(({input_moving}) => input_moving)),
      count = (inner: number) =>
        clashes(order, approaches(states), {...usual_sizes, inner}, [0, states.length - 1]).length;
    expect(count(20)).toBeGreaterThan(count(200));
  });
  it("are laid so that nothing collides in any state, as small as that can be", () => {
    const found = laid_out([stand], null, fitting_sizes(stand));
    expect(found.clashes).toEqual([]);
    expect(found.sizes).toEqual(fitting_sizes(stand));
  });
  it("are laid for the positions where all of the travel cannot be had, and the rest is told", () => {
    const through_all: Stand = {
      ...stand,
      input_moving: stand.output_fixed,
      output_moving: stand.input_fixed,
    };
    const found = laid_out([stand, stand, through_all], [0, 1], fitting_sizes(stand));
    expect(found.clashes.length).toBeGreaterThan(0);
    expect(found.clashes.every(({state}) => state === 2)).toBe(true);
    expect(laid_out([through_all], null, fitting_sizes(stand)).clashes.length).toBeGreaterThan(0);
  });
});
