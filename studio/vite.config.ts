import { createHash } from "node:crypto";
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { join, relative, resolve } from "node:path";
import { svelte } from "@sveltejs/vite-plugin-svelte";
import type { Plugin } from "vite";
import { defineConfig } from "vitest/config";

const player = resolve(__dirname, "../src/freebody/present/player.js");

/** The drawer of the player page, as a module: there is one for pages, notebooks and the studio. */
function drawer(): Plugin {
  return {
    name: "drawer",
    resolveId: (id) => (id === "virtual:player" ? "\0player" : null),
    load(id) {
      if (id !== "\0player") return null;
      this.addWatchFile(player);
      return `${readFileSync(player, "utf-8")}\nexport { playerOn };`;
    },
  };
}

const own = ["src", "index.html", "package.json", "package-lock.json", "vite.config.ts", "svelte.config.js", "tsconfig.json"];

function filesOf(path: string): string[] {
  return statSync(path).isDirectory() ? readdirSync(path).flatMap((name) => filesOf(join(path, name))) : [path];
}

/** A digest of all that the page is built from; a test of the Python side finds the same, or the page is not current. */
function digest(): string {
  const files = [...own.flatMap((name) => filesOf(resolve(__dirname, name))), player];
  const named = files.map((path) => [relative(resolve(__dirname, ".."), path).replaceAll("\\", "/"), path] as const);
  const hash = createHash("sha256");
  for (const [name, path] of named.sort(([a], [b]) => (a < b ? -1 : 1))) {
    hash.update(`${name}\n`);
    hash.update(readFileSync(path, "utf-8").replaceAll("\r\n", "\n"));
  }
  return hash.digest("hex");
}

/** What comes with the page: the licences of what is built into it, and the digest of its sources. */
function papers(): Plugin {
  return {
    name: "papers",
    generateBundle(_options, bundle) {
      const modules = Object.values(bundle).flatMap((part) => (part.type === "chunk" ? Object.keys(part.modules) : []));
      const packages = new Set(modules.map((id) => /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(id)?.[1]).filter((name) => name !== undefined));
      const texts = [...packages].sort().map((name) => {
        const folder = resolve(__dirname, "node_modules", name);
        const { version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf-8")) as { version: string; license: string };
        const file = readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
        const text = file && existsSync(join(folder, file)) ? readFileSync(join(folder, file), "utf-8").trim() : "";
        return `${name} ${version} (${license})\n\n${text}\n`;
      });
      this.emitFile({ type: "asset", fileName: "LICENSES.txt", source: texts.join(`\n${"-".repeat(80)}\n\n`) });
      this.emitFile({ type: "asset", fileName: "sources.sha256", source: `${digest()}\n` });
    },
  };
}

export default defineConfig({
  plugins: [drawer(), svelte(), papers()],
  resolve: process.env.VITEST ? { conditions: ["browser"] } : {},
  build: {
    outDir: "../src/freebody/studio/page",
    emptyOutDir: true,
    target: "es2022",
    cssCodeSplit: false,
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
    rollupOptions: {
      output: {
        entryFileNames: "studio.js",
        assetFileNames: "studio[extname]",
        inlineDynamicImports: true,
      },
    },
  },
});
