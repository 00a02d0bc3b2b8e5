import { expect, test } from "vitest";
import { bounded } from "../src/pictures";

test("a picture knows how large it may become, each by itself", () => {
  const svg = (wide: number) => `<svg class="a" viewBox="0 0 ${wide}.0 50.0" width="1pt"><path/></svg>`;
  expect(bounded(svg(100) + svg(200), 1.8).match(/--wide: \d+pt; --tall: \d+pt/g)).toEqual(["--wide: 180pt; --tall: 90pt", "--wide: 360pt; --tall: 90pt"]);
});
