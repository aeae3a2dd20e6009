// A figure as plates on pins. Lengths are in longest links of the linkage, z points at the viewer, z = 0 is the back of
// the ground plate. Nothing is drawn but when something has changed.
import {
  AmbientLight,
  Box3,
  type BufferGeometry,
  Color,
  CylinderGeometry,
  DirectionalLight,
  DoubleSide,
  ExtrudeGeometry,
  FrontSide,
  Group,
  HemisphereLight,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  PerspectiveCamera,
  Plane,
  PlaneGeometry,
  Raycaster,
  Scene,
  ShadowMaterial,
  Shape,
  Vector2,
  Vector3,
  VSMShadowMap,
  WebGLRenderer,
} from "three";
import {OrbitControls} from "three/examples/jsm/controls/OrbitControls.js";
import type {Viewport} from "../drawing/viewport";
import type {Point, Side} from "../contract/messages";
import {
  bar_of,
  edge_of,
  is_plate,
  web_corners,
  type Body,
  type End,
  type Figure,
  type Joint,
  type Role,
} from "../figure/figure";
import type {PlateOrder} from "../figure/mechanism";
import {body_point} from "../state/problem";
import {same_value} from "../state/task";
import {pin_diameter, pin_layers, plate_thickness, plate_width} from "./layers";

export type SolidColors = Record<"paper" | "ink2" | "input" | "output" | "body" | "accent" | "curve", string>;
export interface SolidInput {
  /** In any state: plates have the lengths that they have there. */
  figure: Figure;
  order: PlateOrder;
  /** Of the longest link. */
  longest: number;
  /** What is to be in the window; asked for when the view is fitted. */
  reach: () => readonly Point[];
}
const pitch = 1.35 * plate_thickness; // from layer to layer: heads of pins fit between the plates
const head = {thickness: 0.25 * plate_thickness, radius: 0.75 * pin_diameter};
const view_angle = 32;

/** One of the pivots of the grounded links. */
export interface SolidPivot {
  side: Side;
  end: End;
}
type Spot = [x: number, y: number, angle: number];
interface Moving {
  object: Object3D;
  /** Null: it is not in the figure. */
  place(figure: Figure): Spot | null;
}
const colors_of_roles: Record<Role, keyof SolidColors> = {
  driver: "accent",
  input: "input",
  coupler: "body",
  output: "output",
};

