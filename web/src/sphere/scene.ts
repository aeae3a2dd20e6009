// Draws the items of a view (item.ts) with three.js. Nothing is drawn but when something has changed, and only what has
// changed is built anew: smooth where a processor does the drawing.
import {
  BufferGeometry,
  CircleGeometry,
  ConeGeometry,
  Float32BufferAttribute,
  Matrix4,
  Mesh,
  Scene,
  SphereGeometry,
  Vector3,
  WebGLRenderer,
} from "three";
import {craft_triangles} from "./craft";
import type {Arrow, Band, Craft, Fan, Item, Path, Solid, SphereColor} from "./item";
import {BallPaint, LinePaint, new_sight, SurfacePaint, type LineLook, type Paint} from "./paints";
import {has_room, new_strip, put_stretches} from "./strips";
import {circle, length, minus, plus, seen_from_outside, times, unit, type Rows, type Vec3} from "./vectors";
import type {View} from "./view";

export type SphereColors = Record<SphereColor, string>;

interface Part {
  item: Item;
  objects: Mesh[];
}
/** What an item is made of. */
interface Shape {
  type: "lines" | "surface" | "dot" | "disc" | "cone" | "solid";
  paint: Paint;
  /** Of lines, a beginning and an end to each stretch. */
  ends?: readonly Vec3[];
  /** Of a surface, coordinates of three corners to a triangle. */
  corners?: readonly number[];
  /** Of a body that only moves. */
  body?: Solid["corners"];
  frame?: Rows;
  at?: Vec3;
  along?: Vec3;
  scale?: number;
}

const head = {length: 0.085, radius: 0.03};
const up = new Vector3(0, 1, 0);
const rest_ms = 160;

function is_drawn_by_processor(renderer: WebGLRenderer): boolean {
  const gl = renderer.getContext(),
    named = gl.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER;
  return /SwiftShader|llvmpipe|software|Basic Render/i.test(String(gl.getParameter(named)));
}

export class SphereScene {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly sight = new_sight();
  private readonly parts = new Map<string, Part>();
  private readonly paints = new Map<string, {color: SphereColor; paint: Paint}>();
  private readonly shared = {
    dot: new SphereGeometry(1, 14, 10),
    disc: new CircleGeometry(1, 72),
    cone: new ConeGeometry(head.radius, head.length, 16),
  };
  private readonly bodies = new Map<Solid["corners"], {geometry: BufferGeometry; users: number}>();
  private asked = 0;
  private resting = 0;
  private size = {width: 0, height: 0};
  private ratio = 1;
  private readonly is_slow: boolean;

