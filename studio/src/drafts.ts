// Texts that are not saved. Each window keeps its own, so that none writes over what was typed in another one.
import { kept, keptByWindow } from "./kept";

/** What a window that is gone has left. */
export interface Draft {
  key: string;
  text: string;
}

const navigation = performance.getEntriesByType("navigation")[0] as PerformanceNavigationTiming | undefined;
/** Whether this window has shown the page before, and finds all as it was. A copy of a window is another one. */
export const isReloaded = navigation?.type === "reload";
const own = (isReloaded && keptByWindow.get("window")) || Math.random().toString(36).slice(2);
keptByWindow.set("window", own);
// as long as this window lives it has a lock of its name, by which the others know it; in a
// frame of a notebook there are none
void navigator.locks?.request(`freebody.${own}`, () => new Promise(() => undefined)).catch(() => undefined);

const keyOf = (window: string, file: string) => `draft.${window}.${file}`;

function read(key: string): { at: number; text: string } | null {
  try {
    return JSON.parse(kept.get(key) ?? "null") as { at: number; text: string } | null;
  } catch {
    return null;
  }
}

/** Null: there is nothing that is not saved. */
export function keep(file: string, text: string | null): void {
  kept.set(keyOf(own, file), text === null ? null : JSON.stringify({ at: Date.now(), text }));
}
/** What this window has kept of a file. */
export const ownOf = (file: string): string | null => read(keyOf(own, file))?.text ?? null;

/** What windows that are gone have kept of a file, the latest first, where it is not this text. */
export async function left(file: string, text: string): Promise<Draft[]> {
  const locks = (await navigator.locks?.query().catch(() => null))?.held ?? [];
  const living = new Set([own, ...locks.map((lock) => lock.name?.slice("freebody.".length))]);
  const found = kept.keys("draft.").flatMap((key) => {
    const window = key.split(".")[1]!, draft = key === keyOf(window, file) && !living.has(window) ? read(key) : null;
    return draft && draft.text !== text ? [{ key, ...draft }] : [];
  });
  return found.sort((a, b) => b.at - a.at);
}
export const drop = (draft: Draft) => kept.set(draft.key, null);
