declare module "virtual:player" {
  import type { OverlaysAnswer } from "./wire";
  /** What the page around a player decides; it is asked at every drawing. */
  export interface Shown {
    traced: Set<number>;
    selected: Set<number>;
    isDark(): boolean;
    hasNames(): boolean;
    isPlaying(): boolean;
    isHeld(): boolean;
    head: number;
    axes(length: number): string;
    overlays(): { found: OverlaysAnswer; isStale: boolean } | null;
    quantity(value: number, unit: string): string;
    hasGhosts(): boolean;
    lit(arrow: { of: string; owner: string }): boolean;
    drawn(frame: number, time: number): void;
  }
  export type Place = [number, number, number];
  export interface Player {
    draw(): void;
    measure(): void;
    show(data: Record<string, unknown>, frame?: number): void;
    begin(columns: number[]): void;
    go(frame: number): void;
    turn(azimuth: number, elevation: number): void;
    zoom(factor: number): void;
    move(right: number, down: number): void;
    resetView(): void;
    pick(at: [number, number]): number | null;
    place(at: [number, number], depth?: number): Place;
    depth(at: [number, number]): number;
    held(name: string): { spot: [number, number]; depth: number }[];
    sides(): [Place, Place];
    at(): number;
    last(): number;
  }
  export function playerOn(canvas: HTMLCanvasElement, data: Record<string, unknown>, shown: Shown): Player;
}
