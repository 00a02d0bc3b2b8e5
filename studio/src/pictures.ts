// Pictures follow the theme of the system; in the studio they follow that of the page.

/** HTML in which the pictures' rules for dark screens hold always, or never. */
export function inTheme(html: string, theme: "light" | "dark"): string {
  const rule = theme === "dark" ? "@media screen{" : "@media not all{";
  return html.replaceAll("@media screen and (prefers-color-scheme:dark){", rule);
}

/** The most that a picture is enlarged: letters of 9 pt stay letters in a picture of one small body. */
const MOST = 1.8;

/** A picture that knows how wide and how high it may become. */
export const bounded = (svg: string): string =>
  svg.replace(/<svg ([^>]*viewBox="0 0 ([\d.]+) ([\d.]+)")/g, (_all, head: string, wide: string, tall: string) =>
    `<svg style="--wide: ${(MOST * Number(wide)).toFixed(0)}pt; --tall: ${(MOST * Number(tall)).toFixed(0)}pt" ${head}`);
