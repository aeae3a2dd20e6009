// The drawing's own state: what part it shows, what the pointer is over, what is being drawn. Not part of the task.
import {getContext, setContext, untrack} from "svelte";
import type {Box, InstantReport, Linkage, Point, Replies, Side} from "../contract/messages";
import type {End} from "../figure/figure";
import {at_angle, at_row, reached_rows, type Carrier, type Configuration} from "../figure/mechanism";
import {Question} from "../questions/question.svelte";
import type {Halo} from "../state/answers.svelte";
import {halo_reach} from "../state/halo_follower";
import {preferences} from "../state/preferences.svelte";
import {outline_of, placed, type Problem} from "../state/problem";
import {screen_size} from "../state/screen.svelte";
import {poses_of, served_poses, type Pose, type Task} from "../state/task";
import type {Workbench} from "../state/workbench.svelte";
import {curves_of, nearest, point_at, samples_of_sides, type CurveSamples, type Spot} from "./curve_samples";
import {
  border_hit,
  box_handles,
  box_names,
  corner_handles,
  edge_cursor,
  inside,
  pivot_handles,
  pose_handles,
  ranks,
  target_id,
  within_reach,
  type BoxName,
  type Handle,
  type Target,
} from "./handles";
import {anchors_of, kind_of} from "../kinds/kind_dispatch";
import {mistake_sentence} from "../task_panel/mistakes";
import type {TaskView} from "../kinds/view";
import {near, task_points, useful_pivots} from "./fit";
import type {Drag} from "./drags/drag";
import type {Guide} from "./snapping";
import {Plane} from "./space";
import {surface_key, type Note, type Surface} from "./surface";
import type {Viewport} from "./viewport";

const curve_reach = [8, 20] as const,
  halo_turn_deg = 30;

/** The pivots of a four-bar, as files name them. */
type Quadrilateral = Readonly<Record<"input_center" | "input_circle" | "output_center" | "output_circle", Point>>;

export class Scene implements Surface {
  view = $state.raw<Viewport>({x: 0, y: 0, scale: 1, width: 0, height: 0});
  /** The user has zoomed, panned or edited: the view is his. */
  touched = $state(false);
  hovered = $state.raw<Target | null>(null);
  /** What is being dragged. */
  held = $state.raw<Target | null>(null);
  note = $state.raw<Note | null>(null);
  guides = $state.raw<readonly Guide[]>([]);
  spot = $state.raw<Spot | null>(null);
  /** A held pose, or a point, as it was pressed: the halo lies about it. */
  pressed = $state.raw<Pose | null>(null);
  /** Where a part of the task stood when it was pressed, if it stays there while it is dragged. */
  anchor = $state.raw<Point | null>(null);
  /** Pixels from the origin to the pointer that turns a pose. */
  arm = $state<number | null>(null);
  rubber = $state.raw<{box: BoxName; shape: Box} | null>(null);
  /** Corners clicked so far, body coordinates; null: the outline there is is being edited. */
  draft = $state.raw<readonly Point[] | null>(null);
  corner = $state<number | null>(null);
  pointer = $state.raw<Point | null>(null);
  /** Two points of the background picture whose distance is known. */
  marks = $state.raw<readonly Point[]>([]);
  focused = $state<string | null>(null);

  /** What the picture behind the drawing lets take hold of, while it is placed. */
  picture_parts: () => Handle[] = () => [];
  /** What analyses let take hold of. */
  analysis_parts: () => Handle[] = () => [];

  /** `kind`: what the kind of a task shows and lets take hold of. */
  private readonly instants: Question<Quadrilateral, Replies["report"]>;

  constructor(
    readonly workbench: Workbench,
    private readonly kind: (task: Task) => Pick<TaskView, "mechanism" | "handles" | "with_clicked" | "stroke">,
  ) {
    this.instants = new Question(workbench.questions, {follows: true}); // a frame of the animation is shorter than an answer may take
  }

  readonly space = $derived.by(() => new Plane(this.view, preferences.snap));

  // ---- what there is ------------------------------------------------------------------------------------------

  readonly poses = $derived.by(() => poses_of(this.workbench.problem.task));
  readonly origins = $derived.by(() => this.poses.map(({x, y}): Point => [x, y]));
  /** Those that a linkage passes exactly. */
  readonly served = $derived.by(() => served_poses(this.workbench.problem.task));
  readonly outline = $derived.by(() => outline_of(this.workbench.problem));
  /** Without an outline of its own, the body is sized from the poses, so it takes two. */
  readonly has_body = $derived.by(
    () =>
      this.poses.length > 1 || (this.poses.length === 1 && (this.workbench.problem.view?.outline?.length ?? 0) >= 3),
  );
  readonly boxes = $derived.by((): Record<BoxName, Box | null> => {
    const {problem, search_box} = this.workbench,
      {requirements} = problem;
    return {
      ground: requirements?.ground_pivots_within ?? null,
      moving: requirements?.moving_pivots_within ?? null,
      search: search_box,
    };
  });

