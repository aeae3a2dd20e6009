/** Which of the three layouts is in force: wide from 1241 px, phone up to 700 px or on its side. */
class ScreenSize {
  width = $state(globalThis.innerWidth ?? 1440);
  height = $state(globalThis.innerHeight ?? 900);
  constructor() {
    globalThis.addEventListener?.("resize", () => {
      this.width = innerWidth;
      this.height = innerHeight;
    });
  }
  get kind(): "wide" | "laptop" | "phone" {
    if (this.width <= 700 || this.height < 500) return "phone";
    return this.width > 1240 ? "wide" : "laptop";
  }
  /** A phone on its side: drawing and map stand beside each other. */
  get landscape(): boolean {
    return this.kind === "phone" && this.width > this.height;
  }
}
export const screen_size = new ScreenSize();
