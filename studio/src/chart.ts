// A plot of lines over one axis, as all of the page look.
import { untrack } from "svelte";
import uPlot from "uplot";
import { extent, leastSpan } from "./plane";
import { local, round, unitPrinted } from "./text";
import type { Line } from "./wire";

export interface Look {
  ink: string;
  grid: string;
  lines: string[];
  now: string;
  warning: string;
}

/** The colours of the theme as it is. */
function look(): Look {
  const style = getComputedStyle(document.documentElement), of = (name: string) => style.getPropertyValue(name).trim();
  return { ink: of("--muted"), grid: of("--faint"), lines: Array.from({ length: 7 }, (_, k) => of(`--body-${k}`)), now: of("--accent"), warning: of("--warning") };
}

/** A symbol as it is printed, and its name for those who hear it. */
export const typeset = (math: string, name: string) => `<span aria-hidden="true"><math>${math}</math></span><span class="unseen">${name}</span>`;
/** A name with its unit, where it has one. */
export const called = (name: string, unit: string) => (unit && unit !== "1" ? `${name} [${unitPrinted(unit)}]` : name);

/** lines: of one unit; size: of the picture [m], beside which round-off is nothing; across: what the axis is called, where
 * that is not plain; sync: plots of the same share their cursor; draw: what comes on top */
export interface Shown {
  x: number[];
  lines: Line[];
  unit: string;
  language: string;
  size: () => number;
  height: number;
  across?: string;
  sync?: string;
  draw(plot: uPlot, look: Look): void;
}

export function chart(into: HTMLElement, { x, lines, unit, language, size, height, across, sync, draw }: Shown): uPlot {
  const colors = look(), font = "11px system-ui", least = () => untrack(() => leastSpan(unit, size()));
  const written = (_plot: uPlot, at: number[]) => at.map((value) => local(String(round(value)), language));
  const axis = { stroke: colors.ink, grid: { stroke: colors.grid, width: 1 }, ticks: { stroke: colors.grid, width: 1 }, font, labelSize: 16, labelFont: font, values: written };
  const plot = new uPlot(
    {
      width: into.clientWidth, height,
      cursor: { ...(sync ? { sync: { key: sync } } : {}), drag: { x: false, y: false } },
      // round-off fills no picture
      scales: { x: { time: false }, y: { range: (_plot, low, high) => (high - low > least() ? uPlot.rangeNum(low, high, 0.1, true) : extent([low, high], least())) } },
      legend: { live: false },
      axes: [{ ...axis, size: 30, ...(across ? { label: across } : {}) }, { ...axis, size: 56, label: unit === "1" ? "" : unitPrinted(unit) }],
      series: [{ label: across ?? "t" }, ...lines.map((line, k) => ({ label: line.name, stroke: colors.lines[k % colors.lines.length]!, width: 1.6, dash: [[], [6, 3], [2, 2], [8, 3, 2, 3]][k % 4]!, spanGaps: false }))],
      hooks: { draw: [(plot) => draw(plot, colors)] },
    },
    dataOf(x, lines), into,
  );
  const labels = plot.root.querySelectorAll(".u-legend .u-series .u-label");
  lines.forEach(({ math, name }, k) => {
    const label = labels[labels.length - lines.length + k]; // what lies across may have none
    if (math && label) label.innerHTML = typeset(math, name);
  });
  return plot;
}

export function dataOf(x: number[], lines: Line[]): uPlot.AlignedData {
  return [x, ...lines.map((line) => line.values)] as uPlot.AlignedData;
}

/** A line from the top to the bottom, or as far as `part` of that from the bottom. */
export function upright(plot: uPlot, at: number, color: string, part = 1): void {
  const x = plot.valToPos(at, "x", true), { top, height } = plot.bbox;
  plot.ctx.save();
  plot.ctx.setLineDash([]);
  plot.ctx.strokeStyle = color;
  plot.ctx.lineWidth = 1.5 * devicePixelRatio;
  plot.ctx.beginPath();
  plot.ctx.moveTo(x, top + (1 - part) * height);
  plot.ctx.lineTo(x, top + height);
  plot.ctx.stroke();
  plot.ctx.restore();
}

/** Lets plots fill the width of what they stand in, for as long as they are there. */
export function filling(into: HTMLElement, plots: uPlot[], height: number): () => void {
  // another size of the plots may be another one of what is watched, so it waits for the next frame
  const observer = new ResizeObserver(() => requestAnimationFrame(() => plots.forEach((plot) => plot.setSize({ width: into.clientWidth, height }))));
  observer.observe(into);
  return () => {
    observer.disconnect();
    plots.forEach((plot) => plot.destroy());
  };
}
