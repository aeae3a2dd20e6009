/** How large the window is and how fine. Which of the three layouts is in force: wide from 1241 px, phone up to 700 px or on its side. */
class ScreenSize {
  width = $state(globalThis.innerWidth ?? 1440);
  height = $state(globalThis.innerHeight ?? 900);
  /** Device pixels per CSS pixel. */
  ratio = $state(globalThis.devicePixelRatio ?? 1);
  constructor() {
    globalThis.addEventListener?.("resize", () => {
      this.width = innerWidth;
      this.height = innerHeight;
    });
    this.watch_ratio();
  }
  /** It changes without a resize where the window goes to another screen. */
  private watch_ratio(): void {
    this.ratio = globalThis.devicePixelRatio ?? 1;
    globalThis
      .matchMedia?.(`(resolution: ${this.ratio}dppx)`)
      .addEventListener("change", () => this.watch_ratio(), {once: true});
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
