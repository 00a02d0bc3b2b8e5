// Marks of sliders, found by formulas and by motions.
import { expect, test } from "vitest";
import { together } from "../src/marking";

const ranges = [{ name: "mu", low: 0, high: 1, unit: "" }];
const at = (place: number, word: string, name = "mu") => ({ name, at: place, words: [word] });

test("what formulas say at a place needs no motions there", () => {
  expect(together([at(0.5, "exact")], [at(0.5003, "followed"), at(0.8, "new")], ranges)).toEqual([at(0.5, "exact"), at(0.8, "new")]);
});

test("marks of other sliders are their own", () => {
  expect(together([at(0.5, "exact", "m")], [at(0.5, "followed")], ranges)).toHaveLength(2);
});
