// The page in a notebook: `freebody/studio/widget.js` shows it in a frame and passes on what it asks the kernel.

/** How the page begins in a notebook; null elsewhere. */
export const notebook = JSON.parse(document.getElementById("notebook")?.textContent ?? "null") as { until: number; language: "en" | "de" } | null;

const view = Math.random(); // several views of one widget hear all answers
const waiting = new Map<number, (answer: unknown) => void>();
let count = 0;

/** The answer of the kernel. */
export function fromKernel<T>(name: string, body: unknown): Promise<T> {
  return new Promise((resolve) => {
    waiting.set(++count, resolve as (answer: unknown) => void);
    parent.postMessage({ id: [view, count], name, body }, "*");
  });
}

/** The kernel has the text of the page from now on, and the page that of the kernel. */
export const tellText = (text: string) => parent.postMessage({ text }, "*");
export function hearText(take: (text: string) => void): void {
  addEventListener("message", ({ source, data }: MessageEvent<{ text?: string }>) => {
    if (source === parent && data.text !== undefined) take(data.text);
  });
}

if (notebook)
  addEventListener("message", ({ source, data }: MessageEvent<{ id?: [number, number]; answer?: unknown }>) => {
    if (source !== parent || data.id?.[0] !== view) return;
    waiting.get(data.id[1])?.(data.answer);
    waiting.delete(data.id[1]);
  });
