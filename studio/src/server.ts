// What is asked of the server: with the token of the address, and in the schema of `wire.ts`.
import type { Answers, Example, OpenedFile, Opening, Reply, Requests, SaveAnswer, SaveRequest } from "./wire";

const token = new URLSearchParams(location.hash.slice(1)).get("token") ?? "";

/** Why there is no answer: the server is gone, or refuses this page. */
export class Unreachable extends Error {}

async function post<T>(name: string, body: unknown): Promise<T> {
  let response: Response;
  try {
    response = await fetch(`/api/${name}`, {
      method: "POST",
      headers: { "Content-Type": "application/json", Authorization: `Bearer ${token}` },
      body: JSON.stringify(body),
    });
  } catch {
    throw new Unreachable("the server does not answer");
  }
  if (response.ok) return (await response.json()) as T;
  const text = await response.text();
  let message = text;
  try {
    message = (JSON.parse(text) as { message: string }).message;
  } catch {
    // it is no JSON: the text itself
  }
  throw new Unreachable(message || `${response.status}`);
}

export type Told<K extends keyof Answers> = Omit<Reply, "answer"> & { answer: Answers[K] | null };

export function ask<K extends keyof Requests>(kind: K, request: Requests[K], topic: string = kind): Promise<Told<K>> {
  return post("ask", { kind, topic, request });
}
export const cancel = (topic: string) => post<object>("cancel", { topic });
export const busy = () => post<Record<string, string>>("busy", {});
export const open = () => post<Opening>("open", {});
export const openFile = (name: string) => post<OpenedFile>("file", { name });
export const save = (request: SaveRequest) => post<SaveAnswer>("save", request);
export const examples = () => post<Example[]>("examples", {});
export const schema = () => post<Record<string, unknown>>("schema", {});
