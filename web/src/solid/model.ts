// A machine as it is drawn: the meshes of its parts, in a group to each body, which is displaced as it moves. Lengths are
// the user's.
import {
  Box3,
  ExtrudeGeometry,
  Group,
  Mesh,
  Quaternion,
  Shape,
  SphereGeometry,
  Vector2,
  Vector3,
  type BufferGeometry,
  type Material,
} from "three";
import type {Machine, Point} from "../contract/messages";
import {placed_outline, web_of, type Figure, type Role} from "../figure/figure";
import {angle_of_row, row_at, row_count} from "../state/drive";
import {most_of} from "../state/ends";
import {lit_surface} from "./surface";

export type SolidColor = "ink2" | "input" | "output" | "body" | "accent" | "curve";
export type Paint = (color: SolidColor, opacity?: number) => Material;
export interface Solid {
  machine: Machine;
  /** As it stands where the machine's parts are told. */
  figure: Figure;
}
const colors_of_roles: Record<Role, SolidColor> = {
  driver: "accent",
  input: "input",
  coupler: "body",
  output: "output",
};
const most_looked_at = 32; // states, and points of a part, by which it is known how far it reaches

// How a machine about a centre, its z axis upwards, is turned to be seen as on the ball.
const about_a_centre = new Quaternion()
  .setFromAxisAngle(new Vector3(0, 1, 0), -2.44)
  .multiply(new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), -Math.PI / 2));

export class SolidModel {
  readonly object = new Group();
  readonly is_about_a_centre: boolean;
  /** Halfway between the back of the ground and the front of the last plate. */
  readonly middle: number;
  private readonly bodies: readonly Group[];
  private readonly travel: {states: Float64Array; width: number};

  constructor({machine, figure}: Solid, paint: Paint) {
    const {layers, travel, sizes} = machine;
    this.bodies = layers.map(() => new Group());
    this.travel = {states: travel, width: 1 + 7 * (layers.length - 1)};
    this.is_about_a_centre = sizes.radius > 0;
    if (this.is_about_a_centre) this.object.quaternion.copy(about_a_centre);
    this.object.add(...this.bodies);
    this.add_parts(machine, figure, paint);
    this.add_guided(machine, figure, paint);
    if (this.is_about_a_centre)
      this.bodies[0]!.add(new Mesh(new SphereGeometry(inner_radius(machine), 64, 40), paint("curve", 0.12)));
    for (const body of this.bodies) body.userData.points = points_of(body);
    const {min, max} = new Box3().setFromPoints(this.bodies.flatMap(({userData}) => userData.points as Vector3[]));
    this.middle = (min.z + max.z) / 2;
  }
  dispose(): void {
    this.object.traverse((object) => {
      if (object instanceof Mesh) (object.geometry as BufferGeometry).dispose();
    });
  }

  /** Bodies move between two states of the travel as if by one turn and one shift. */
  move(angle_deg: number): void {
    const {states, width} = this.travel;
    if (states.length === 0) return;
    const {row, share} = row_at(this.travel, angle_deg),
      next = share > 0 ? row + 1 : row;
    this.bodies.slice(1).forEach((body, k) => {
      const turn = (at: number) => new Quaternion(states[at + 1], states[at + 2], states[at + 3], states[at]),
        shift = (at: number) => new Vector3(states[at + 4], states[at + 5], states[at + 6]),
        [from, to] = [row, next].map((of) => of * width + 1 + 7 * k) as [number, number];
      body.quaternion.slerpQuaternions(turn(from), turn(to), share);
      body.position.lerpVectors(shift(from), shift(to), share);
    });
  }
  /** Points of its bodies, wherever they get to between two driver angles. */
  reach(low_deg: number, high_deg: number): Vector3[] {
    const points: Vector3[] = [],
      rows = Array.from({length: row_count(this.travel)}, (_, row) => angle_of_row(this.travel, row)),
      within = rows.filter((angle) => angle >= low_deg && angle <= high_deg),
      angles = some_of(within.length).map((k) => within[k]!);
    for (const angle of angles.length ? angles : [low_deg]) {
      this.move(angle);
      this.object.updateMatrixWorld();
      for (const body of this.bodies) for (const at of body.userData.points) points.push(body.localToWorld(at.clone()));
    }
    return points;
  }
  private add_parts(machine: Machine, figure: Figure, paint: Paint): void {
    const roles = new Map(figure.bodies.map(({name, role}) => [name, role]));
    let from = 0;
    for (const {name, body, triangles} of machine.parts) {
      const role = roles.get(name),
        is_pin = name !== body;
      const mesh = new Mesh(
        lit_surface(machine, from, from + triangles),
        paint(role ? colors_of_roles[role] : is_pin ? "ink2" : "curve"),
      );
      mesh.castShadow = mesh.receiveShadow = true;
      this.group_of(machine, body).add(mesh);
      from += triangles;
    }
  }
  /** The body's outline, and a web that holds it on the plate that carries it, in the middle of that. */
  private add_guided(machine: Machine, figure: Figure, paint: Paint): void {
    const web = web_of(figure);
    if (!figure.guided || !web) return;
    const carrier = this.group_of(machine, machine.guided),
      {min, max} = new Box3().setFromObject(carrier.children[0]!),
      thickness = (max.z - min.z) / 4;
    const add = (corners: readonly Point[], opacity: number): void => {
      const mesh = new Mesh(sheet(corners, thickness), paint("accent", opacity));
      mesh.position.z = (min.z + max.z - thickness) / 2;
      mesh.renderOrder = 1;
      carrier.add(mesh);
    };
    add(placed_outline(figure.guided), 0.34);
    add(web, 0.2);
  }
  private group_of({layers}: Machine, name: string): Group {
    return this.bodies[layers.findIndex(({body}) => body === name)]!;
  }
}

function sheet(corners: readonly Point[], depth: number): BufferGeometry {
  return new ExtrudeGeometry(new Shape(corners.map(([x, y]) => new Vector2(x, y))), {depth, bevelEnabled: false});
}
/** The ball on which all plates lie. */
function inner_radius({sizes, layers}: Machine): number {
  return sizes.radius - sizes.thickness - most_of(layers.map(({layer}) => layer)) * (sizes.thickness + sizes.gap);
}
/** Evenly, of so many. */
function some_of(count: number): number[] {
  const step = Math.ceil(count / most_looked_at) || 1;
  return Array.from({length: Math.ceil(count / step)}, (_, k) => k * step);
}
/** Of what moves with a body, in position 1. */
function points_of(body: Group): Vector3[] {
  return body.children.flatMap((mesh) => {
    const {geometry, position} = mesh as Mesh,
      at = geometry.getAttribute("position");
    return some_of(at.count).map((vertex) => new Vector3().fromBufferAttribute(at, vertex).add(position));
  });
}
