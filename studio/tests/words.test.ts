import { expect, test } from "vitest";
import { Latest } from "../src/latest";
import { WORDS } from "../src/words";

test("every word is said in every language", () => {
  expect(Object.keys(WORDS.de).sort()).toEqual(Object.keys(WORDS.en).sort());
  for (const words of Object.values(WORDS)) for (const word of Object.values(words)) expect(word.trim()).not.toBe("");
});

test("of work that comes while other work runs the last is done", async () => {
  const latest = new Latest(), done: number[] = [];
  let release = () => {};
  const gate = new Promise<void>((resolve) => (release = resolve));
  latest.run(async () => { await gate; done.push(1); });
  latest.run(async () => { done.push(2); });
  latest.run(async () => { done.push(3); });
  release();
  await new Promise((resolve) => setTimeout(resolve, 10));
  expect(done).toEqual([1, 3]);
});
