// Pictures follow the theme of the system; in the studio they follow that of the page.

/** HTML in which the pictures' rules for dark screens hold always, or never. */
export function inTheme(html: string, theme: "light" | "dark"): string {
  const rule = theme === "dark" ? "@media screen{" : "@media not all{";
  return html.replaceAll("@media screen and (prefers-color-scheme:dark){", rule);
}

/** A picture that knows how wide and how high it may become, at most so many times as it is: letters of 9 pt stay letters
    in a picture of one small body. */
export const bounded = (svg: string, most: number): string =>
  svg.replace(/<svg ([^>]*viewBox="0 0 ([\d.]+) ([\d.]+)")/g, (_all, head: string, wide: string, tall: string) =>
    `<svg style="--wide: ${(most * Number(wide)).toFixed(0)}pt; --tall: ${(most * Number(tall)).toFixed(0)}pt" ${head}`);
