// What is asked of the server: with the token of the address, and in the schema of `wire.ts`.
import { fromKernel, notebook } from "./notebook";
import type { Answers, Example, Moved, OpenedFile, Opening, Reply, Requests, SaveAnswer, SaveRequest } from "./wire";

/** A page that was written to be shared has its answers with it, and no server. */
interface Kept {
  opening: Opening;
  replies: Record<string, Reply>;
  moved: Moved | null;
}
const kept = JSON.parse(document.getElementById("kept")?.textContent ?? "null") as Kept | null;
export const isShared = kept !== null;
export const sliders = kept?.moved?.sliders ?? [];
const isAlone = isShared || notebook !== null; // without a server

/** By what an answer is kept: the kind of the request, and what it says beside the text. */
function keyOf(kind: string, request: object): string {
  const beside = new Set(["text", "language", "prefix", "until", "frames"]);
  return JSON.stringify([kind, request], (name, value: unknown) => {
    if (typeof value !== "object" || value === null || Array.isArray(value)) return value;
    const entries = Object.entries(value).filter(([key, each]) => each !== undefined && !(name === "1" && beside.has(key)));
    return Object.fromEntries(entries.sort(([a], [b]) => (a < b ? -1 : 1)));
  });
}

/** What this window asks about: of what another one asks nothing is replaced or ended. */
const window_ = Math.random().toString(36).slice(2);
const ownOf = (topic: string) => `${topic}.${window_}`;
const token = new URLSearchParams(location.hash.slice(1)).get("token") ?? "";

// the address of another start of the studio: the same page, with another token
addEventListener("hashchange", () => location.reload());

/** Why there is no answer. status: of HTTP; 0 where the server is gone */
export class Unreachable extends Error {
  constructor(readonly status: number, message = "") {
    super(message);
  }
}

async function post<T>(name: string, body: unknown): Promise<T> {
  if (notebook) return fromKernel<T>(name, body);
  let response: Response;
  try {
    response = await fetch(`/api/${name}`, {
      method: "POST",
      headers: { "Content-Type": "application/json", Authorization: `Bearer ${token}` },
      body: JSON.stringify(body),
    });
  } catch {
    throw new Unreachable(0);
  }
  if (response.ok) return (await response.json()) as T;
  const text = await response.text();
  let message = text;
  try {
    message = (JSON.parse(text) as { message: string }).message;
  } catch {
    // it is no JSON: the text itself
  }
  throw new Unreachable(response.status, message || `${response.status}`);
}

export type Told<K extends keyof Answers> = Omit<Reply, "answer"> & { answer: Answers[K] | null };

let nAsked = 0; // requests of this window
export function ask<K extends keyof Requests>(kind: K, request: Requests[K], topic: string = kind): Promise<Told<K>> {
  if (kept) {
    const found = kept.replies[keyOf(kind, request)];
    return Promise.resolve((found ?? { status: "refused", message: "" }) as Told<K>);
  }
  return post<Told<K>>("ask", { kind, topic: ownOf(topic), request, number: ++nAsked }).then((told) => (told.status === "later" ? promised(told.message) : told) as Promise<Told<K>> | Told<K>);
}

// Answers that take their time, by number: one request of this window brings them all. One may come before its promise.
const awaited = new Map<string, { resolve(reply: Reply): void; reject(error: unknown): void }>(), early = new Map<string, Reply>();
let isCollecting = false;
function promised(number: string): Promise<Reply> {
  const reply = early.get(number);
  early.delete(number);
  if (reply) return Promise.resolve(reply);
  return new Promise((resolve, reject) => {
    awaited.set(number, { resolve, reject });
    if (!isCollecting) void collect();
  });
}
async function collect(): Promise<void> {
  isCollecting = true;
  try {
    while (awaited.size) {
      for (const [number, reply] of Object.entries(await post<Record<string, Reply>>("later", { window: window_ }))) {
        if (awaited.has(number)) awaited.get(number)!.resolve(reply);
        else early.set(number, reply);
        awaited.delete(number);
      }
    }
  } catch (error) {
    for (const each of awaited.values()) each.reject(error);
    awaited.clear();
  } finally {
    isCollecting = false;
  }
}
const caseOf = (places: number[]) => sliders.reduce((before, slider, k) => before * slider.values.length + places[k]!, 0);
/** The answers to the questions of the file at places of the sliders of a shared page. */
export function answersAt(places: number[]): { id: string; text: string; value: string }[] {
  const at = caseOf(places);
  return (kept?.moved?.answers ?? []).map(({ id, text, values }) => ({ id, text, value: values[at]! }));
}
/** The motion there, and its curves. */
export function movedTo(places: number[]): { motion: Told<"motion">; curves: Told<"curves"> } {
  const at = caseOf(places), curves = kept!.moved!.curves[at] as Told<"curves">;
  const motion = kept!.moved!.replies[at] as Told<"motion">;
  if (!motion.answer) return { motion, curves };
  const own = kept!.replies[keyOf("motion", {})]!.answer as Answers["motion"];
  return { motion: { ...motion, answer: { ...motion.answer, player: { ...own.player, ...motion.answer.player } } }, curves };
}
export const cancel = (topic: string) => post<object>("cancel", { topic: ownOf(topic) });
/** Nobody looks any more at what was asked under a topic until now, so that nothing else waits for it. */
export const leave = (topic: string) => isAlone ? Promise.resolve({}) : post<object>("leave", { topic: ownOf(topic), number: nAsked }).catch(() => ({}));
/** With what that is busy which is asked under a topic. */
export const busy = (topic: string) => isAlone ? Promise.resolve("") : post<Record<string, string>>("busy", {}).then((all) => all[ownOf(topic)] ?? "");
export const open = () => kept ? Promise.resolve(kept.opening) : post<Opening>("open", {});
export const openFile = (name: string) => post<OpenedFile>("file", { name });
export const save = (request: SaveRequest) => post<SaveAnswer>("save", request);
export const examples = () => post<Example[]>("examples", {});
