// Draws the items of a view (item.ts) with three.js. Nothing is drawn but when something has changed, and only what has
// changed is built anew: smooth where a processor does the drawing.
import {
  BufferGeometry,
  Color,
  ConeGeometry,
  DirectionalLight,
  DoubleSide,
  Float32BufferAttribute,
  FrontSide,
  HemisphereLight,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Plane,
  Scene,
  SphereGeometry,
  Vector3,
  WebGLRenderer,
  type InterleavedBufferAttribute,
  type Material,
} from "three";
import {Line2} from "three/examples/jsm/lines/Line2.js";
import {LineGeometry} from "three/examples/jsm/lines/LineGeometry.js";
import {LineSegments2} from "three/examples/jsm/lines/LineSegments2.js";
import {LineSegmentsGeometry} from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import {LineMaterial} from "three/examples/jsm/lines/LineMaterial.js";
import {craft_triangles} from "./craft";
import type {Arrow, Band, Craft, Fan, Item, Path, Solid, SphereColor, Strokes} from "./item";
import {circle, length, minus, plus, seen_from_outside, times, unit, type Rows, type Vec3} from "./vectors";
import type {View} from "./view";

export type SphereColors = Record<SphereColor, string>;

interface Part {
  item: Item;
  objects: Mesh[];
}
/** What an item is made of. */
interface Shape {
  type: "line" | "segments" | "hairs" | "surface" | "ball" | "large_ball" | "cone" | "solid";
  material: Material;
  /** Coordinates of a line's points, or of three corners to a triangle. */
  corners?: readonly number[];
  /** Of a body that only moves. */
  body?: Solid["corners"];
  frame?: Rows;
  at?: Vec3;
  along?: Vec3;
  scale?: number;
}
type Side = "all" | "front" | "back";

const head = {length: 0.085, radius: 0.03};
const up = new Vector3(0, 1, 0);

export class SphereScene {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly light = new DirectionalLight(0xffffff, 2.1);
  private readonly parts = new Map<string, Part>();
  private readonly materials = new Map<string, {color: SphereColor; material: Material & {color: Color}}>();
  private readonly ball = new SphereGeometry(1, 20, 14);
  private readonly large_ball = new SphereGeometry(1, 72, 48);
  private readonly bodies = new Map<Solid["corners"], {geometry: BufferGeometry; users: number}>();
  private readonly cone = new ConeGeometry(head.radius, head.length, 16);
  /** Between the near and the far side of the ball. */
  private readonly front = new Plane();
  private readonly back = new Plane();
  private asked = 0;
  private size = {width: 0, height: 0};

