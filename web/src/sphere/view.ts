// How one looks at a ball: freely, in perspective, or flat, along an axis without perspective. The camera only.
import {Matrix4, OrthographicCamera, PerspectiveCamera, Quaternion, Vector3, type Camera} from "three";
import {first_eye, type Vec3} from "./vectors";

export type Flat = "x" | "y" | "z";
export interface Size {
  width: number;
  height: number;
}
/** A place on the canvas in CSS pixels from its upper left corner. */
export interface Spot {
  x: number;
  y: number;
}

const view_angle = 26,
  least_zoom = 0.4,
  most_zoom = 6;
const looks: Record<Flat, [from: Vec3, up: Vec3]> = {
  x: [
    [1, 0, 0],
    [0, 0, 1],
  ],
  y: [
    [0, -1, 0],
    [0, 0, 1],
  ],
  z: [
    [0, 0, 1],
    [0, 1, 0],
  ],
};

function looking(from: Vec3, up: Vec3): Quaternion {
  const matrix = new Matrix4().lookAt(new Vector3(...from), new Vector3(), new Vector3(...up));
  return new Quaternion().setFromRotationMatrix(matrix);
}
const first_look = () => looking(first_eye, [0, 0, 1]);

export class View {
  private readonly perspective = new PerspectiveCamera(view_angle, 1, 0.1, 100);
  private readonly parallel = new OrthographicCamera(-1, 1, 1, -1, 0.1, 100);
  private free = first_look();
  private size: Size = {width: 1, height: 1};
  flat: Flat | null = null;
  zoom = 1;

  /** `reach`: what is to be in the window, from the middle. */
  constructor(private reach = 1.4) {
    this.place();
  }

  get camera(): Camera {
    return this.flat ? this.parallel : this.perspective;
  }
  /** From the middle to the eye. */
  get towards_eye(): Vec3 {
    const {x, y, z} = new Vector3(0, 0, 1).applyQuaternion(this.look);
    return [x, y, z];
  }
  /** To the right and up on the canvas. */
  get across(): readonly [Vec3, Vec3] {
    const of = (x: number, y: number) => new Vector3(x, y, 0).applyQuaternion(this.look).toArray() as unknown as Vec3;
    return [of(1, 0), of(0, 1)];
  }
  /** How far before the middle the ball's outline lies. */
  get horizon(): number {
    return this.flat ? 0 : 1 / this.away;
  }
  private get look(): Quaternion {
    return this.flat ? looking(...looks[this.flat]) : this.free;
  }
  private get away(): number {
    const narrow = Math.min(this.size.width / this.size.height, 1);
    return this.reach / (Math.sin((view_angle * Math.PI) / 360) * narrow * this.zoom);
  }

  resize(size: Size): void {
    this.size = size;
    this.place();
  }
  /** A drag by so many pixels turns what is seen as if the ball were rolled. */
  roll(dx: number, dy: number): void {
    const ball = Math.min(this.size.width, this.size.height) / 2.4;
    if (this.flat) this.free = this.look.clone();
    this.flat = null;
    const turn = new Quaternion().setFromAxisAngle(new Vector3(-dy, -dx, 0).normalize(), Math.hypot(dx, dy) / ball);
    if (dx !== 0 || dy !== 0) this.free.multiply(turn).normalize();
    this.place();
  }
  look_along(flat: Flat | null): void {
    this.flat = flat;
    this.place();
  }
  zoom_by(factor: number): void {
    this.zoom = Math.min(Math.max(this.zoom * factor, least_zoom), most_zoom);
    this.place();
  }
  reset(): void {
    this.free = first_look();
    this.zoom = 1;
    this.flat = null;
    this.place();
  }
  private place(): void {
    const {away, camera} = this,
      aspect = this.size.width / this.size.height;
    camera.quaternion.copy(this.look);
    camera.position.set(...this.towards_eye).multiplyScalar(this.flat ? 10 : away);
    this.perspective.aspect = aspect;
    this.perspective.near = Math.max(away - 4, 0.05);
    this.perspective.far = away + 6;
    const half = this.reach / (Math.min(aspect, 1) * this.zoom);
    [this.parallel.top, this.parallel.bottom] = [half, -half];
    [this.parallel.right, this.parallel.left] = [half * aspect, -half * aspect];
    this.perspective.updateProjectionMatrix();
    this.parallel.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  /** Where a point is seen. */
  spot(at: Vec3): Spot {
    const {x, y} = new Vector3(...at).project(this.camera);
    return {x: ((x + 1) / 2) * this.size.width, y: ((1 - y) / 2) * this.size.height};
  }
  /** The point of the ball's near side under a spot; beyond the outline the nearest of that. */
  on_ball(spot: Spot): Vec3 {
    const {from, along} = this.ray(spot),
      a = new Vector3(...from),
      d = new Vector3(...along),
      half = a.dot(d),
      under_root = half ** 2 - a.lengthSq() + 1;
    const at = a.addScaledVector(d, under_root > 0 ? -half - Math.sqrt(under_root) : -half).normalize();
    return at.toArray() as unknown as Vec3;
  }
  /** The line of sight through a spot. */
  ray({x, y}: Spot): {from: Vec3; along: Vec3} {
    const at = (depth: number) =>
      new Vector3((2 * x) / this.size.width - 1, 1 - (2 * y) / this.size.height, depth).unproject(this.camera);
    const near = at(-1),
      along = at(1).sub(near).normalize();
    return {from: near.toArray() as unknown as Vec3, along: along.toArray() as unknown as Vec3};
  }
}
