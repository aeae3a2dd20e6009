import {mount, unmount} from "svelte";
import OutlineChoice from "./OutlineChoice.svelte";
import type {Shape} from "./shapes";

/** The one that the user takes; nothing where the dialog is closed. Where there is only one, it is not asked for. */
export function chosen_shape(
  shapes: readonly Shape[],
  name: string,
  factor: number,
  unit: string,
): Promise<Shape | null> {
  if (shapes.length <= 1) return Promise.resolve(shapes[0] ?? null);
  return new Promise((resolve) => {
    const dialog = mount(OutlineChoice, {
      target: document.body,
      props: {
        shapes,
        name,
        factor,
        unit,
        done: (shape: Shape | null) => {
          resolve(shape);
          void unmount(dialog);
        },
      },
    });
  });
}
