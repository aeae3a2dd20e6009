/** Values of CSS variables, by their names without the dashes: for what is drawn on canvases. */
export function css_values<Name extends string>(element: Element, names: readonly Name[]): Record<Name, string> {
  const style = getComputedStyle(element);
  return Object.fromEntries(
    names.map((name) => {
      const value = style.getPropertyValue(`--${name}`).trim();
      return [name, is_of_system(value) ? resolved(element, value) : value];
    }),
  ) as Record<Name, string>;
}
/** A colour of the system, or one mixed of it: not every canvas knows these. */
function is_of_system(value: string): boolean {
  return /^([A-Z]|color-mix)/.test(value);
}
function resolved(element: Element, value: string): string {
  const probe = document.createElement("i");
  probe.style.cssText = `display:none;forced-color-adjust:none;color:${value}`;
  element.append(probe);
  const {color} = getComputedStyle(probe),
    context = document.createElement("canvas").getContext("2d");
  probe.remove();
  if (!context) return value;
  context.fillStyle = color;
  context.fillRect(0, 0, 1, 1);
  const [red, green, blue] = context.getImageData(0, 0, 1, 1).data;
  return `#${[red!, green!, blue!].map((part) => part.toString(16).padStart(2, "0")).join("")}`;
}
