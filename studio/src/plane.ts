// A plane of two curves: where its axes have marks, and the way of a point in it.

/** Some three to six round numbers between two others. */
export function ticks(low: number, high: number): number[] {
  const size = high - low;
  if (!(size > 0) || !Number.isFinite(size)) return [];
  const power = 10 ** Math.floor(Math.log10(size)), step = [0.2, 0.5, 1, 2].map((each) => each * power).find((each) => size / each <= 6)!;
  const first = Math.ceil(low / step - 1e-9);
  return Array.from({ length: Math.floor(high / step + 1e-9) - first + 1 }, (_, k) => Number(((first + k) * step).toPrecision(6)));
}

/** How far an axis goes at least: what is less than the error that a motion may have is no motion. size: of the picture [m] */
export function leastSpan(unit: string, size: number): number {
  if (/^(rad|deg)\b/.test(unit)) return 1e-8;
  return /^[cm]?m(\/s(\^2)?)?$/.test(unit) ? 1e-8 * size : 0;
}

/** From the least to the greatest of some values, with some room; round one that stays. */
export function extent(values: (number | null)[], least = 0): [number, number] {
  const known = values.filter((value) => value !== null), low = Math.min(...known), high = Math.max(...known);
  const room = high - low > least ? 0.05 * (high - low) : Math.abs(high) > least ? Math.abs(high) * 0.1 : 1;
  return known.length ? [low - room, high + room] : [0, 1];
}

/** The way of an SVG through points, interrupted where one has no place. */
export function way(points: ([number, number] | null)[]): string {
  return points.map((at, k) => (at ? `${k && points[k - 1] ? "L" : "M"}${at[0].toFixed(1)} ${at[1].toFixed(1)}` : "")).join("");
}
