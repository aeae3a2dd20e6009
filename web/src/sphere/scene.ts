// Draws the items of a view (item.ts) with three.js. Nothing is drawn but when something has changed, and only what has
// changed is built anew: smooth where a processor does the drawing.
import {
  BufferGeometry,
  Color,
  ConeGeometry,
  DirectionalLight,
  DoubleSide,
  Float32BufferAttribute,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Plane,
  Quaternion,
  Scene,
  SphereGeometry,
  Vector3,
  WebGLRenderer,
  type Material,
  type Object3D,
} from "three";
import {Line2} from "three/examples/jsm/lines/Line2.js";
import {LineGeometry} from "three/examples/jsm/lines/LineGeometry.js";
import {LineMaterial} from "three/examples/jsm/lines/LineMaterial.js";
import {craft_triangles} from "./craft";
import type {Arrow, Band, Craft, Dot, Fan, Item, Path, SphereColor} from "./item";
import {circle, column, length, minus, plus, times, unit, type Vec3} from "./vectors";
import type {View} from "./view";

export type SphereColors = Record<SphereColor, string>;

interface Part {
  item: Item;
  objects: Object3D[];
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
  private readonly cone = new ConeGeometry(head.radius, head.length, 16);
  /** Between the near and the far side of the ball. */
  private readonly front = new Plane();
  private readonly back = new Plane();
  private asked = 0;
  private size = {width: 0, height: 0};
  /** For tests. */
  frames = 0;

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
    this.cone.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  show(items: readonly Item[]): void {
    const wanted = new Set(items.map(({key}) => key));
    for (const key of [...this.parts.keys()]) if (!wanted.has(key)) this.remove(key);
    for (const item of items) {
      if (this.parts.get(item.key)?.item === item) continue;
      this.remove(item.key);
      const objects = this.made(item);
      this.parts.set(item.key, {item, objects});
      if (objects.length) this.scene.add(...objects);
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
    ++this.frames;
    this.drawn();
  }

  private remove(key: string): void {
    const part = this.parts.get(key);
    if (!part) return;
    this.parts.delete(key);
    for (const object of part.objects) {
      this.scene.remove(object);
      const {geometry} = object as Mesh;
      if (geometry !== this.ball && geometry !== this.cone) geometry.dispose();
    }
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

  // ---- parts --------------------------------------------------------------------------------------------------------

  private made(item: Item): Object3D[] {
    switch (item.kind) {
      case "path":
        return this.path(item);
      case "arrow":
        return this.arrow(item);
      case "dot":
        return this.dot(item);
      case "fan":
        return this.fan(item);
      case "band":
        return this.band(item);
      case "craft":
        return this.craft(item);
    }
  }
  private line(points: readonly Vec3[], material: LineMaterial): Line2 {
    const geometry = new LineGeometry();
    geometry.setPositions(points.flatMap((point) => [...point]));
    const line = new Line2(geometry, material);
    if (material.dashed) line.computeLineDistances();
    return line;
  }
  private path(item: Path): Object3D[] {
    if (item.points.length < 2) return [];
    const sides: Side[] = item.on_ball ? ["front", "back"] : ["all"];
    return sides.map((side) => this.line(item.points, this.line_material(item, side)));
  }
  private arrow(item: Arrow): Object3D[] {
    const along = unit(minus(item.to, item.from)),
      whole = length(minus(item.to, item.from)),
      tip = Math.min(head.length, whole / 2);
    if (whole < 1e-9) return [];
    const shaft = this.line([item.from, minus(item.to, times(tip, along))], this.line_material(item, "all"));
    const cone = new Mesh(this.cone, this.flat_material(item));
    cone.quaternion.copy(new Quaternion().setFromUnitVectors(up, new Vector3(...along)));
    cone.position.set(...minus(item.to, times(tip / 2, along)));
    cone.scale.setScalar((tip / head.length) * Math.min(1, 0.4 + 0.2 * (item.width ?? 3)));
    return [shaft, cone];
  }
  private dot(item: Dot): Object3D[] {
    const mesh = new Mesh(this.ball, this.solid_material(item));
    mesh.position.set(...item.at);
    mesh.scale.setScalar(item.size ?? 0.025);
    return [mesh];
  }
  private fan(item: Fan): Object3D[] {
    const corners = item.rim.slice(1).flatMap((point, k) => [...item.apex, ...item.rim[k]!, ...point]);
    return [this.surface(corners, this.flat_material(item))];
  }
  private band(item: Band): Object3D[] {
    const inner = circle(item.axis, item.inner),
      outer = circle(item.axis, item.outer);
    const corners = inner.slice(1).flatMap((a, k) => {
      const [b, c, d] = [inner[k]!, outer[k]!, outer[k + 1]!];
      return [...a, ...b, ...c, ...a, ...c, ...d];
    });
    return [this.surface(corners, this.flat_material(item))];
  }
  private craft(item: Craft): Object3D[] {
    const {frame, at = [0, 0, 0], size = 1} = item;
    const axes = [0, 1, 2].map((k) => times(size, column(frame, k)));
    const corners = craft_triangles.flatMap(([x, y, z]) => [
      ...plus(at, plus(times(x, axes[0]!), plus(times(y, axes[1]!), times(z, axes[2]!)))),
    ]);
    return [this.surface(corners, this.solid_material(item))];
  }
  private surface(corners: readonly number[], material: Material): Mesh {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(corners, 3));
    geometry.computeVertexNormals();
    return new Mesh(geometry, material);
  }
}
