/** Themes: which values the design tokens have. */

import { t } from "../words/words";

export const themes = ["light", "dark", "contrast"] as const;
export type Theme = (typeof themes)[number];

export const themeNames: Record<Theme, string> = {
  light: t("Light"),
  dark: t("Dark"),
  contrast: t("High contrast"),
};

const key = "kerf.theme";

/** The theme chosen in this browser; else the one the system asks for. */
export function rememberedTheme(): Theme {
  const kept = themes.find((theme) => theme === localStorage.getItem(key));
  if (kept) return kept;
  if (matchMedia("(prefers-contrast: more)").matches) return "contrast";
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

export function applyTheme(theme: Theme): void {
  document.documentElement.dataset.theme = theme;
  localStorage.setItem(key, theme);
}
