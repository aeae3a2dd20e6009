import {read_palette, type Palette} from "./palette";

/** The colours in force, read anew when the theme changes. Made in a component, ends with it. */
export class Theme {
  palette = $state.raw<Palette>(read_palette(getComputedStyle(document.documentElement)));
  /** Device pixels per CSS pixel. */
  ratio = $state(devicePixelRatio);

  constructor() {
    $effect(() => {
      const read = () => (this.palette = read_palette(getComputedStyle(document.documentElement)));
      const observer = new MutationObserver(read);
      observer.observe(document.documentElement, {attributes: true, attributeFilter: ["data-theme"]});
      const resized = () => (this.ratio = devicePixelRatio);
      addEventListener("resize", resized);
      read();
      return () => {
        observer.disconnect();
        removeEventListener("resize", resized);
      };
    });
  }
}