  private readonly curves = $derived.by(() => this.workbench.task?.curves);
  private readonly output_curves = $derived.by(() => this.workbench.task?.output_curves);
  private readonly axes = $derived.by(() => this.workbench.task?.axes);
  readonly samples = $derived.by(() => {
    void [this.curves, this.output_curves, this.axes]; // not with what is required
    const task = untrack(() => this.workbench.task);
    // Where a point is guided each linkage is found whole: there are no grounded links to choose by themselves.
    if (!task || this.mechanism.guides_a_point) return {input: null, output: null};
    const points = untrack(() => anchors_of(this.workbench.problem.task)),
      count = points.length || 1;
    return samples_of_sides(task, [
      points.reduce((sum, p) => sum + p[0], 0) / count,
      points.reduce((sum, p) => sum + p[1], 0) / count,
    ]);
  });
  /** One for both sides where they are the same. */
  readonly distinct_samples = $derived.by((): CurveSamples[] => {
    const {input, output} = this.samples;
    return [input, output === input ? null : output].filter((samples) => samples !== null);
  });

  readonly mechanism = $derived.by(() => this.kind(this.workbench.problem.task).mechanism);
  /** The linkage as it stands: at the drive's angle, or, without a drive, at the nearest position. */
  readonly now = $derived.by((): Configuration | null => {
    const {hand, angle, stage} = this.workbench;
    if (!hand) return null;
    return hand.drive
      ? at_angle(this.mechanism, hand, hand.drive, angle)
      : this.mechanism.still(hand, this.served, stage);
  });
  /** Of a four-bar without sliders, as it stands: what its instant is told of. */
  readonly instant_pivots = $derived.by((): Quadrilateral | null => {
    const {input, output} = this.now?.ends ?? {};
    if (!this.mechanism.has_instant || !input?.center || !input.circle || !output?.center || !output.circle)
      return null;
    return {
      input_center: input.center,
      input_circle: input.circle,
      output_center: output.center,
      output_circle: output.circle,
    };
  });
  /** What the instant tells of the linkage as it stands, where that is shown. */
  get instant(): InstantReport | null {
    return (this.instants.value?.report as InstantReport | undefined) ?? null;
  }
  follow_instant(pivots: Quadrilateral | null): void {
    const {driver_client} = this.workbench;
    if (!pivots) this.instants.forget();
    else if (driver_client)
      void this.instants.ask(pivots, () =>
        driver_client.follow("report", {of: "instant", text: JSON.stringify({pivots})}),
      );
  }
  /** What carries an end of a grounded link; nothing on the ground. */
  carrier(side: Side, end: End): Carrier | null {
    const {hand} = this.workbench;
    return hand && this.now && this.mechanism.carrier(hand, side, end, this.now, this.served[0]);
  }
  /** There are curves of ground pivots, not of moving ones only. */
  readonly has_center_curves = $derived.by(() =>
    this.distinct_samples.some((samples) => curves_of(samples).includes("center")),
  );
  /** The pose on which the outline is edited. */
  readonly outline_pose = $derived.by(() => this.poses[this.workbench.selected_pose ?? 0] ?? this.poses[0] ?? null);

  readonly box_handles = $derived.by(() => [
    ...box_names.flatMap((name) => (this.boxes[name] ? box_handles(name, this.boxes[name], this.space) : [])),
  ]);
  readonly pose_handles = $derived.by(() =>
    pose_handles(this.workbench.problem, this.space, this.workbench.selected_pose, screen_size.kind === "phone"),
  );
  readonly task_handles = $derived.by(() => this.kind(this.workbench.problem.task).handles?.(this) ?? []);
  readonly pivot_handles = $derived.by(() =>
    this.workbench.hand && this.now ? pivot_handles(this.workbench.hand, this.now.ends, this.space) : [],
  );
  readonly corner_handles = $derived.by(() => {
    const editing = this.workbench.mode === "outline" && this.draft === null && this.outline_pose;
    return editing ? corner_handles(this.outline, this.outline_pose, this.space) : [];
  });
  readonly picture_handles = $derived.by(() => (this.workbench.mode === "scale" ? this.picture_parts() : []));
  readonly analysis_handles = $derived.by(() => this.analysis_parts());
  /** Without those that a handle of the task stands for. */
  private readonly own_pivot_handles = $derived.by(() =>
    this.pivot_handles.filter(({id}) => !this.task_handles.some((handle) => handle.id === id)),
  );
  /** In reading order. */
  readonly handles = $derived.by((): Handle[] => [
    ...this.corner_handles,
    ...this.picture_handles,
    ...this.pose_handles,
    ...this.task_handles,
    ...this.analysis_handles,
    ...this.own_pivot_handles,
    ...this.box_handles,
  ]);

  /** What the status line says of snapping: step in the user's unit, or nothing while it is off. */
  get snap_step(): number | null {
    return this.space.snaps ? this.space.step : null;
  }

