// A machine in space, and how one looks at it. Lengths are the user's; of planar linkages z points at the viewer, and z = 0
// is the back of the ground plate. Nothing is drawn but when something has changed.
import {
  AmbientLight,
  Color,
  DirectionalLight,
  DoubleSide,
  FrontSide,
  HemisphereLight,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  Plane,
  PlaneGeometry,
  Raycaster,
  Scene,
  ShadowMaterial,
  Sphere,
  Vector2,
  Vector3,
  VSMShadowMap,
  WebGLRenderer,
} from "three";
import {OrbitControls} from "three/examples/jsm/controls/OrbitControls.js";
import type {Viewport} from "../drawing/viewport";
import type {Point, Side} from "../contract/messages";
import type {End, Joint} from "../figure/figure";
import type {Span} from "../transport/play";
import {SolidModel, type Solid, type SolidColor} from "./model";

export type SolidColors = Record<SolidColor, string>;
/** One of the pivots of the grounded links. */
export interface SolidPivot {
  side: Side;
  end: End;
}
const view_angle = 32,
  half_slope = Math.tan((view_angle * Math.PI) / 360),
  towards_light = new Vector3(-1.2, 1.9, 3.2).normalize(),
  towards_eye = new Vector3(-0.38, 0.34, 1).normalize(),
  glide_ms = 120;

export class SolidScene {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(view_angle, 1);
  private readonly controls: OrbitControls;
  private readonly light = new DirectionalLight(0xffffff, 1.9);
  /** Behind it, or below: shows nothing but shadow. */
  private readonly wall = new Mesh(new PlaneGeometry(), new ShadowMaterial({opacity: 0.22}));
  private readonly materials = new Map<string, {color: SolidColor; material: MeshStandardMaterial}>();
  private model: SolidModel | null = null;
  private reached = new Sphere();
  private corners: readonly Vector3[] = []; // of what is to be in the window
  private joints: readonly Joint[] = []; // as they stand now
  private angle_deg = 0;
  private asked = 0;
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
    this.scene.add(this.wall, this.light, this.light.target);
    this.scene.add(new HemisphereLight(0xffffff, 0xb8c0c8, 1.3), new AmbientLight(0xffffff, 0.5));
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
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

  /** The view stays where the user has turned it, but for a machine that is elsewhere, or of quite another size. `span`:
   *  the driver angles between which all of it is to be seen. */
  show(solid: Solid, [low, high]: Span): void {
    this.clear();
    const before = this.reached,
      model = (this.model = new SolidModel(solid, this.material));
    this.scene.add(model.object);
    this.corners = model.reach(low, high);
    this.reached = new Sphere().setFromPoints([...this.corners]);
    this.put_light(model);
    this.move(this.angle_deg, this.joints);
    if (before.isEmpty()) this.fit();
    else if (!is_like(before, this.reached)) this.fit(this.arm().normalize());
  }
  clear(): void {
    this.model?.object.removeFromParent();
    this.model?.dispose();
    this.model = null;
    this.ask();
  }
  move(angle_deg: number, joints: readonly Joint[]): void {
    [this.angle_deg, this.joints] = [angle_deg, joints];
    this.model?.move(angle_deg);
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
    for (const {color, material} of this.materials.values()) material.color.set(colors[color]);
    this.ask();
  }

  // ---- the eye ------------------------------------------------------------------------------------------------

