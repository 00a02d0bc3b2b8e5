// What lights up together: an arrow, the symbol of its force, and the same force on the other body.
import { expect, test } from "vitest";
import { isLit, isMarkLit, named, pointedAt, type Lights } from "../src/meanings";

const tension = { symbol: "T", bodies: ["left", "pulley"], owner: "rope", forces: ["rope.left"] };
const gravity = { symbol: "g", bodies: ["left", "right"], owner: "weight", forces: ["weight.left", "weight.right"] };

/** Of an element, what is asked here. */
const marked = (of: string) => ({ closest: () => ({ getAttribute: () => of }) }) as unknown as Element;
const symbol = (inside: Element) => ({ contains: (other: unknown) => other === inside }) as unknown as Element;

const word = marked("force rope.left"), elsewhere = marked("");
const lights: Lights = { symbols: [[symbol(word), tension], [symbol(elsewhere), gravity]], marks: [] };

test("an arrow speaks of its symbol, and lights its reaction on the other body", () => {
  const lit = pointedAt(lights, marked("force rope.left"));
  expect(lit).toBe(tension);
  expect(isMarkLit("force rope.left", lit)).toBe(true);
  expect(isMarkLit("force rope.right", lit)).toBe(false);
  expect(isMarkLit("body pulley", lit)).toBe(true);
});

test("a weight is one arrow, though g stands in several", () => {
  const lit = pointedAt(lights, marked("force weight.left"));
  expect(isMarkLit("force weight.left", lit)).toBe(true);
  expect(isMarkLit("force weight.right", lit)).toBe(false);
  expect(isLit(gravity, lit)).toBe(true);
});

test("the symbol under the pointer comes before the arrow whose label it is", () => {
  expect(pointedAt(lights, word)).toBe(tension);
});

test("a body lights its own symbols, and no arrow", () => {
  const lit = pointedAt(lights, marked("body left"));
  expect(isLit(tension, lit)).toBe(true);
  expect(isMarkLit("body left", lit)).toBe(true);
  expect(isMarkLit("force rope.left", lit)).toBe(false);
});

test("nothing is lit where nothing is pointed at", () => {
  expect(isLit(tension, null)).toBe(false);
  expect(isMarkLit("body left", null)).toBe(false);
});

test("a symbol is called by its letter with the index below, as it stands in the formula", () => {
  const parts = (...texts: string[]) => ({ children: texts.map((textContent) => ({ textContent })) }) as unknown as Element;
  const force = { symbol: "Nfs", bodies: [], owner: "", forces: [] };
  const found = named({ symbols: [[parts("N", "fs"), force], [parts(), gravity]], marks: [] });
  expect(found.map(({ letter, below }) => [letter, below])).toEqual([["N", "fs"], ["g", ""]]);
});