  /** `drawn` is told after each frame: what stands over the canvas follows. */
  constructor(
    canvas: HTMLCanvasElement,
    readonly view: View,
    private colors: SphereColors,
    private readonly drawn: () => void,
  ) {
    this.renderer = new WebGLRenderer({canvas, alpha: true, preserveDrawingBuffer: true});
    this.is_slow = is_drawn_by_processor(this.renderer);
  }
  dispose(): void {
    cancelAnimationFrame(this.asked);
    clearTimeout(this.resting);
    for (const key of [...this.parts.keys()]) this.remove(key);
    for (const {paint} of this.paints.values()) paint.dispose();
    for (const geometry of Object.values(this.shared)) geometry.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  show(items: readonly Item[]): void {
    const wanted = new Set(items.map(({key}) => key));
    for (const key of [...this.parts.keys()]) if (!wanted.has(key)) this.remove(key);
    for (const [place, item] of items.entries()) {
      const part = this.parts.get(item.key);
      if (part?.item === item) {
        in_order(part.objects, place);
        continue;
      }
      const shapes = this.shapes_of(item);
      if (part && part.objects.length === shapes.length && shapes.every((shape, k) => fits(part.objects[k]!, shape)))
        part.item = item;
      else this.replace(item, shapes);
      const {objects} = this.parts.get(item.key)!;
      for (const [k, shape] of shapes.entries()) put(objects[k]!, shape);
      in_order(objects, place);
    }
    this.ask();
  }
  recolor(colors: SphereColors): void {
    this.colors = colors;
    for (const {color, paint} of this.paints.values()) paint.set_color(colors[color]);
    this.ask();
  }
  resize(width: number, height: number, ratio: number): void {
    if (width === 0 || height === 0) return;
    this.size = {width, height};
    this.ratio = ratio;
    this.view.resize(this.size);
    this.ask();
  }
  /** A frame, soon, and a finer one when all has come to rest. */
  ask(): void {
    if (this.asked) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = 0;
      clearTimeout(this.resting);
      const moving = this.is_slow ? Math.min(this.ratio, 1) : Math.max(this.ratio, 2),
        at_rest = this.ratio > 1.25 ? 3 : 2;
      this.draw(moving);
      if (at_rest > moving) this.resting = window.setTimeout(() => this.draw(at_rest), rest_ms);
      this.drawn();
    });
  }
  /** `ratio`: pixels of the picture to a CSS pixel; finer than the screen smooths the edges of solids. */
  private draw(ratio: number): void {
    const {sight, view, renderer, size} = this;
    if (size.width === 0) return;
    const eye = new Vector3(...view.towards_eye),
      wanted = [size.width, size.height].map((pixels) => Math.floor(pixels * ratio)),
      {width, height} = renderer.domElement;
    if (wanted[0] !== width || wanted[1] !== height) {
      renderer.setPixelRatio(ratio);
      renderer.setSize(size.width, size.height, false);
    }
    sight.eye.value.set(...view.towards_eye, view.horizon);
    sight.light.value
      .copy(eye)
      .add(new Vector3(0, 0, 0.6))
      .normalize();
    sight.ratio.value = ratio;
    sight.half.value.set(wanted[0]! / 2, wanted[1]! / 2);
    this.place_disc(eye);
    renderer.render(this.scene, view.camera);
  }
  /** What is seen of a ball: its outline, and what that encloses. */
  private place_disc(eye: Vector3): void {
    for (const {item, objects} of this.parts.values()) {
      if (item.kind !== "ball") continue;
      const away = this.view.horizon * item.radius;
      objects[0]!.position.copy(eye).multiplyScalar(away);
      objects[0]!.scale.setScalar(Math.sqrt(item.radius ** 2 - away ** 2));
      objects[0]!.quaternion.copy(this.view.camera.quaternion);
    }
  }

  private replace(item: Item, shapes: readonly Shape[]): void {
    this.remove(item.key);
    const objects = shapes.map((shape) => this.object(shape));
    this.parts.set(item.key, {item, objects});
    if (objects.length) this.scene.add(...objects);
  }
  private object({type, paint, ends = [], corners = [], body}: Shape): Mesh {
    if (type === "dot" || type === "disc" || type === "cone") return new Mesh(this.shared[type], paint);
    if (type === "lines") return new Mesh(new_strip(ends.length / 2, "DASHED" in paint.defines), paint);
    if (body) {
      const mesh = new Mesh(this.geometry_of(body), paint);
      mesh.userData.body = body;
      return mesh;
    }
    return new Mesh(triangles(corners), paint);
  }
  private remove(key: string): void {
    const part = this.parts.get(key);
    if (!part) return;
    this.parts.delete(key);
    for (const object of part.objects) {
      this.scene.remove(object);
      if (part.item.kind === "solid") this.forget_body(part.item.corners);
      else if (!Object.values<BufferGeometry>(this.shared).includes(object.geometry)) object.geometry.dispose();
    }
  }
  private geometry_of(corners: Solid["corners"]): BufferGeometry {
    const known = this.bodies.get(corners);
    if (known) {
      ++known.users;
      return known.geometry;
    }
    const geometry = triangles(corners);
    this.bodies.set(corners, {geometry, users: 1});
    return geometry;
  }
  private forget_body(corners: Solid["corners"]): void {
    const known = this.bodies.get(corners);
    if (!known || --known.users > 0) return;
    known.geometry.dispose();
    this.bodies.delete(corners);
  }

  // ---- paints -------------------------------------------------------------------------------------------------------

  private paint(key: string, color: SphereColor, make: () => Paint): Paint {
    const name = `${key} ${color}`,
      known = this.paints.get(name);
    if (known) return known.paint;
    const paint = make();
    paint.set_color(this.colors[color]);
    this.paints.set(name, {color, paint});
    return paint;
  }
  private line_paint({color, ...asked}: Pick<Path, "color" | "opacity" | "width" | "dashed" | "on_ball">): Paint {
    const {opacity = 1, width = 2, dashed = false, on_ball = false} = asked;
    const look: LineLook = {
      width,
      far_width: on_ball ? Math.min(width, 1.2) : width,
      opacity,
      far_opacity: on_ball ? 0.38 * opacity : opacity,
      dashed,
    };
    return this.paint(`line ${Object.values(look).join(" ")}`, color, () => new LinePaint(this.sight, look));
  }
  private surface_paint({color, opacity = 1}: Item, is_lit: boolean): Paint {
    return this.paint(`surface ${is_lit} ${opacity}`, color, () => new SurfacePaint(this.sight, is_lit, opacity));
  }

  // ---- shapes -------------------------------------------------------------------------------------------------------

  private shapes_of(item: Item): Shape[] {
    switch (item.kind) {
      case "path":
        return this.path(item);
      case "arrow":
        return this.arrow(item);
      case "dot":
        return [{type: "dot", paint: this.surface_paint(item, true), at: item.at, scale: item.size ?? 0.025}];
      case "fan":
        return [{type: "surface", paint: this.surface_paint(item, false), corners: fan_corners(item)}];
      case "band":
        return [{type: "surface", paint: this.surface_paint(item, false), corners: band_corners(item)}];
      case "strokes":
        return [{type: "lines", paint: this.line_paint({...item, on_ball: true}), ends: item.ends}];
      case "ball":
        return [{type: "disc", paint: this.ball_paint(item)}];
      case "solid":
        return [
          {
            type: "solid",
            paint: this.surface_paint(item, true),
            body: item.corners,
            frame: item.frame,
            scale: item.size ?? 1,
          },
        ];
      case "craft":
        return [{type: "surface", paint: this.surface_paint(item, true), corners: craft_corners(item)}];
    }
  }
  private path(item: Path): Shape[] {
    const {points} = item;
    if (points.length < 2) return [];
    const ends = points.slice(1).flatMap((point, k) => [points[k]!, point]);
    return [{type: "lines", paint: this.line_paint(item), ends}];
  }
  private ball_paint({color, opacity = 1}: Item): Paint {
    return this.paint(`ball ${opacity}`, color, () => new BallPaint(opacity));
  }
  private arrow(item: Arrow): Shape[] {
    const along = unit(minus(item.to, item.from)),
      whole = length(minus(item.to, item.from)),
      tip = Math.min(head.length, whole / 2);
    if (whole < 1e-9) return [];
    const scale = (tip / head.length) * Math.min(1, 0.4 + 0.2 * (item.width ?? 3));
    return [
      {type: "lines", paint: this.line_paint(item), ends: [item.from, minus(item.to, times(tip, along))]},
      {
        type: "cone",
        paint: this.surface_paint(item, false),
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

function triangles(corners: Solid["corners"]): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(corners, 3));
  geometry.computeVertexNormals();
  return geometry;
}
/** Lines are painted after what they lie on, the first ones first. */
function in_order(objects: readonly Mesh[], place: number): void {
  for (const object of objects)
    object.renderOrder =
      object.material instanceof LinePaint ? 1 + place : object.material instanceof BallPaint ? -1 : 0;
}
/** Whether an object can become this shape as it is: another geometry costs much more than other numbers. */
function fits({material, userData, geometry}: Mesh, {type, paint, ends = [], corners = [], body}: Shape): boolean {
  if (material !== paint) return false;
  if (type === "solid") return userData.body === body;
  if (type === "lines") return has_room(geometry, ends.length / 2);
  return type !== "surface" || 3 * geometry.getAttribute("position").count === corners.length;
}
function put(object: Mesh, {type, ends = [], corners = [], frame, at, along, scale = 1}: Shape): void {
  if (type === "lines") put_stretches(object.geometry, ends);
  if (type === "surface") {
    const position = object.geometry.getAttribute("position");
    (position.array as Float32Array).set(corners);
    position.needsUpdate = true;
    object.geometry.computeVertexNormals();
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
