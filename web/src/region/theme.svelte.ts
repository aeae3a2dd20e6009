import {screen_size} from "../state/screen.svelte";
import {read_palette, type Palette} from "./palette";

/** The colours in force, read anew when the theme changes. Made in a component, ends with it. */
export class Theme {
  palette = $state.raw<Palette>(read_palette());
  /** Device pixels per CSS pixel. */
  get ratio(): number {
    return screen_size.ratio;
  }

  constructor() {
    $effect(() => {
      const read = () => (this.palette = read_palette());
      const observer = new MutationObserver(read);
      observer.observe(document.documentElement, {attributes: true, attributeFilter: ["data-theme"]});
      read();
      return () => observer.disconnect();
    });
  }
}