  task_points(): Point[] {
    const {task} = this.workbench.problem;
    return task_points(
      [...anchors_of(task), ...(kind_of(task).around?.(task) ?? [])],
      this.poses,
      this.outline,
      this.has_body,
    );
  }

  /** What of a linkage is to be shown with what lies around: its joints in the positions, and where there are no poses, or
   *  one asks for all, wherever they get to. */
  pivots(linkage: Linkage | null, around: readonly Point[], sizes = near): Point[] {
    if (!linkage) return [];
    const {drive} = linkage,
      {mechanism, served} = this,
      rows = this.poses.length === 0 || sizes > near ? reached_rows(linkage) : [];
    const visited = drive ? rows.flatMap((row) => at_row(mechanism, linkage, drive, row).joints) : [],
      visits = mechanism.visits(linkage, served).flatMap((bodies) => bodies.flatMap(({corners}) => corners));
    return useful_pivots([...mechanism.pivots(linkage), ...visits, ...visited], around, sizes);
  }

  /** With what a click at a point of the fixed frame adds to the task; null: nothing. */
  with_clicked(at: Point): Problem | null {
    const {problem} = this.workbench;
    return this.kind(problem.task).with_clicked?.(problem, at) ?? null;
  }

  /** What a pointer draws that is pressed at a place of the screen; null: the task is not drawn. */
  stroke(from: Point): Drag | null {
    return this.kind(this.workbench.problem.task).stroke?.(this, from) ?? null;
  }

  // ---- gestures -----------------------------------------------------------------------------------------------

  tell(at: Point, text: string, reason?: string | null): void {
    const [mistake] = this.workbench.refusal ?? [];
    this.note = {at, text, reason: reason === undefined && mistake ? mistake_sentence(mistake) : reason};
  }
  show_halo(part: number, pressed: Pose, mode: Halo["mode"] = "move"): void {
    if (this.workbench.incomplete) return;
    this.pressed = pressed;
    void this.workbench.fetch_halo(part, mode, mode === "move" ? halo_reach(this.poses) : halo_turn_deg);
  }
  finish(keep: boolean): void {
    this.held = this.note = this.pressed = this.anchor = this.arm = this.rubber = null;
    this.guides = [];
    this.workbench.held_pose = null;
    if (keep) this.workbench.end_gesture();
    else this.workbench.cancel_gesture();
  }

  // ---- what is under the pointer ------------------------------------------------------------------------------

  /** All targets at a point of the screen, the first to be taken first. */
  targets_at(at: Point, touch: boolean): {target: Target; cursor: string}[] {
    const boxes = this.boxes_at(at, touch),
      near = within_reach(
        [...this.handles.filter((h) => h.target.kind !== "box" || h.cursor !== "move"), ...boxes],
        at,
        touch,
      );
    return [...near.filter(unique), ...this.curves_at(at, touch), ...this.bodies_at(at)];
  }
  private boxes_at(at: Point, touch: boolean): Handle[] {
    const found: Handle[] = [];
    for (const name of box_names) {
      const box = this.boxes[name],
        hit = box && border_hit(box, this.space, at, touch ? 20 : 8);
      if (!hit) continue;
      const target: Target = {kind: "box", box: name, edges: hit.edges};
      found.push({
        id: target_id(target),
        target,
        at,
        rank: ranks.box + hit.distance / 1000,
        reach: [8, 20],
        cursor: edge_cursor(hit.edges),
        tab: false,
      });
    }
    return found;
  }
  private bodies_at(at: Point): {target: Target; cursor: string}[] {
    if (!this.has_body) return [];
    const found = this.poses.flatMap((pose, i) =>
      inside(
        this.outline.map((p) => this.space.project(placed(p, pose))),
        at,
      )
        ? [{target: {kind: "body", pose: i} as Target, cursor: "move"}]
        : [],
    );
    const first = found.findIndex(({target}) => target.kind === "body" && target.pose === this.workbench.selected_pose);
    return first > 0 ? [...found.splice(first, 1), ...found] : found;
  }
  private curves_at(at: Point, touch: boolean): {target: Target; cursor: string}[] {
    return this.distinct_samples
      .flatMap((samples) => curves_of(samples).flatMap((curve) => nearest(samples, curve, this.view, at) ?? []))
      .filter((spot) => spot.distance <= curve_reach[touch ? 1 : 0])
      .sort((a, b) => a.distance - b.distance)
      .map((spot) => ({target: {kind: "curve", spot} as Target, cursor: "pointer"}));
  }

  /** Both ends of the grounded link at a spot, as in position 1. */
  dyad_at(spot: Spot): {center: Point | null; circle: Point | null} | null {
    const samples = this.samples[spot.sides[0]];
    return samples && {center: point_at(samples, "center", spot), circle: point_at(samples, "circle", spot)};
  }
}

function unique(handle: Handle, index: number, all: readonly Handle[]): boolean {
  return all.findIndex((h) => h.id === handle.id) === index;
}

export function provide_scene(scene: Scene): Scene {
  return setContext(surface_key, scene);
}
export function use_scene(): Scene {
  return getContext<Scene>(surface_key);
}
