import { describe, expect, test } from "vitest";
import { grouped, nearestTo, nextOf } from "../src/marking";

const at = (...places: number[]) => places.map((place) => ({ at: place, said: String(place) }));

describe("marks along a slider", () => {
  test("are one where they are nearer to each other than a finger", () => {
    expect(grouped(at(5, 1, 1.5, 9), 1)).toEqual([at(1, 1.5), at(5), at(9)]);
    expect(grouped(at(1, 1.5, 2.2), 1)).toEqual([at(1, 1.5, 2.2)]); // each near the one before
    expect(grouped([], 1)).toEqual([]);
  });
  test("lead from one to the next, and back to the first", () => {
    const group = at(1, 1.5, 2.2);
    expect([0, 1.3, 9].map((place) => nearestTo(group, place))).toEqual([1, 1.5, 2.2]);
    expect([0, 1, 1.001, 1.5, 2.2, 7].map((value) => nextOf(group, value, 10))).toEqual([1, 1.5, 1.5, 2.2, 1, 1]);
  });
});
