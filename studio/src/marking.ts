// Marks along sliders, from two sources.
import type { Mark, Range } from "./wire";

const SAME = 2e-3; // of a slider: what formulas say there needs no motions

/** All marks; of those found by motions the ones where no formula has one. */
export function together(byFormulas: Mark[], byMotions: Mark[], ranges: Range[]): Mark[] {
  const size = new Map(ranges.map(({ name, low, high }) => [name, high - low]));
  const isKnown = (mark: Mark) => byFormulas.some(({ name, at }) => name === mark.name && Math.abs(at - mark.at) <= SAME * (size.get(name) ?? 0));
  return [...byFormulas, ...byMotions.filter((mark) => !isKnown(mark))];
}
