// Pictures follow the theme of the system; in the studio they follow that of the page.

/** HTML in which the pictures' rules for dark screens hold always, or never. */
export function inTheme(html: string, theme: "light" | "dark"): string {
  const rule = theme === "dark" ? "@media screen{" : "@media not all{";
  return html.replaceAll("@media screen and (prefers-color-scheme:dark){", rule);
}
