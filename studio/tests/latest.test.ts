import { afterEach, expect, test, vi } from "vitest";
import { Latest } from "../src/latest";

afterEach(() => vi.unstubAllGlobals());

test("of what comes while one piece runs the last one is done", async () => {
  const done: string[] = [], latest = new Latest();
  let release = () => {};
  latest.run(() => new Promise<void>((resolve) => (release = resolve)).then(() => void done.push("first")));
  latest.run(async () => void done.push("second"));
  latest.run(async () => void done.push("third"));
  release();
  await vi.waitFor(() => expect(done).toEqual(["first", "third"]));
});

test("what waits is done also after a piece that fails, and the failure is told", async () => {
  const told: unknown[] = [], done: string[] = [], latest = new Latest();
  vi.stubGlobal("reportError", (error: unknown) => told.push(error));
  let fail = (_error: Error) => {};
  latest.run(() => new Promise<void>((_resolve, reject) => (fail = reject)));
  latest.run(async () => void done.push("next"));
  fail(new Error("no"));
  await vi.waitFor(() => expect(done).toEqual(["next"]));
  expect(told).toEqual([new Error("no")]);
});

test("what runs is abandoned when the next comes, unless that has taken its place already", () => {
  let n = 0;
  const latest = new Latest(() => (n += 1)), forever = () => new Promise<void>(() => undefined);
  latest.run(forever);
  expect(n).toBe(0);
  latest.run(forever, true);
  expect(n).toBe(0);
  latest.run(forever);
  expect(n).toBe(1);
  latest.stop();
  expect([n, latest.isWaiting]).toEqual([2, false]);
});
