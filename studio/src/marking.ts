// Marks along sliders, from two sources, and those that are near to each other as one.
import type { Mark, Range } from "./wire";

const SAME = 2e-3; // of a slider: what formulas say there needs no motions

/** All marks; of those found by motions the ones where no formula has one. */
export function together(byFormulas: Mark[], byMotions: Mark[], ranges: Range[]): Mark[] {
  const size = new Map(ranges.map(({ name, low, high }) => [name, high - low]));
  const isKnown = (mark: Mark) => byFormulas.some(({ name, at }) => name === mark.name && Math.abs(at - mark.at) <= SAME * (size.get(name) ?? 0));
  return [...byFormulas, ...byMotions.filter((mark) => !isKnown(mark))];
}

/** A place along a slider, and what happens there. */
export interface Place {
  at: number;
  said: string;
}

/** Places in their order; those that are nearer to the one before than `least` are together with it. */
export function grouped(places: Place[], least: number): Place[][] {
  const groups: Place[][] = [];
  for (const place of [...places].sort((a, b) => a.at - b.at)) {
    const before = groups.at(-1);
    if (before && place.at - before.at(-1)!.at < least) before.push(place);
    else groups.push([place]);
  }
  return groups;
}

/** Of a group the place to which a press leads: the first behind where the slider stands, or again the first of all. */
export function nextOf(group: Place[], value: number, range: number): number {
  return (group.find((place) => place.at > value + SAME * range) ?? group[0]!).at;
}

export function nearestTo(group: Place[], at: number): number {
  return group.reduce((best, place) => (Math.abs(place.at - at) < Math.abs(best.at - at) ? place : best)).at;
}