  /** `drawn` is told after each frame: what stands over the canvas follows. */
  constructor(
    canvas: HTMLCanvasElement,
    readonly view: View,
    private colors: SphereColors,
    private readonly drawn: () => void,
  ) {
    this.renderer = new WebGLRenderer({canvas, antialias: true, alpha: true, preserveDrawingBuffer: true});
    this.renderer.localClippingEnabled = true;
    this.scene.add(new HemisphereLight(0xffffff, 0x8090a0, 1.6), this.light);
  }
  dispose(): void {
    cancelAnimationFrame(this.asked);
    for (const key of [...this.parts.keys()]) this.remove(key);
    for (const {material} of this.materials.values()) material.dispose();
    this.ball.dispose();
    this.large_ball.dispose();
    this.cone.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  show(items: readonly Item[]): void {
    const wanted = new Set(items.map(({key}) => key));
    for (const key of [...this.parts.keys()]) if (!wanted.has(key)) this.remove(key);
    for (const item of items) {
      const part = this.parts.get(item.key);
      if (part?.item === item) continue;
      const shapes = this.shapes_of(item);
      if (part && part.objects.length === shapes.length && shapes.every((shape, k) => fits(part.objects[k]!, shape)))
        part.item = item;
      else this.replace(item, shapes);
      const {objects} = this.parts.get(item.key)!;
      for (const [k, shape] of shapes.entries()) put(objects[k]!, shape);
    }
    this.ask();
  }
  recolor(colors: SphereColors): void {
    this.colors = colors;
    for (const {color, material} of this.materials.values()) material.color.set(colors[color]);
    this.ask();
  }
  resize(width: number, height: number, ratio: number): void {
    if (width === 0 || height === 0) return;
    this.size = {width, height};
    this.renderer.setPixelRatio(Math.min(ratio, 1.5));
    this.renderer.setSize(width, height, false);
    this.view.resize(this.size);
    this.ask();
  }
  /** A frame, soon. */
  ask(): void {
    if (this.asked) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = 0;
      this.draw();
    });
  }
  private draw(): void {
    if (this.size.width === 0) return;
    const eye = new Vector3(...this.view.towards_eye),
      {horizon} = this.view;
    this.front.set(eye, -horizon);
    this.back.set(eye.clone().negate(), horizon);
    this.light.position.copy(eye).add(new Vector3(0, 0, 0.6));
    this.renderer.render(this.scene, this.view.camera);
    this.drawn();
  }

  private replace(item: Item, shapes: readonly Shape[]): void {
    this.remove(item.key);
    const objects = shapes.map((shape) => this.object(shape));
    this.parts.set(item.key, {item, objects});
    if (objects.length) this.scene.add(...objects);
  }
  private object({type, material, corners = [], body}: Shape): Mesh {
    if (type === "solid" && body) {
      const mesh = new Mesh(this.geometry_of(body), material);
      mesh.userData.body = body;
      return mesh;
    }
    if (type === "hairs") {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new Float32BufferAttribute(new Float32Array(room_for(corners.length)), 3));
      return new LineSegments(geometry, material) as unknown as Mesh;
    }
    if (type === "segments") {
      const geometry = new LineSegmentsGeometry();
      geometry.setPositions(new Float32Array(room_for(corners.length)));
      return new LineSegments2(geometry, material as LineMaterial) as unknown as Mesh;
    }
    if (type === "ball" || type === "large_ball" || type === "cone") return new Mesh(this[type], material);
    if (type === "line") {
      const geometry = new LineGeometry();
      geometry.setPositions([...corners]);
      return new Line2(geometry, material as LineMaterial) as unknown as Mesh;
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(corners, 3));
    return new Mesh(geometry, material);
  }
  private remove(key: string): void {
    const part = this.parts.get(key);
    if (!part) return;
    this.parts.delete(key);
    for (const object of part.objects) {
      this.scene.remove(object);
      if (part.item.kind === "solid") this.forget_body(part.item.corners);
      else if (![this.ball, this.cone, this.large_ball].includes(object.geometry as SphereGeometry & ConeGeometry))
        object.geometry.dispose();
    }
  }
  private geometry_of(corners: Solid["corners"]): BufferGeometry {
    const known = this.bodies.get(corners);
    if (known) {
      ++known.users;
      return known.geometry;
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(corners, 3));
    this.bodies.set(corners, {geometry, users: 1});
    return geometry;
  }
  private forget_body(corners: Solid["corners"]): void {
    const known = this.bodies.get(corners);
    if (!known || --known.users > 0) return;
    known.geometry.dispose();
    this.bodies.delete(corners);
  }

  // ---- materials ----------------------------------------------------------------------------------------------------

  private material<M extends Material & {color: Color}>(key: string, color: SphereColor, make: () => M): M {
    const known = this.materials.get(key);
    if (known) return known.material as unknown as M;
    const material = make();
    material.color.set(this.colors[color]);
    this.materials.set(key, {color, material});
    return material;
  }
  private line_material(path: Pick<Path, "color" | "opacity" | "width" | "dashed">, side: Side): LineMaterial {
    const {color, dashed = false} = path,
      faint = side === "back",
      opacity = (path.opacity ?? 1) * (faint ? 0.38 : 1),
      linewidth = faint ? Math.min(path.width ?? 2, 1.2) : (path.width ?? 2);
    return this.material(`line ${color} ${opacity} ${linewidth} ${dashed} ${side}`, color, () => {
      const planes = side === "all" ? [] : [side === "front" ? this.front : this.back];
      return new LineMaterial({
        linewidth,
        dashed,
        dashSize: 0.045,
        gapSize: 0.035,
        transparent: opacity < 1,
        opacity,
        depthWrite: opacity === 1,
        clippingPlanes: planes,
      });
    });
  }
  private flat_material({color, opacity = 1}: Item): MeshBasicMaterial {
    return this.material(
      `flat ${color} ${opacity}`,
      color,
      () => new MeshBasicMaterial({transparent: opacity < 1, opacity, side: DoubleSide, depthWrite: opacity === 1}),
    );
  }
  private solid_material({color, opacity = 1}: Item): MeshLambertMaterial {
    return this.material(
      `solid ${color} ${opacity}`,
      color,
      () =>
        new MeshLambertMaterial({
          transparent: opacity < 1,
          opacity,
          side: DoubleSide,
          flatShading: true,
          depthWrite: opacity === 1,
        }),
    );
  }

  // ---- shapes -------------------------------------------------------------------------------------------------------

  private shapes_of(item: Item): Shape[] {
    switch (item.kind) {
      case "path":
        return this.path(item);
      case "arrow":
        return this.arrow(item);
      case "dot":
        return [{type: "ball", material: this.solid_material(item), at: item.at, scale: item.size ?? 0.025}];
      case "fan":
        return [{type: "surface", material: this.flat_material(item), corners: fan_corners(item)}];
      case "band":
        return [{type: "surface", material: this.flat_material(item), corners: band_corners(item)}];
      case "strokes":
        return this.strokes(item);
      case "ball":
        return [{type: "large_ball", material: this.veil(item), at: [0, 0, 0], scale: item.radius}];
      case "solid":
        return [
          {
            type: "solid",
            material: this.solid_material(item),
            body: item.corners,
            frame: item.frame,
            scale: item.size ?? 1,
          },
        ];
      case "craft":
        return [{type: "surface", material: this.solid_material(item), corners: craft_corners(item)}];
    }
  }
  private path(item: Path): Shape[] {
    if (item.points.length < 2) return [];
    const sides: Side[] = item.on_ball ? ["front", "back"] : ["all"],
      corners = item.points.flat();
    return sides.map((side) => ({type: "line", material: this.line_material(item, side), corners}));
  }
  private strokes(item: Strokes): Shape[] {
    const corners = item.ends.flat();
    return [
      {type: "segments", material: this.line_material(item, "front"), corners},
      {type: "hairs", material: this.hair_material(item), corners},
    ];
  }
  /** On the far side: a pixel wide, which costs a processor that draws a tenth of a line of a width. */
  private hair_material({color, opacity = 1}: Item): LineBasicMaterial {
    return this.material(
      `hair ${color} ${opacity}`,
      color,
      () =>
        new LineBasicMaterial({
          transparent: true,
          opacity: 0.45 * opacity,
          depthWrite: false,
          clippingPlanes: [this.back],
        }),
    );
  }
  /** Of a ball, its near side. */
  private veil({color, opacity = 1}: Item): MeshBasicMaterial {
    return this.material(
      `veil ${color} ${opacity}`,
      color,
      () => new MeshBasicMaterial({transparent: true, opacity, side: FrontSide, depthWrite: false}),
    );
  }
  private arrow(item: Arrow): Shape[] {
    const along = unit(minus(item.to, item.from)),
      whole = length(minus(item.to, item.from)),
      tip = Math.min(head.length, whole / 2);
    if (whole < 1e-9) return [];
    const scale = (tip / head.length) * Math.min(1, 0.4 + 0.2 * (item.width ?? 3));
    return [
      {
        type: "line",
        material: this.line_material(item, "all"),
        corners: [...item.from, ...minus(item.to, times(tip, along))],
      },
      {
        type: "cone",
        material: this.flat_material(item),
        at: minus(item.to, times((scale * head.length) / 2, along)),
        along,
        scale,
      },
    ];
  }
}

