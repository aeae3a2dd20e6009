// Lists of derivatives by one parameter, a function's value first: its sum, product, … has as many as its shorter part.
export type Derivatives = readonly number[];

export function product(f: Derivatives, g: Derivatives): number[] {
  return Array.from({length: Math.min(f.length, g.length)}, (_, n) => leibniz(f, g, n, 0, n));
}
export function quotient(f: Derivatives, g: Derivatives): number[] {
  const q: number[] = [];
  for (let n = 0; n < Math.min(f.length, g.length); ++n) q.push((f[n]! - leibniz(q, g, n, 0, n - 1)) / g[0]!);
  return q;
}
export function square_root(f: Derivatives): number[] {
  const root: number[] = [];
  for (let n = 0; n < f.length; ++n)
    root.push(n === 0 ? Math.sqrt(f[0]!) : (f[n]! - leibniz(root, root, n, 1, n - 1)) / (2 * root[0]!));
  return root;
}
/** Derivatives of f by s, the first onwards, from f', f'', … and s', s'', … by any parameter. */
export function by_parameter(f: Derivatives, s: Derivatives): number[] {
  const rates: number[] = [];
  for (let rate = quotient(f, s); rate.length > 0; rate = quotient(rate.slice(1), s)) rates.push(rate[0]!);
  return rates;
}

/** Terms `from` … `to` of the n-th derivative of a product. */
function leibniz(f: Derivatives, g: Derivatives, n: number, from: number, to: number): number {
  let sum = 0;
  for (let k = 0, binomial = 1; k <= to; binomial = (binomial * (n - k)) / (k + 1), ++k)
    if (k >= from) sum += binomial * f[k]! * g[n - k]!;
  return sum;
}
