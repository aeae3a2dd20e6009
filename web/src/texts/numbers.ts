// Numbers for people. A minus is a minus sign; groups of three are set apart by a narrow space.

/** 159600 → "159 600". */
export function grouped(count: number): string {
  return String(Math.round(count)).replace(/\B(?=(\d{3})+$)/g, "\u202f");
}
/** Groups of three that the engine has set apart by spaces, so that no line ends between them. */
export function unbroken(text: string): string {
  return text.replace(/(\d) (?=\d{3}(?!\d))/g, "$1\u202f");
}
/** 9712 → "9.7k" for small places. */
export function short_count(count: number): string {
  if (count < 1000) return String(count);
  return count < 100_000 ? `${(count / 1000).toFixed(1)}k` : `${Math.round(count / 1000)}k`;
}
function signed(text: string): string {
  return /^-0(\.0*)?$/.test(text) ? text.slice(1) : text.replace(/^-/, "−");
}
export function fixed(value: number, decimals: number): string {
  return signed(value.toFixed(decimals));
}
/** At most so many significant digits, no trailing zeros. */
export function significant(value: number, digits: number): string {
  return signed(String(Number(value.toPrecision(digits))));
}
/** A length among lengths of about `typical` size: four or five significant digits. */
export function length_text(value: number, typical: number): string {
  const decimals = Math.min(Math.max(3 - Math.floor(Math.log10(Math.max(typical, 1e-12))), 0), 9);
  return fixed(value, Math.min(decimals, 9));
}
/** 0.984 → "98.4 %"; never all of them while some are bad. */
export function percent_text(share: number): string {
  const percent = share < 1 ? Math.min(Number((100 * share).toPrecision(3)), 99.9) : 100;
  return `${significant(percent, 4)}\u00a0%`;
}
const known_lengths = ["mm", "µm", "um", "cm", "dm", "m", "in", "ft"];
/** Of forces and torques, whatever lengths are in; where nobody knows what these are, a torque is told in them. */
export function mechanical_unit(quantity: string, unit: string): string | null {
  if (quantity === "force") return "N";
  if (quantity !== "torque") return null;
  return `N·${known_lengths.includes(unit.toLowerCase()) ? "m" : unit || "1"}`;
}
/** A degree sign stands close. */
export function with_unit(text: string, unit: string): string {
  return unit === "°" ? text + unit : `${text} ${unit}`.trim();
}
export function degrees_text(value: number, decimals = 1): string {
  return `${fixed(value, decimals)}°`;
}