function fan_corners({apex, rim}: Fan): number[] {
  return rim.slice(1).flatMap((point, k) => [...apex, ...rim[k]!, ...point]);
}
function band_corners(item: Band): number[] {
  const inner = circle(item.axis, item.inner),
    outer = circle(item.axis, item.outer);
  return inner.slice(1).flatMap((a, k) => {
    const [b, c, d] = [inner[k]!, outer[k]!, outer[k + 1]!];
    return [...a, ...b, ...c, ...a, ...c, ...d];
  });
}
function craft_corners({frame, at = [0, 0, 0], size = 1}: Craft): number[] {
  return craft_triangles.flatMap((corner) => [...plus(at, times(size, seen_from_outside(frame, corner)))]);
}

/** The numbers of an object's geometry, where it has its own: of a line its segments, two ends to each. */
function numbers_of({geometry}: Mesh, type: Shape["type"]): Float32Array | null {
  if (type === "line" || type === "segments")
    return (geometry.getAttribute("instanceStart") as InterleavedBufferAttribute).data.array as Float32Array;
  return type === "surface" || type === "hairs" ? (geometry.getAttribute("position").array as Float32Array) : null;
}
/** Whether an object can become this shape as it is: another geometry costs much more than other numbers. */
function fits(object: Mesh, {type, material, corners = [], body}: Shape): boolean {
  if (object.material !== material) return false;
  if (body) return object.userData.body === body;
  if (type === "segments" || type === "hairs") return (numbers_of(object, type)?.length ?? 0) >= corners.length;
  const wanted = type === "line" ? 2 * (corners.length - 3) : corners.length;
  return (numbers_of(object, type)?.length ?? 0) === wanted;
}
/** How many numbers are kept for stretches of so many: there will be more. */
function room_for(numbers: number): number {
  return 6 * 2 ** Math.ceil(Math.log2(numbers / 6 + 16));
}
function put(object: Mesh, {type, corners = [], frame, at, along, scale = 1}: Shape): void {
  const numbers = numbers_of(object, type),
    {geometry} = object;
  if (type === "hairs" && numbers) {
    numbers.set(corners);
    geometry.getAttribute("position").needsUpdate = true;
    geometry.setDrawRange(0, corners.length / 3);
  } else if (type === "segments" && numbers) {
    numbers.set(corners);
    (geometry.getAttribute("instanceStart") as InterleavedBufferAttribute).data.needsUpdate = true;
    (geometry as LineSegmentsGeometry).instanceCount = corners.length / 6;
  } else if (type === "line" && numbers) {
    for (let k = 0; k + 3 < corners.length; k += 3) for (let i = 0; i < 6; ++i) numbers[2 * k + i] = corners[k + i]!;
    (geometry.getAttribute("instanceStart") as InterleavedBufferAttribute).data.needsUpdate = true;
    if ((object.material as LineMaterial).dashed) (object as unknown as Line2).computeLineDistances();
  } else if (numbers) {
    numbers.set(corners);
    geometry.getAttribute("position").needsUpdate = true;
    geometry.computeVertexNormals();
  }
  object.frustumCulled = false; // its bounds are those of before
  if (frame) {
    const [x, y, z] = frame;
    object.quaternion.setFromRotationMatrix(new Matrix4().set(...x, 0, ...y, 0, ...z, 0, 0, 0, 0, 1));
    object.scale.setScalar(scale);
  }
  if (at) object.position.set(...at);
  if (along) object.quaternion.setFromUnitVectors(up, new Vector3(...along));
  if (at) object.scale.setScalar(scale);
}
