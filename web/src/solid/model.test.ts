// Machines of all kinds as they are drawn: the engine's parts, which stand where the flat drawing has the linkage.
import {Box3, Mesh, MeshBasicMaterial, Vector3, type Object3D} from "three";
import {beforeAll, describe, expect, it} from "vitest";
import type {Machine, Point} from "../contract/messages";
import {load_module} from "../engine/node";
import {Engine} from "../engine/serve";
import {at_angle} from "../figure/mechanism";
import {examples} from "../gallery/gallery";
import {angle_of_row, row_count, travel} from "../state/drive";
import {engine_text} from "../state/problem";
import {load_views, task_view} from "../kinds/view_dispatch";
import {SolidModel, type SolidColor} from "./model";

let engine: Engine;
beforeAll(async () => {
  engine = new Engine(await load_module());
  await load_views();
});

const outline: Point[] = [
  [-20, -10],
  [20, -10],
  [20, 10],
];
function made(name: string) {
  const {problem} = examples.find((one) => one.name === name)!,
    text = engine_text(problem),
    {tau} = engine.ask("best", {problem: text, most: 1}).linkages[0]!,
    {linkage} = engine.ask("linkage", {problem: text, tau}),
    machine = engine.ask("machine", {problem: text, tau, sizes: {}}),
    {mechanism} = task_view(problem.task),
    figure_at = (angle: number) =>
      mechanism.figure(linkage, at_angle(mechanism, linkage, linkage.drive!, angle), outline),
    painted: (SolidColor | "sheet")[] = [];
  const model = new SolidModel({machine, figure: figure_at(machine.at_deg)}, (color, opacity = 1) => {
    painted.push(opacity < 1 ? "sheet" : color);
    return new MeshBasicMaterial();
  });
  return {linkage, machine, figure_at, model, painted};
}
const group_of = ({layers}: Machine, model: SolidModel, name: string): Object3D =>
  model.object.children[layers.findIndex(({body}) => body === name)]!;

describe.each(["tailgate", "log_generator", "straight_luffing_crane", "wheel_loader"])(
  "a planar machine: %s",
  (name) => {
    it("has its links where the flat drawing has them", () => {
      const {linkage, machine, figure_at, model} = made(name),
        {gap} = machine.sizes;
      const drive = linkage.drive!;
      for (let row = 0; row < row_count(drive); row += 7) {
        const angle = angle_of_row(drive, row);
        model.move(angle);
        model.object.updateMatrixWorld();
        const first = figure_at(machine.at_deg),
          now = figure_at(angle);
        for (const [k, {at, joins}] of first.joints.entries())
          for (const body of joins.filter((name) => name)) {
            const there = group_of(machine, model, body).localToWorld(new Vector3(...at, 0)),
              [x, y] = now.joints[k]!.at;
            expect(Math.hypot(there.x - x, there.y - y)).toBeLessThan(gap / 2);
          }
      }
    });
    it("paints its plates as the drawing paints the links, and carries the body's outline on the guided one", () => {
      const {machine, model, figure_at, painted} = made(name),
        is_guided = figure_at(0).guided !== null,
        pins = machine.parts.length - machine.layers.length;
      expect(painted[0]).toBe("curve");
      expect(painted.slice(1, machine.layers.length)).not.toContain("curve");
      expect(painted.filter((color) => color === "ink2")).toHaveLength(pins);
      expect(painted.filter((color) => color === "sheet")).toHaveLength(is_guided ? 2 : 0);
      const own = machine.parts.filter(({body}) => body === machine.guided).length;
      expect(group_of(machine, model, machine.guided).children).toHaveLength(own + (is_guided ? 2 : 0));
    });
  },
);

describe.each(["folding_wing", "universal_joint_like"])("a machine about a centre: %s", (name) => {
  it("keeps the sizes of its sphere wherever it gets to", () => {
    const {linkage, machine, model} = made(name),
      [low, high] = travel(linkage.drive!);
    const farthest = model.reach(low, high).map((at) => at.length());
    expect(Math.max(...farthest)).toBeLessThan(1.002 * machine.sizes.radius); // a pin's rim
    expect(Math.max(...farthest)).toBeGreaterThan(0.9 * machine.sizes.radius);
    expect(model.is_about_a_centre).toBe(true);
  });
});

it("the parts are the engine's, corner by corner, lit from outside", () => {
  const {machine, model} = made("tailgate"),
    meshes: Mesh[] = [];
  model.object.traverse((object) => void (object instanceof Mesh && object.castShadow && meshes.push(object)));
  const corners = meshes.map(({geometry}) => geometry.getAttribute("position").count);
  expect(corners.reduce((sum, n) => sum + n, 0)).toBe(machine.triangles.length);
  const [ground] = meshes.filter(({parent}) => parent === group_of(machine, model, "ground")),
    box = new Box3().setFromObject(ground!),
    at = ground!.geometry.getAttribute("position"),
    normal = ground!.geometry.getAttribute("normal");
  expect(box.max.z - box.min.z).toBeCloseTo(machine.sizes.thickness, 4);
  const kinds = new Set<string>();
  for (let k = 0; k < at.count; ++k) {
    const [x, y, z] = [normal.getX(k), normal.getY(k), normal.getZ(k)];
    expect(Math.hypot(x, y, z)).toBeCloseTo(1, 5);
    expect(Math.abs(z) < 1e-6 || Math.abs(z) > 1 - 1e-6).toBe(true); // an edge has no normal between its faces
    kinds.add(Math.abs(z) < 0.5 ? "wall" : z > 0 === at.getZ(k) > 0.5 * box.max.z ? "face" : "inside out");
  }
  expect([...kinds].sort()).toEqual(["face", "wall"]);
});
