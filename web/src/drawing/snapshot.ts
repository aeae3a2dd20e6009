// The drawing as a picture of its own: without handles, in the light theme's colours, on white.
const properties = [
  "fill",
  "fill-opacity",
  "stroke",
  "stroke-width",
  "stroke-opacity",
  "stroke-dasharray",
  "stroke-linecap",
  "stroke-linejoin",
  "opacity",
  "font-size",
  "font-weight",
  "font-family",
  "text-anchor",
  "paint-order",
] as const;
const defaults: Partial<Record<string, string>> = {
  "fill-opacity": "1",
  "stroke-opacity": "1",
  "stroke-dasharray": "none",
  "stroke-linecap": "butt",
  "stroke-linejoin": "miter",
  opacity: "1",
  "paint-order": "normal",
};
const namespace = "http://www.w3.org/2000/svg";

/** The text of an SVG file; nothing where there is no drawing on the page. */
export function drawing_svg(
  element: SVGSVGElement | null = document.querySelector<SVGSVGElement>("svg.drawing"),
): string | null {
  if (!element) return null;
  const root = document.documentElement,
    theme = root.dataset.theme;
  root.dataset.theme = "light"; // restored before anything is painted
  try {
    const copy = element.cloneNode(true) as SVGSVGElement;
    inline(element, copy);
    for (const handle of copy.querySelectorAll(".ui")) handle.remove();
    remove_comments(copy);
    return new XMLSerializer().serializeToString(framed(copy, element));
  } finally {
    if (theme === undefined) delete root.dataset.theme;
    else root.dataset.theme = theme;
  }
}

/** The drawing where something is shown in it that the engine's own does not have: an instant of the linkage, samples. */
export function drawing_with_more(): SVGSVGElement | null {
  return document.querySelector<SVGSVGElement>("svg.drawing:has(.instant, .samples)");
}

/** Computed styles become attributes; classes, test names and roles go. */
function inline(from: Element, to: Element): void {
  const style = getComputedStyle(from),
    drawn = !["g", "svg"].includes(from.localName);
  for (const name of properties) {
    const value = style.getPropertyValue(name);
    if (drawn && value && value !== defaults[name] && (from.localName === "text" || !/^(font|text)-/.test(name)))
      to.setAttribute(name, value.replaceAll("px", ""));
  }
  for (const {name} of [...to.attributes]) {
    if (name === "class" || name === "style" || name === "tabindex" || name === "role" || /^(data|aria)-/.test(name)) {
      if (name !== "class" || !to.classList.contains("ui")) to.removeAttribute(name);
    }
  }
  for (const [i, child] of [...from.children].entries()) inline(child, to.children[i]!); // a copy has as many
}
/** Svelte's anchors. */
function remove_comments(node: Node): void {
  for (const child of [...node.childNodes]) {
    if (child.nodeType === Node.COMMENT_NODE) child.remove();
    else remove_comments(child);
  }
}
function framed(copy: SVGSVGElement, element: SVGSVGElement): SVGSVGElement {
  const width = Math.round(element.clientWidth),
    height = Math.round(element.clientHeight);
  for (const {name} of [...copy.attributes]) copy.removeAttribute(name);
  copy.setAttribute("xmlns", namespace);
  copy.setAttribute("width", String(width));
  copy.setAttribute("height", String(height));
  copy.setAttribute("viewBox", `0 0 ${width} ${height}`);
  const paper = document.createElementNS(namespace, "rect");
  for (const [name, value] of Object.entries({width, height, fill: "#ffffff"})) paper.setAttribute(name, String(value));
  copy.prepend(paper);
  return copy;
}