export class SolidScene {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(view_angle, 1, 0.01, 60);
  private readonly controls: OrbitControls;
  private readonly light = new DirectionalLight(0xffffff, 1.9);
  private parts = new Group();
  private moving: Moving[] = [];
  private shaped: ((figure: Figure) => void)[] = []; // what another linkage changes of the parts
  private built: {outline: readonly Point[] | undefined; order: PlateOrder} | null = null; // what they were built for
  private readonly materials = new Map<string, {role: keyof SolidColors; material: MeshStandardMaterial}>();
  /** How often the parts were built: for tests. */
  builds = 0;
  private unit = 1;
  private figure: Figure | null = null; // as it stands now
  private reach: SolidInput["reach"] = () => [];
  private asked = 0;
  /** The wall behind, which shows nothing but shadow. */
  private readonly wall = new Mesh(new PlaneGeometry(60, 60), new ShadowMaterial({opacity: 0.22}));
  private size = {width: 0, height: 0};

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private colors: SolidColors,
    private readonly still: boolean,
  ) {
    this.renderer = new WebGLRenderer({canvas, antialias: true, alpha: true, preserveDrawingBuffer: true});
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = VSMShadowMap;
    this.light.castShadow = true;
    this.light.shadow.mapSize.set(1024, 1024);
    this.light.shadow.radius = 6;
    this.light.shadow.bias = -0.0005;
    this.wall.receiveShadow = true;
    this.scene.add(
      this.wall,
      new HemisphereLight(0xffffff, 0xb8c0c8, 1.3),
      new AmbientLight(0xffffff, 0.5),
      this.light,
      this.light.target,
    );
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    [this.controls.minDistance, this.controls.maxDistance] = [0.3, 30];
    this.controls.addEventListener("change", () => this.ask());
    canvas.addEventListener("dblclick", this.look_square);
  }
  dispose(): void {
    cancelAnimationFrame(this.asked);
    this.canvas.removeEventListener("dblclick", this.look_square);
    this.controls.dispose();
    this.clear();
    for (const {material} of this.materials.values()) material.dispose();
    this.wall.geometry.dispose();
    this.wall.material.dispose();
    this.light.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** Another linkage is the same parts stretched; only another order of layers or another outline is built anew. The view
   *  stays where the user has turned it. */
  show(input: SolidInput): void {
    const first = this.built === null,
      unit_before = this.unit;
    this.unit = input.longest;
    this.reach = input.reach;
    const outline = input.figure.guided?.outline;
    if (!this.built || this.built.outline !== outline || !same_value(this.built.order, input.order)) this.build(input);
    for (const reshape of this.shaped) reshape(input.figure);
    if (first) this.fit();
    else if (this.unit !== unit_before) this.keep_view(unit_before / this.unit);
    this.put_light(input.figure);
    this.ask();
  }
  move(figure: Figure): void {
    this.figure = figure;
    for (const {object, place} of this.moving) {
      const spot = place(figure);
      if (!spot) continue;
      const [x, y, angle] = spot;
      object.position.set(x / this.unit, y / this.unit, object.position.z);
      object.rotation.z = angle;
    }
    this.ask();
  }
  resize(width: number, height: number, ratio: number): void {
    if (width === 0 || height === 0) return;
    this.size = {width, height};
    this.renderer.setPixelRatio(Math.min(ratio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.ask();
  }
  recolor(colors: SolidColors): void {
    this.colors = colors;
    for (const {role, material} of this.materials.values()) material.color.set(colors[role]);
    this.ask();
  }
  /** Everything in the window, seen from a little above and to the left of straight ahead. */
  fit(): void {
    const points = this.reach().map(([x, y]) => new Vector3(x / this.unit, y / this.unit, layer_z(2)));
    const center = new Box3().setFromPoints(points).getCenter(new Vector3());
    const ahead = new Vector3(-0.38, 0.34, 1).normalize();
    const right = new Vector3().crossVectors(this.camera.up, ahead).normalize(),
      up = new Vector3().crossVectors(ahead, right);
    const slope = Math.tan((view_angle * Math.PI) / 360) * 0.92;
    let away = 0.5;
    for (const point of points) {
      const arm = point.sub(center),
        near = arm.dot(ahead);
      away = Math.max(
        away,
        near + Math.abs(arm.dot(up)) / slope,
        near + Math.abs(arm.dot(right)) / (slope * this.camera.aspect),
      );
    }
    this.look(center, center.clone().addScaledVector(ahead, away));
  }
  turn(right: number, up: number): void {
    const arm = this.camera.position.clone().sub(this.controls.target);
    arm
      .applyAxisAngle(this.camera.up, right)
      .applyAxisAngle(new Vector3(1, 0, 0).applyQuaternion(this.camera.quaternion), up);
    this.look(this.controls.target.clone(), this.controls.target.clone().add(arm));
  }
  /** While something else follows the pointer, the view does not turn. */
  hold_view(held: boolean): void {
    this.controls.enabled = !held;
  }
  /** The pivot whose pin shows within `reach` pixels of a place on the canvas. */
  pivot_at(at: Point, reach: number): SolidPivot | null {
    const in_front = (this.figure?.joints ?? []).toReversed().flatMap(({end, at: place}) => {
      const [x, y] = this.seen(place);
      return end ? [{end, apart: Math.hypot(x - at[0], y - at[1])}] : [];
    });
    const [nearest] = in_front.sort((a, b) => a.apart - b.apart);
    return nearest && nearest.apart <= reach ? nearest.end : null;
  }
  /** Where a pivot shows on the canvas. */
  pixel_of({side, end}: SolidPivot): Point | null {
    const joint = this.figure?.joints.find((joint) => joint.end?.side === side && joint.end.end === end);
    return joint ? this.seen(joint.at) : null;
  }
  private seen([x, y]: Point): Point {
    const seen = new Vector3(x / this.unit, y / this.unit, layer_z(2)).project(this.camera);
    return [((seen.x + 1) / 2) * this.size.width, ((1 - seen.y) / 2) * this.size.height];
  }
  /** The point of the mechanism's plane under a place on the canvas, in the user's units; null where one looks along it. */
  plane_point(at: Point): Point | null {
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((at[0] / this.size.width) * 2 - 1, 1 - (at[1] / this.size.height) * 2), this.camera);
    const hit = ray.ray.intersectPlane(new Plane(new Vector3(0, 0, 1), -layer_z(2)), new Vector3());
    return hit && [hit.x * this.unit, hit.y * this.unit];
  }
  /** A flat view about as large as this one: what "outside of the window" and "so many pixels away" mean here. */
  flat_view(): Viewport {
    const {target} = this.controls,
      {width, height} = this.size;
    const away = Math.max(this.camera.position.distanceTo(target), 1e-6);
    return {
      x: target.x * this.unit,
      y: target.y * this.unit,
      scale: height / (2 * away * Math.tan((view_angle * Math.PI) / 360) * this.unit),
      width,
      height,
    };
  }

  private look(target: Vector3, eye: Vector3): void {
    this.controls.target.copy(target);
    this.camera.position.copy(eye);
    this.controls.update();
    this.ask();
  }
  private keep_view(factor: number): void {
    this.look(this.controls.target.clone().multiplyScalar(factor), this.camera.position.clone().multiplyScalar(factor));
  }
  private ask(): void {
    if (this.asked || this.size.width === 0) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = 0;
      this.renderer.render(this.scene, this.camera);
    });
  }
  private clear(): void {
    this.scene.remove(this.parts);
    this.parts.traverse((object) => {
      if (!(object instanceof Mesh)) return;
      (object.geometry as BufferGeometry).dispose();
    });
    this.parts = new Group();
    [this.moving, this.shaped] = [[], []];
  }
  private put_light({joints}: Figure): void {
    const pivots = joints.map(({at: [x, y]}) => new Vector3(x / this.unit, y / this.unit, layer_z(2)));
    const center = new Box3().setFromPoints(pivots).getCenter(new Vector3());
    this.light.target.position.copy(center);
    this.light.position.copy(center).add(new Vector3(-1.2, 1.9, 3.2));
    const reach = 2.6,
      {camera} = this.light.shadow;
    [camera.left, camera.right, camera.top, camera.bottom, camera.near, camera.far] = [
      -reach,
      reach,
      reach,
      -reach,
      0.1,
      8,
    ];
    camera.updateProjectionMatrix();
  }
  /** Double-click on a plate: look square at it. */
  private readonly look_square = (event: MouseEvent): void => {
    const box = this.canvas.getBoundingClientRect(),
      ray = new Raycaster();
    ray.setFromCamera(
      new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2),
      this.camera,
    );
    const hit = ray.intersectObjects(this.parts.children, true).at(0);
    if (!hit) return;
    const away = this.camera.position.distanceTo(this.controls.target);
    this.glide(hit.point, hit.point.clone().add(new Vector3(0, 0, away)));
  };
  private glide(target: Vector3, eye: Vector3): void {
    const from = {target: this.controls.target.clone(), eye: this.camera.position.clone()},
      began = performance.now();
    if (this.still) return this.look(target, eye);
    const frame = (now: number) => {
      const share = Math.min((now - began) / 120, 1);
      this.look(from.target.clone().lerp(target, share), from.eye.clone().lerp(eye, share));
      if (share < 1) requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  // ---- parts --------------------------------------------------------------------------------------------------

  private build({figure, order}: SolidInput): void {
    this.clear();
    ++this.builds;
    this.built = {outline: figure.guided?.outline, order};
    this.add_ground(figure);
    for (const body of figure.bodies) this.add_link(body, order[body.name] ?? 0);
    for (const joint of figure.joints) this.add_pin(joint, pin_layers(joint, order));
    if (figure.guided) this.add_body(figure.guided.outline, figure.guided.on, order[figure.guided.on] ?? 0);
    this.scene.add(this.parts);
  }
  /** One to each colour: with the last material of its kind its shader would go, and be compiled again. */
  private material(role: keyof SolidColors, opacity = 1): MeshStandardMaterial {
    const key = `${role} ${opacity}`,
      known = this.materials.get(key);
    const material =
      known?.material ??
      new MeshStandardMaterial({
        color: new Color(this.colors[role]),
        roughness: 0.62,
        metalness: 0,
        transparent: opacity < 1,
        opacity,
        side: opacity < 1 ? DoubleSide : FrontSide,
        depthWrite: opacity === 1,
      });
    if (!known) this.materials.set(key, {role, material});
    return material;
  }
  private mesh(geometry: BufferGeometry, material: MeshStandardMaterial, z: number): Mesh {
    const mesh = new Mesh(geometry, material);
    mesh.position.z = z;
    mesh.castShadow = material.opacity === 1;
    mesh.receiveShadow = material.opacity === 1;
    this.parts.add(mesh);
    return mesh;
  }
  /** Of a plate a bar along each edge. */
  private add_link(body: Body, layer: number): void {
    const edges = is_plate(body) ? body.corners.length : 1;
    for (let edge = 0; edge < edges; ++edge) this.add_bar(body, edge, layer);
  }
  private add_bar({name, role}: Body, edge: number, layer: number): void {
    const shape = slot(0, 1, plate_width / 2);
    for (const x of [0, 1]) shape.holes.push(new Shape().absarc(x, 0, pin_diameter / 2, 0, 2 * Math.PI, true));
    const geometry = plate(shape, plate_thickness),
      stretch = stretching(geometry);
    const object = this.mesh(geometry, this.material(colors_of_roles[role]), layer_z(layer));
    object.name = name;
    this.shaped.push((figure) => stretch(length_of(edge_of(figure, name, edge)) / this.unit));
    this.moving.push({object, place: (figure) => along(edge_of(figure, name, edge))});
  }
  private add_pin({name, role}: Joint, [low, high]: readonly [number, number]): void {
    const bottom = layer_z(low) - (low === 0 ? 0 : head.thickness),
      top = layer_z(high) + plate_thickness + head.thickness;
    const pin = new Group(),
      steel = this.material("ink2");
    pin.add(upright(pin_diameter / 2, bottom, top, steel), upright(head.radius, top - head.thickness, top, steel));
    if (low > 0) pin.add(upright(head.radius, bottom, bottom + head.thickness, steel));
    pin.add(upright((0.45 * pin_diameter) / 2, top, top + 0.002, this.material(colors_of_roles[role])));
    this.parts.add(pin);
    this.moving.push({
      object: pin,
      place({joints}) {
        const joint = joints.find((other) => other.name === name);
        return joint ? [...joint.at, 0] : null;
      },
    });
  }
  /** The body, and a web that holds it on the link that carries it. */
  private add_body(outline: readonly Point[], on: string, layer: number): void {
    const thickness = plate_thickness / 4,
      z = layer_z(layer) + (plate_thickness - thickness) / 2,
      unit = this.unit;
    const flat = (corners: readonly Point[]) =>
      plate(new Shape(corners.map(([x, y]) => new Vector2(x / this.unit, y / this.unit))), thickness);
    const body = this.mesh(flat(outline), this.material("accent", 0.34), z),
      web = this.mesh(flat(outline), this.material("accent", 0.2), z);
    this.shaped.push((figure) => {
      const bar = bar_of(figure, on),
        pose = figure.guided?.pose;
      body.scale.set(unit / this.unit, unit / this.unit, 1);
      if (!bar || !pose) return;
      web.geometry.dispose();
      web.geometry = flat(web_corners(outline, [body_point(bar[0], pose), body_point(bar[1], pose)]));
    });
    for (const object of [body, web]) {
      object.name = "body";
      object.renderOrder = 1;
      this.moving.push({
        object,
        place: ({guided}) => guided && [guided.pose.x, guided.pose.y, (guided.pose.theta_deg * Math.PI) / 180],
      });
    }
  }
  /** A plate behind everything, from the first ground pivot to the last, that carries a bracket to each. */
  private add_ground(figure: Figure): void {
    const geometry = plate(slot(0, 1, 0.13), plate_thickness / 2),
      stretch = stretching(geometry),
      base = this.mesh(geometry, this.material("curve"), 0);
    const feet = ground_joints(figure).map(({name, role}) => ({
      name,
      foot: this.mesh(plate(bracket(), plate_thickness), this.material(colors_of_roles[role]), layer_z(0)),
    }));
    for (const object of [base, ...feet.map(({foot}) => foot)]) object.name = "ground";
    this.shaped.push((figure) => {
      const pivots = ground_joints(figure),
        [first, last] = [pivots.at(0), pivots.at(-1)];
      if (!first || !last) return;
      const spot = along([first.at, last.at]);
      stretch(length_of([first.at, last.at]) / this.unit);
      base.position.set(spot[0] / this.unit, spot[1] / this.unit, 0);
      base.rotation.z = spot[2];
      for (const {name, foot} of feet) {
        const [x, y] = pivots.find((pivot) => pivot.name === name)?.at ?? first.at;
        foot.position.set(x / this.unit, y / this.unit, foot.position.z);
      }
    });
  }
}

type Bar = readonly [Point, Point];
function length_of(bar: Bar | null): number {
  return bar ? Math.hypot(bar[1][0] - bar[0][0], bar[1][1] - bar[0][1]) : 1;
}
function along(bar: Bar): Spot;
function along(bar: Bar | null): Spot | null;
function along(bar: Bar | null): Spot | null {
  return bar && [...bar[0], Math.atan2(bar[1][1] - bar[0][1], bar[1][0] - bar[0][0])];
}
function ground_joints({joints}: Figure): Joint[] {
  return joints.filter(({kind}) => kind === "ground_pivot");
}

/** Brings a plate of length 1 to another length: its far end moves as it is. */
export function stretching(geometry: BufferGeometry): (length: number) => void {
  const places = geometry.getAttribute("position"),
    far = Array.from({length: places.count}, (_, i) => ({i, x: places.getX(i)})).filter(({x}) => x > 0.5);
  return (length) => {
    for (const {i, x} of far) places.setX(i, x + length - 1);
    places.needsUpdate = true;
    geometry.computeBoundingBox();
    geometry.computeBoundingSphere();
  };
}
function layer_z(layer: number): number {
  return plate_thickness / 2 + layer * pitch;
}
/** A straight plate with round ends. */
function slot(from: number, to: number, radius: number): Shape {
  const shape = new Shape();
  shape.absarc(to, 0, radius, -Math.PI / 2, Math.PI / 2, false);
  shape.absarc(from, 0, radius, Math.PI / 2, (3 * Math.PI) / 2, false);
  shape.closePath();
  return shape;
}
function bracket(): Shape {
  const r = plate_width / 2,
    shape = new Shape();
  shape.absarc(0, 0, r, 0, Math.PI, false);
  shape.lineTo(-1.5 * r, -1.9 * r);
  shape.lineTo(1.5 * r, -1.9 * r);
  shape.closePath();
  return shape;
}
function plate(shape: Shape, thickness: number): ExtrudeGeometry {
  const bevel = Math.min(0.12 * thickness, 0.006);
  return new ExtrudeGeometry(shape, {
    depth: thickness - 2 * bevel,
    bevelEnabled: true,
    bevelSize: bevel,
    bevelThickness: bevel,
    bevelOffset: -bevel,
    bevelSegments: 2,
    curveSegments: 24,
  }).translate(0, 0, bevel);
}
function upright(radius: number, bottom: number, top: number, material: MeshStandardMaterial): Mesh {
  const mesh = new Mesh(new CylinderGeometry(radius, radius, top - bottom, 32).rotateX(Math.PI / 2), material);
  mesh.position.z = (bottom + top) / 2;
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}