  /** At first from a little above and to the left of straight ahead; what lies about a centre from its own side. */
  private get ahead(): Vector3 {
    if (!this.model?.is_about_a_centre) return towards_eye;
    const side = this.corners.reduce((sum, corner) => sum.add(corner), new Vector3()).normalize(),
      towards = side.addScaledVector(towards_eye, 0.5).normalize();
    return Math.abs(towards.dot(this.camera.up)) < 0.9 ? towards : towards_eye; // straight above there is no left
  }
  /** Everything in the window. */
  fit(towards = this.ahead): void {
    const {center, radius} = this.reached,
      right = new Vector3().crossVectors(this.camera.up, towards).normalize(),
      up = new Vector3().crossVectors(towards, right),
      slope = 0.92 * half_slope;
    let away = 0;
    for (const corner of this.corners) {
      const arm = corner.clone().sub(center),
        near = arm.dot(towards);
      away = Math.max(away, near + Math.abs(arm.dot(up)) / slope);
      away = Math.max(away, near + Math.abs(arm.dot(right)) / (slope * this.camera.aspect));
    }
    [this.camera.near, this.camera.far] = [0.02 * radius, 60 * radius];
    [this.controls.minDistance, this.controls.maxDistance] = [0.3 * radius, 30 * radius];
    this.camera.updateProjectionMatrix();
    this.look(center.clone(), center.clone().addScaledVector(towards, away));
  }
  turn(right: number, up: number): void {
    const {target} = this.controls,
      arm = this.arm();
    arm
      .applyAxisAngle(this.camera.up, right)
      .applyAxisAngle(new Vector3(1, 0, 0).applyQuaternion(this.camera.quaternion), up);
    this.look(target.clone(), target.clone().add(arm));
  }
  /** From what one looks at to the eye. */
  private arm(): Vector3 {
    return this.camera.position.clone().sub(this.controls.target);
  }
  /** While something else follows the pointer, the view does not turn. */
  hold_view(held: boolean): void {
    this.controls.enabled = !held;
  }
  private look(target: Vector3, eye: Vector3): void {
    this.controls.target.copy(target);
    this.camera.position.copy(eye);
    this.controls.update();
    this.ask();
  }
  /** Double-click on a part: look square at it. */
  private readonly look_square = (event: MouseEvent): void => {
    const box = this.canvas.getBoundingClientRect(),
      hit =
        this.model && this.ray([event.clientX - box.left, event.clientY - box.top]).intersectObject(this.model.object);
    if (!hit?.[0]) return;
    const {point} = hit[0],
      away = this.arm().length(),
      square = this.model!.is_about_a_centre ? point.clone().normalize() : new Vector3(0, 0, 1);
    this.glide(point, point.clone().addScaledVector(square, away));
  };
  private glide(target: Vector3, eye: Vector3): void {
    const from = {target: this.controls.target.clone(), eye: this.camera.position.clone()},
      began = performance.now();
    if (this.still) return this.look(target, eye);
    const frame = (now: number) => {
      const share = Math.min((now - began) / glide_ms, 1);
      this.look(from.target.clone().lerp(target, share), from.eye.clone().lerp(eye, share));
      if (share < 1) requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }
  private ask(): void {
    if (this.asked || this.size.width === 0) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = 0;
      this.renderer.render(this.scene, this.camera);
    });
  }

  // ---- the mechanism's plane ----------------------------------------------------------------------------------

  /** The pivot whose pin shows within `reach` pixels of a place on the canvas. */
  pivot_at(at: Point, reach: number): SolidPivot | null {
    const in_front = this.joints.toReversed().flatMap(({end, at: place}) => {
      const [x, y] = this.seen(place);
      return end ? [{end, apart: Math.hypot(x - at[0], y - at[1])}] : [];
    });
    const [nearest] = in_front.sort((a, b) => a.apart - b.apart);
    return nearest && nearest.apart <= reach ? nearest.end : null;
  }
  /** Where a pivot shows on the canvas. */
  pixel_of({side, end}: SolidPivot): Point | null {
    const joint = this.joints.find((joint) => joint.end?.side === side && joint.end.end === end);
    return joint && this.model ? this.seen(joint.at) : null;
  }
  private seen([x, y]: Point): Point {
    const seen = new Vector3(x, y, this.model?.middle ?? 0).project(this.camera);
    return [((seen.x + 1) / 2) * this.size.width, ((1 - seen.y) / 2) * this.size.height];
  }
  /** The point of the mechanism's plane under a place on the canvas; null where one looks along it. */
  plane_point(at: Point): Point | null {
    const plane = new Plane(new Vector3(0, 0, 1), -(this.model?.middle ?? 0)),
      hit = this.ray(at).ray.intersectPlane(plane, new Vector3());
    return hit && [hit.x, hit.y];
  }
  /** A flat view about as large as this one: what "outside of the window" and "so many pixels away" mean here. */
  flat_view(): Viewport {
    const {target} = this.controls,
      {width, height} = this.size,
      away = this.arm().length() || 1;
    return {x: target.x, y: target.y, scale: height / (2 * away * half_slope), width, height};
  }
  private ray([x, y]: Point): Raycaster {
    const ray = new Raycaster(),
      {width, height} = this.size;
    ray.setFromCamera(new Vector2((x / width) * 2 - 1, 1 - (y / height) * 2), this.camera);
    return ray;
  }

  // ---- looks --------------------------------------------------------------------------------------------------

  private put_light(model: SolidModel): void {
    const {center, radius} = this.reached,
      {camera} = this.light.shadow,
      reach = 1.3 * radius;
    this.light.target.position.copy(center);
    this.light.position.copy(center).addScaledVector(towards_light, 4 * radius);
    [camera.left, camera.right, camera.top, camera.bottom] = [-reach, reach, reach, -reach];
    [camera.near, camera.far] = [radius, 8 * radius];
    camera.updateProjectionMatrix();
    this.wall.scale.setScalar(6 * radius);
    this.wall.rotation.x = model.is_about_a_centre ? -Math.PI / 2 : 0;
    this.wall.position.copy(center);
    if (model.is_about_a_centre) this.wall.position.y -= radius;
    else this.wall.position.z = -0.002 * radius;
  }
  /** One to each colour: with the last material of its kind its shader would go, and be compiled again. */
  private readonly material = (color: SolidColor, opacity = 1): MeshStandardMaterial => {
    const key = `${color} ${opacity}`,
      known = this.materials.get(key);
    if (known) return known.material;
    const material = new MeshStandardMaterial({
      color: new Color(this.colors[color]),
      roughness: 0.62,
      metalness: 0,
      transparent: opacity < 1,
      opacity,
      side: opacity < 1 ? DoubleSide : FrontSide,
      depthWrite: opacity === 1,
    });
    this.materials.set(key, {color, material});
    return material;
  };
}

function is_like(before: Sphere, now: Sphere): boolean {
  const ratio = now.radius / before.radius;
  return ratio > 0.6 && ratio < 1.6 && before.center.distanceTo(now.center) < before.radius;
}
