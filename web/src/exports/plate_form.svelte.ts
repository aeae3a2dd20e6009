import type {PlateSizes} from "../contract/messages";

export type PlateSize = Exclude<keyof PlateSizes, "gap">;

/** The sizes of plates and pins that are given, user's unit; the engine chooses the others. */
class PlateChoice {
  sizes = $state.raw<Partial<PlateSizes>>({});

  give(size: PlateSize, value: number | null): void {
    const {[size]: _, ...others} = this.sizes;
    this.sizes = value === null ? others : {...others, [size]: value};
  }
}
export const plate_choice = new PlateChoice();
